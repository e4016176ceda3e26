// SPDX-License-Identifier: GPL-2.0-only
// The test of the tests: clmp with one style more, contactlaws/hill/negated, whose history LAMMPS transfers by its default,
// negating every value. A test of bridges across ranks must find it wrong.
#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "pair_contactlaws.hpp"

namespace {

using namespace contactlaws;

struct Negated : PairContactLaws<Hill<double>> {
  explicit Negated(LAMMPS_NS::LAMMPS* lammps) : PairContactLaws<Hill<double>>(lammps) {
    nondefault_history_transfer = 0;
  }
};
LAMMPS_NS::Pair* create(LAMMPS_NS::LAMMPS* lammps) { return new Negated(lammps); }

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    (*lammps.force->pair_map)["contactlaws/hill/negated"] = create;
    lammps.input->file();
  }
  MPI_Finalize();
}

// SPDX-License-Identifier: GPL-2.0-only
// The test of the tests: clmp with two styles more, contactlaws/hill/negated and contactlaws/cohesive_powder/negated, whose
// history LAMMPS transfers by its default, negating every value. Tests of contacts across ranks must find them wrong.
#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "pair_contactlaws.hpp"

namespace {

using namespace contactlaws;

template <class Parameters>
struct Negated : PairContactLaws<Parameters> {
  explicit Negated(LAMMPS_NS::LAMMPS* lammps) : PairContactLaws<Parameters>(lammps) {
    this->nondefault_history_transfer = 0;
  }
};
template <class Parameters>
LAMMPS_NS::Pair* create(LAMMPS_NS::LAMMPS* lammps) {
  return new Negated<Parameters>(lammps);
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    auto& styles = *lammps.force->pair_map;
    styles["contactlaws/hill/negated"] = create<Hill<double>>;
    styles["contactlaws/cohesive_powder/negated"] = create<CohesivePowderProperties<double>>;
    lammps.input->file();
  }
  MPI_Finalize();
}

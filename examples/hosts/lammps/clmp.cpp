// SPDX-License-Identifier: GPL-2.0-only
// `lmp` with the contactlaws pair styles built in, for a liblammps without plugins (Debian's).
#include <mpi.h>

#include "force.h"
#include "input.h"
#include "lammps.h"
#include "lammpsplugin.h"

namespace {

void add_style(lammpsplugin_t* plugin, void* lammps) {
  LAMMPS_NS::Force* force = static_cast<LAMMPS_NS::LAMMPS*>(lammps)->force;
  (*force->pair_map)[plugin->name] = reinterpret_cast<LAMMPS_NS::Force::PairCreator>(plugin->creator.v1);
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  {
    LAMMPS_NS::LAMMPS lammps(argc, argv, MPI_COMM_WORLD);
    lammpsplugin_init(&lammps, nullptr, reinterpret_cast<void*>(&add_style));
    lammps.input->file();
  }
  MPI_Finalize();
}

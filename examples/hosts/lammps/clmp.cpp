// SPDX-License-Identifier: GPL-2.0-only
// `lmp` with the pair styles and walls of contactlaws built in, for a liblammps without plugins (Debian's).
#include <mpi.h>

#include <exception>
#include <string>

#include "force.h"
#include "input.h"
#include "lammps.h"
#include "lammpsplugin.h"
#include "modify.h"

namespace {

void add_style(lammpsplugin_t* plugin, void* pointer) {
  LAMMPS_NS::LAMMPS* lammps = static_cast<LAMMPS_NS::LAMMPS*>(pointer);
  if (plugin->style == std::string("fix")) {
    (*lammps->modify->fix_map)[plugin->name] = reinterpret_cast<LAMMPS_NS::Modify::FixCreator>(plugin->creator.v2);
  } else {
    (*lammps->force->pair_map)[plugin->name] = reinterpret_cast<LAMMPS_NS::Force::PairCreator>(plugin->creator.v1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  try {
    // Not destroyed after an error: it is in no state to be.
    LAMMPS_NS::LAMMPS* lammps = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
    lammpsplugin_init(lammps, nullptr, reinterpret_cast<void*>(&add_style));
    lammps->input->file();
    delete lammps;
  } catch (const std::exception&) {  // since 2023 LAMMPS prints its error and throws
    MPI_Abort(MPI_COMM_WORLD, 1);
  }
  MPI_Finalize();
}

// SPDX-License-Identifier: GPL-2.0-only
// LAMMPS's fix NEIGH_HISTORY, which keeps the histories of contacts, with the sums of the pair style: restart files hold both. LAMMPS
// lets rank 0 alone write the part of a pair style, but all ranks write that of a fix, so that their sums can be added.
#pragma once

#include <cstdio>
#include <cstring>

#include "comm.h"
#include "fix_neigh_history.h"
#include "lammps.h"
#include "modify.h"

namespace contactlaws {

/// What contacts have added since the start. This rank's share; rank 0 goes on with all that a restart file holds.
struct ContactSums {
  double friction = 0.0, dashpots = 0.0;  ///< heat [J]
  double yielding = 0.0;                  ///< heat, of contacts that have opened [J]
  double returned = 0.0;                  ///< liquid [m^3]
};

class FixContactHistory : public LAMMPS_NS::FixNeighHistory {
 public:
  static constexpr const char* style_name = "CONTACTLAWS_HISTORY";
  using FixNeighHistory::FixNeighHistory;

  static void offer(LAMMPS_NS::LAMMPS* lammps) {
    (*lammps->modify->fix_map)[style_name] = [](LAMMPS_NS::LAMMPS* of, int count, char** words) -> LAMMPS_NS::Fix* {
      return new FixContactHistory(of, count, words);
    };
  }

  void write_restart(FILE* file) override {
    pre_exchange();  // as FixNeighHistory: into the arrays that go into the file
    ContactSums all;
    const int bytes = sizeof(all);
    MPI_Reduce(&sums, &all, bytes / int(sizeof(double)), MPI_DOUBLE, MPI_SUM, 0, world);
    if (comm->me != 0) return;
    std::fwrite(&bytes, sizeof(bytes), 1, file);
    std::fwrite(&all, sizeof(all), 1, file);
  }
  void restart(char* values) override {
    if (comm->me == 0) std::memcpy(&sums, values, sizeof(sums));
  }

  ContactSums sums;
};

}  // namespace contactlaws

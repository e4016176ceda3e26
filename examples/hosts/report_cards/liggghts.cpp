// SPDX-License-Identifier: GPL-2.0-only
// LIGGGHTS's own laws under the checks of contactlaws/verify: two particles in an unmodified LIGGGHTS, whose positions,
// velocities and history are set before each force computation.
//
//   report_card_liggghts FOLDER         a JSON line for each law and property; the paths of failures in FOLDER
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

#include <mpi.h>

#include "lammps.h"

#include "atom.h"
#include "force.h"
#include "input.h"
#include "neigh_list.h"
#include "pair_gran.h"
#include "universe.h"
#include "update.h"

#include "contactlaws/verify/verify.hpp"
#include "examples/hosts/report_cards/report_card.hpp"

namespace {

using namespace contactlaws;
using verify::Vector;

struct Model {
  std::string title;
  std::string pair_style;
  double restitution;
};

/// A LIGGGHTS with two particles of E = 29 GPa, nu = 0.15, mu = 0.4.
class TwoParticles {
 public:
  explicit TwoParticles(const Model& model) {
    const char* arguments[] = {"liggghts", "-log", "none", "-screen", "none"};
    lammps_ = new LAMMPS_NS::LAMMPS(5, const_cast<char**>(arguments), MPI_COMM_WORLD);
    const std::string restitution = std::to_string(model.restitution);
    for (const std::string& line :
         std::vector<std::string>{"units si",
                                  "atom_style granular",
                                  "atom_modify map array",
                                  "boundary f f f",
                                  "newton off",
                                  "communicate single vel yes",
                                  "hard_particles yes",
                                  "region box block -0.05 0.05 -0.05 0.05 -0.05 0.05 units box",
                                  "create_box 1 box",
                                  "create_atoms 1 single 0 0 0 units box",
                                  "create_atoms 1 single 0 0 0.0125 units box",
                                  "group bot id 1",
                                  "group top id 2",
                                  "set group bot diameter 0.015 density 2650",
                                  "set group top diameter 0.010 density 2650",
                                  "fix m1 all property/global youngsModulus peratomtype 29e9",
                                  "fix m2 all property/global poissonsRatio peratomtype 0.15",
                                  "fix m3 all property/global coefficientRestitution peratomtypepair 1 " + restitution,
                                  "fix m4 all property/global coefficientFriction peratomtypepair 1 0.4",
                                  "fix m5 all property/global characteristicVelocity scalar 1.0",
                                  "pair_style gran model " + model.pair_style,
                                  "pair_coeff * *",
                                  "neighbor 0.02 bin",
                                  "neigh_modify delay 1000000",
                                  "timestep 1e-6",
                                  "fix move all nve/sphere",
                                  "run 0 post no"})
      lammps_->input->one(line.c_str());
    lammps_->update->setupflag = 0;  // forces of a step, not of the set-up pass
    if (pair().listgranhistory && pair().listgranhistory->firstneigh == nullptr)
      throw std::runtime_error("no history list");
  }
  TwoParticles(const TwoParticles&) = delete;
  TwoParticles& operator=(const TwoParticles&) = delete;
  ~TwoParticles() { delete lammps_; }

  const char* version() const { return lammps_->universe->version; }
  LAMMPS_NS::PairGran& pair() const { return static_cast<LAMMPS_NS::PairGran&>(*lammps_->force->pair); }
  int history_size() const { return pair().dnum(); }

  /// The history as LIGGGHTS hands it over when the pair changes its owner: shear changes its sign.
  void exchange(std::vector<double>& values) const {
    for (double& value : values) value = -value;
  }

  /// One force computation; the history goes in and out by `values`, and `touching` with it.
  verify::Interaction compute(const verify::Bodies& bodies, double dt, std::vector<double>& values,
                              int& touching) const {
    LAMMPS_NS::Atom& atom = *lammps_->atom;
    const verify::Body* both[] = {&bodies.one, &bodies.two};
    for (int i = 0; i < 2; ++i) {
      for (int d = 0; d < 3; ++d) {
        atom.x[i][d] = both[i]->position[d];
        atom.v[i][d] = both[i]->velocity[d];
        atom.omega[i][d] = both[i]->spin[d];
        atom.f[i][d] = atom.torque[i][d] = 0.0;
      }
      atom.radius[i] = both[i]->radius;
      atom.rmass[i] = both[i]->mass;
    }
    LAMMPS_NS::NeighList* list = pair().listgranhistory;
    if (list) {
      list->firstneigh[0][0] = touching;
      std::memcpy(list->firstdouble[0], values.data(), sizeof(double) * values.size());
    }
    lammps_->update->dt = dt;
    pair().reset_dt();
    pair().compute(0, 0);
    if (list) {
      touching = list->firstneigh[0][0];
      std::memcpy(values.data(), list->firstdouble[0], sizeof(double) * values.size());
    }
    const auto vector = [](const double* v) { return Vector(v[0], v[1], v[2]); };
    return {vector(atom.f[1]), vector(atom.f[0]), vector(atom.torque[0]), vector(atom.torque[1])};
  }

 private:
  LAMMPS_NS::LAMMPS* lammps_ = nullptr;
};

void run(const std::string& folder) {
  for (const Model& model : {Model{"hooke, tangential history", "hooke tangential history", 1.0},
                             Model{"hertz, tangential history", "hertz tangential history", 1.0},
                             Model{"hertz, tangential history, e = 0.8", "hertz tangential history", 0.8}}) {
    const TwoParticles host(model);
    verify::Options options = two_grains(0.4);
    options.claims.restitution = model.restitution;
    ReportCard card("LIGGGHTS-PUBLIC 3.8.0", model.title, folder);
    card.check(HostLaw<TwoParticles>{&host}, options);
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int status = contactlaws::run_report_card(argc, argv, run);
  MPI_Finalize();
  return status;
}

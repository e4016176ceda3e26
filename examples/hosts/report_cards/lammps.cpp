// SPDX-License-Identifier: GPL-2.0-only
// LAMMPS's own granular laws under the checks of contactlaws/verify: two particles in an unmodified LAMMPS, whose positions,
// velocities and history are set before each force computation.
//
//   report_card_lammps FOLDER           a JSON line for each style and property; the paths of failures in FOLDER
#include <cmath>
#include <cstring>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <mpi.h>

#include "atom.h"
#include "fix.h"
#include "fix_neigh_history.h"
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "modify.h"
#include "pair.h"
#include "update.h"

#include "contactlaws/timestep.hpp"
#include "contactlaws/verify/verify.hpp"
#include "examples/hosts/report_cards/report_card.hpp"

namespace {

using namespace contactlaws;
using verify::Vector;

/// Where LAMMPS keeps the number of history values; protected there.
struct HistorySize : LAMMPS_NS::FixNeighHistory {
  static int of(const FixNeighHistory& fix) { return fix.*(&HistorySize::dnum); }
};

/// A LAMMPS with two particles and a pair style.
class TwoParticles {
 public:
  explicit TwoParticles(const std::vector<std::string>& style) {
    const char* arguments[] = {"lammps", "-log", "none", "-screen", "none"};
    lammps_ = new LAMMPS_NS::LAMMPS(5, const_cast<char**>(arguments), MPI_COMM_WORLD);
    for (const char* line :
         {"units si", "atom_style sphere", "atom_modify map array", "boundary f f f", "newton off",
          "comm_modify vel yes", "region box block -1 1 -1 1 -1 1", "create_box 1 box", "create_atoms 1 single 0 0 0",
          "create_atoms 1 single 0 0 0.0125", "set atom 1 diameter 0.015 density 2650",
          "set atom 2 diameter 0.010 density 2650", "neighbor 0.02 bin", "neigh_modify delay 1000000"})
      lammps_->input->one(line);
    for (const std::string& line : style) lammps_->input->one(line.c_str());
    lammps_->input->one("run 0 post no");
    for (int i = 0; i < lammps_->modify->nfix; ++i)
      if (std::strcmp(lammps_->modify->fix[i]->style, "NEIGH_HISTORY") == 0)
        history_ = static_cast<LAMMPS_NS::FixNeighHistory*>(lammps_->modify->fix[i]);
    if (history_) size_ = HistorySize::of(*history_);
    lammps_->update->setupflag = 0;  // forces of a step, not of the set-up pass
  }
  TwoParticles(const TwoParticles&) = delete;
  TwoParticles& operator=(const TwoParticles&) = delete;
  ~TwoParticles() { delete lammps_; }

  const char* version() const { return lammps_->version; }
  int history_size() const { return size_; }
  LAMMPS_NS::Pair& pair() const { return *lammps_->force->pair; }

  /// The history as LAMMPS hands it over when the pair changes its owner.
  void exchange(std::vector<double>& values) const {
    if (pair().nondefault_history_transfer) {
      std::vector<double> source = values;
      transfer(pair(), source.data(), values.data(), 0);
    } else {
      for (double& value : values) value = -value;
    }
  }

  /// One force computation; the history goes in and out by `values`, and `touching` with it.
  verify::Interaction compute(const verify::Bodies& bodies, double dt, std::vector<double>& values,
                              int& touching) const {
    place(bodies);
    keep(values, touching);
    lammps_->update->dt = dt;
    pair().reset_dt();
    pair().compute(0, 0);
    fetch(values, touching);
    const LAMMPS_NS::Atom& atom = *lammps_->atom;
    const auto vector = [](const double* v) { return Vector(v[0], v[1], v[2]); };
    return {vector(atom.f[1]), vector(atom.f[0]), vector(atom.torque[0]), vector(atom.torque[1])};
  }
  /// The same as LAMMPS does it before the first step of a run.
  verify::Interaction set_up(const verify::Bodies& bodies, double dt, std::vector<double>& values,
                             int& touching) const {
    lammps_->update->setupflag = 1;
    const auto interaction = compute(bodies, dt, values, touching);
    lammps_->update->setupflag = 0;
    return interaction;
  }
  /// How much a query of the pair force (Pair::single) changes the history, relative to it.
  double history_change_of_query(const verify::Bodies& bodies, double dt, std::vector<double> values,
                                 int touching) const {
    std::vector<double> before = values;
    place(bodies);
    keep(values, touching);
    lammps_->update->dt = dt;
    pair().reset_dt();
    double force = 0.0;
    pair().single(0, 1, 1, 1, bodies.branch().squaredNorm(), 1.0, 1.0, force);
    fetch(values, touching);
    double change = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      change = std::max(change, std::abs(values[i] - before[i]) / (std::abs(before[i]) + 1e-300));
    return change;
  }

 private:
  /// Since 2023 the function takes the types too.
  template <class Pair>
  static auto transfer(Pair& pair, double* from, double* to, int) -> decltype(pair.transfer_history(from, to)) {
    pair.transfer_history(from, to);
  }
  template <class Pair>
  static auto transfer(Pair& pair, double* from, double* to, long) -> decltype(pair.transfer_history(from, to, 1, 1)) {
    pair.transfer_history(from, to, 1, 1);
  }

  void place(const verify::Bodies& bodies) const {
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
  }
  void keep(const std::vector<double>& values, int touching) const {
    if (!history_) return;
    history_->firstflag[0][0] = touching;
    std::memcpy(history_->firstvalue[0], values.data(), sizeof(double) * values.size());
  }
  void fetch(std::vector<double>& values, int& touching) const {
    if (!history_) return;
    touching = history_->firstflag[0][0];
    std::memcpy(values.data(), history_->firstvalue[0], sizeof(double) * values.size());
  }

  LAMMPS_NS::LAMMPS* lammps_ = nullptr;
  LAMMPS_NS::FixNeighHistory* history_ = nullptr;
  int size_ = 0;
};

struct Style {
  std::string title;
  std::vector<std::string> lines;
  double restitution;
  std::string wall;  ///< the same law between a sphere and a wall, mu = 0.5
};

std::string digits(double x) {
  std::ostringstream text;
  text.precision(17);
  text << x;
  return text.str();
}

constexpr double young = 29e9, poisson = 0.15, friction = 0.4;

/// Undamped, so that energy shows what the history alone does; the last ones damped. The wall's 1e-9 is no damping to speak of:
/// with 0 the wall of LAMMPS 4 Feb 2025 divides 0 by 0.
std::vector<Style> styles() {
  const double normal = 4.0 / 3.0 * young / 2 / (1 - poisson * poisson);
  const double shear = 8.0 * young / (4.0 * (2 - poisson) * (1 + poisson));
  const auto hertz = [&](const char* damping, double mu) {
    return digits(normal) + " " + digits(shear) + " " + damping + " 0 " + digits(mu) + " 0";
  };
  const auto granular = [](const char* restitution, const char* tangential, const char* damping, double mu) {
    return "hertz/material " + digits(young) + " " + restitution + " " + digits(poisson) + " tangential " + tangential +
           " NULL 0 " + digits(mu) + " damping " + damping;
  };
  std::vector<Style> all = {{"gran/hooke/history",
                             {"pair_style gran/hooke/history 1e6 8e5 0 0 0.4 0", "pair_coeff * *"},
                             1.0,
                             "hooke/history 1e8 8e7 1e-9 0 0.5 0"},
                            {"gran/hertz/history",
                             {"pair_style gran/hertz/history " + hertz("0", friction), "pair_coeff * *"},
                             1.0,
                             "hertz/history " + hertz("1e-9", 0.5)}};
  const auto add = [&](const std::string& title, const char* restitution, const char* tangential, const char* damping) {
    const std::string pair = granular(restitution, tangential, damping, friction);
    const std::string wall = granular(restitution, tangential, damping, 0.5);
    all.push_back(
        {title, {"pair_style granular", "pair_coeff * * " + pair}, std::stod(restitution), "granular " + wall});
  };
  for (const char* tangential : {"mindlin", "mindlin_rescale", "mindlin/force", "mindlin_rescale/force"})
    add(std::string("granular ") + tangential, "1", tangential, "tsuji");
  add("granular mindlin, e = 0.8", "0.8", "mindlin", "tsuji");
#if __has_include("label_map.h")  // what came with 2023
  add("granular mindlin, e = 0.8, coeff_restitution, limit_damping", "0.8", "mindlin",
      "coeff_restitution limit_damping");
#endif
  return all;
}

/// What a set-up pass and a query between two steps change: relative to the force, of the force and of the history.
void set_up_and_query(ReportCard& card, const TwoParticles& host, const verify::Options& options) {
  const verify::Path path = {{Vector(0, 0, 1), options.overlap, Vector(0.01, 0, -1), options.overlap}};
  verify::Path sheared = path;
  verify::set_normal_velocities(sheared);
  const verify::Bodies bodies = verify::trajectory(sheared, options).front().bodies;
  const HostLaw<TwoParticles> law{&host};
  HostLaw<TwoParticles>::State state = law.start();
  const double dt = sheared.front().dt;
  const Vector once = law(bodies, dt, state).force;
  HostLaw<TwoParticles>::State after = state;
  const Vector in_set_up = host.set_up(bodies, dt, after.values, after.touching).force;
  double history = 0.0;
  for (std::size_t i = 0; i < state.values.size(); ++i)
    history = std::max(history, std::abs(after.values[i] - state.values[i]) / (std::abs(state.values[i]) + 1e-300));
  card.add("set-up pass", std::max((in_set_up - once).norm() / once.norm(), history), 1e-12,
           "of the force, and of the history");
  const double changed = host.history_change_of_query(bodies, dt, state.values, state.touching);
  card.add("query of the force", changed, 0.0, "of the history");
}

/// The largest kinetic energy gained in the impact of a sphere of radius 5 mm on a wall at 1 m/s and 5 to 85 degrees from
/// the normal, relative to that before. LAMMPS's own integrator; 1000 steps in an impact.
double energy_gained_on_wall(const std::string& wall) {
  double worst = 0.0;
  for (int degrees = 5; degrees <= 85; degrees += 2) {
    const char* arguments[] = {"lammps", "-log", "none", "-screen", "none"};
    LAMMPS_NS::LAMMPS lammps(5, const_cast<char**>(arguments), MPI_COMM_WORLD);
    const double radius = 5e-3, angle = degrees * 3.14159265358979324 / 180;
    const ElasticMaterial<double> granite{young, poisson, 2650.0};
    const auto pair = pair_properties(plane(granite), sphere(granite, radius));
    const double duration = impact_duration(pair, std::cos(angle));
    for (const std::string& line :
         {std::string("units si"), std::string("atom_style sphere"), std::string("boundary f f f"),
          std::string("newton off"), std::string("comm_modify vel yes"),
          std::string("region box block -0.05 0.05 -0.05 0.05 -0.01 0.05"), std::string("create_box 1 box"),
          "create_atoms 1 single 0 0 " + digits(radius), std::string("set atom 1 diameter 0.010 density 2650"),
          "velocity all set " + digits(std::sin(angle)) + " 0 " + digits(-std::cos(angle)),
          std::string("pair_style gran/hertz/history 1e9 1e9 0 0 0.5 0"), std::string("pair_coeff * *"),
          std::string("neighbor 0.005 bin"), "timestep " + digits(duration / 1000),
          std::string("fix move all nve/sphere"), "fix wall all wall/gran " + wall + " zplane 0.0 NULL"})
      lammps.input->one(line.c_str());
    const LAMMPS_NS::Atom& atom = *lammps.atom;
    const auto energy = [&atom, radius] {
      const Vector v(atom.v[0][0], atom.v[0][1], atom.v[0][2]), w(atom.omega[0][0], atom.omega[0][1], atom.omega[0][2]);
      return v.squaredNorm() + 0.4 * radius * radius * w.squaredNorm();
    };
    const double before = energy();
    lammps.input->one("run 1500 post no");
    if (!(atom.v[0][2] > 0.0)) throw std::runtime_error("the sphere did not bounce off the wall: " + wall);
    worst = std::max(worst, energy() / before - 1);
  }
  return worst;
}

void run(const std::string& folder) {
  for (const Style& style : styles()) {
    const TwoParticles host(style.lines);
    verify::Options options = two_grains(friction);
    options.claims.restitution = style.restitution;
    ReportCard card("LAMMPS " + std::string(host.version()), style.title, folder);
    card.check(HostLaw<TwoParticles>{&host}, options);
    set_up_and_query(card, host, options);
    if (style.wall.empty()) continue;
    card.add("energy of impacts on a wall", energy_gained_on_wall(style.wall), 1e-4,
             "of the kinetic energy, gained, mu = 0.5");
  }
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int status = contactlaws::run_report_card(argc, argv, run);
  MPI_Finalize();
  return status;
}

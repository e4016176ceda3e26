// SPDX-License-Identifier: MIT
// What a test of one law is told, what it records, and what it keeps from step to step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "sample.hpp"

namespace probe {

enum class Phase { settle, confine, rest, load, hold, unload, done };
inline const std::array<const char*, 7> phase_names{{"settle", "confine", "rest", "load", "hold", "unload", "done"}};

struct TestPlan {
  double pressure = 150e3;     ///< [Pa]
  double settle_time = 0.1;    ///< [s]
  double confine_time = 0.5;   ///< [s]
  double unbalanced = 1e-7;    ///< mean unbalanced force over mean contact force at which rest ends [1]
  double longest_rest = 2.0;   ///< then the probe begins all the same, and says so [s]
  double damping = 0.7;        ///< local, of the forces on grains, platens and cylinder [1]
  double fall_damping = 0.1;   ///< the same in rest, for fall_time, and again after a pause as long [1]
  double fall_time = 0.2;      ///< [s]
  double hold_time = 0.03;     ///< [s]
  double slowest = 1e-8;       ///< speed of the bottom platen [m/s]
  double fastest = 1e-3;       ///< [m/s]
  double strain_slow = 1e-9;   ///< strain up to which it is slowest [1]
  double strain_fast = 1e-4;   ///< strain from which it is fastest [1]
  double most_strain = 1e-3;   ///< axial, at the end of loading [1]
  bool membrane = false;       ///< flexible, in the place of the breathing cylinder
  bool tilts = false;          ///< whether the top platen tilts
  bool unloads = true;         ///< whether hold and unload follow
  int points_per_decade = 20;  ///< of strain
  double safety = 0.6;         ///< share of the stable step
  /// Unbalanced forces, falling, at which the specimen is loaded to `noise_strain`, to see the noise of its modulus. Then it
  /// goes back to the state that it had.
  std::vector<double> noise_levels;
  double noise_strain = 1e-6;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TestPlan, pressure, settle_time, confine_time, unbalanced, longest_rest, damping,
                                   fall_damping, fall_time, hold_time, slowest, fastest, strain_slow, strain_fast,
                                   most_strain, membrane, tilts, unloads, points_per_decade, safety, noise_levels,
                                   noise_strain)

/// Share of a test that is done, from the time that each phase takes; that of rest is a guess.
inline double share_done(const TestPlan& plan, Phase phase, double phase_time, double height) {
  const double growth = std::log(plan.strain_fast / plan.strain_slow) + 1.0;
  const double load = height / plan.fastest * (plan.most_strain + plan.strain_fast * growth);
  const double unload = plan.unloads ? 0.9 * load : 0.0;
  const std::array<double, 7> times{{plan.settle_time, plan.confine_time, 0.15, load, plan.hold_time, unload, 0.0}};
  const auto now = static_cast<std::size_t>(phase);
  double before = 0.0, all = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    all += times[i];
    if (i < now) before += times[i];
  }
  return (before + std::min(times[now], phase_time)) / all;
}

/// One row of a curve.
struct Point {
  double phase_strain;                 ///< since the phase began, > 0 [1]
  double strain;                       ///< since loading began [1]
  double axial, radial;                ///< stress on the platens and on the cylinder [Pa]
  double branch_axial, branch_radial;  ///< stress from branch vectors between grains [Pa]
  double coordination, touching_grains, fabric;
  double contacts, virgin, unloading, reloading;                      ///< numbers
  double virgin_direction, unloading_direction, reloading_direction;  ///< to the horizontal [degrees]
  double force_over_largest, unbalanced;

  double deviator() const { return axial - radial; }
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Point, phase_strain, strain, axial, radial, branch_axial, branch_radial,
                                   coordination, touching_grains, fabric, contacts, virgin, unloading, reloading,
                                   virgin_direction, unloading_direction, reloading_direction, force_over_largest,
                                   unbalanced)
using Curve = std::vector<Point>;

/// The loading of a specimen that was not yet at rest.
struct NoisyProbe {
  double unbalanced;  ///< when it began [1]
  Curve load;
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(NoisyProbe, unbalanced, load)

/// All of a test that changes, apart from scene and clumps.
struct TestState {
  Phase phase = Phase::settle;
  double phase_start = 0.0;      ///< [s]
  double height = 0.0;           ///< before loading [m]
  double start_place = 0.0;      ///< of the bottom platen when the phase began [m]
  double first_place = 0.0;      ///< of the bottom platen when loading began [m]
  double first_deviator = 0.0;   ///< [Pa]
  double next_point = 0.0;       ///< strain of the phase at which a point is due [1]
  double rest_unbalanced = 0.0;  ///< at the end of rest [1]
  double rest_time = 0.0;        ///< [s]
  double voids_ratio = 0.0;      ///< at the end of rest [1]
  double largest_force = 0.0;    ///< of a contact, at the end of loading [N]
  double identity = 0.0;  ///< at the end of rest: axial stress from all contacts over that of the platens, less 1 [1]
  Curve load, unload;
  std::vector<NoisyProbe> noise;
  Sample at_rest;  ///< the grains before loading
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TestState, phase, phase_start, height, start_place, first_place, first_deviator,
                                   next_point, rest_unbalanced, rest_time, voids_ratio, largest_force, identity, load,
                                   unload, noise, at_rest)

}  // namespace probe

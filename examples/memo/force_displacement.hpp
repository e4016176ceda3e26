// SPDX-License-Identifier: MIT
// Stages A and B with the linear and the hill law (Figures 10 and 11), and what the hill law's dashpots add.
#pragma once

#include <string>

#include "expected.hpp"
#include "two_grains.hpp"

namespace memo {

constexpr double no_limit = 1000.0;  ///< a friction so large that nothing slides; the memo's value [1]

inline contactlaws::LinearFriction<double> linear_law(double mu) {
  contactlaws::LinearFrictionProperties<double> properties;
  properties.modulus = granite.young;
  properties.friction = mu;
  return linear_friction(properties);
}
/// Without dashpots.
inline contactlaws::Hill<double> hill_law(double mu) {
  contactlaws::Hill<double> law = damped_hill_law();
  law.shear.friction = mu;
  law.damping.damping_constant = 0.0;
  return law;
}

/// The two grains after stage A, down by 0.1 mm, and stage B, the top grain turned by 0.02 rad. The path is written as CSV.
template <class Law>
TwoGrains<Law> stages_a_and_b(const Law& law, std::ostream& csv) {
  constexpr int steps = 200;
  TwoGrains<Law> grains(law);
  Table path{"gap_m", "normal_force_N", "shear_displacement_m", "shear_force_N"};
  const auto record = [&] {
    const ContactReading s = grains.read();
    path.add({s.gap, s.normal_force, s.shear_displacement, s.shear_force});
  };
  grains.lift(-depth, steps, record);
  grains.spin(turn, steps, record);
  path.write_csv(csv);
  return grains;
}

inline void force_displacement(OutputFolder& folder, CheckedNumbers& numbers) {
  const std::string two = "two_grains.";
  const ContactReading linear = stages_a_and_b(linear_law(friction), folder.file("linear.csv")).read();
  const ContactReading linear_unlimited =
      stages_a_and_b(linear_law(no_limit), folder.file("linear_unlimited.csv")).read();
  numbers.push_back(
      {two + "linear.normal_force", 1.8221e4, expected::linear_normal_force, linear.normal_force, prescribed});
  numbers.push_back(
      {two + "linear.shear_force", 7.2884e3, expected::linear_shear_force, linear.shear_force, prescribed});
  numbers.push_back({two + "linear.shear_unlimited", 1.8039e4, expected::linear_shear_unlimited,
                     linear_unlimited.shear_force, prescribed});

  auto hill = stages_a_and_b(hill_law(friction), folder.file("hill.csv"));
  auto hill_unlimited = stages_a_and_b(hill_law(no_limit), folder.file("hill_unlimited.csv"));
  numbers.push_back(
      {two + "hill.normal_force", 1.0833e3, expected::hill_normal_force, hill.read().normal_force, prescribed});
  numbers.push_back({two + "hill.shear_force", {}, expected::hill_shear_force, hill.read().shear_force, prescribed});
  numbers.push_back({two + "hill.shear_unlimited", 1.4783e3, expected::hill_shear_unlimited,
                     hill_unlimited.read().shear_force, prescribed});

  // The dashpots are switched on only now, so they did not contribute to the forces above. One step of motion, one of rest.
  const auto nothing = [] {};
  hill.scene.ball_law.damping.damping_constant = damping_constant;
  hill.run({0.0, 0.0, -100.0}, Vec3::Zero(), 1, nothing);
  numbers.push_back({two + "hill.dashpot_normal.moving", 3.9604e3, expected::dashpot_normal_moving,
                     hill.read().normal_force, prescribed});
  hill.run(Vec3::Zero(), Vec3::Zero(), 1, nothing);
  numbers.push_back({two + "hill.dashpot_normal.stopped", 3.0640e3, expected::dashpot_normal_stopped,
                     hill.read().normal_force, prescribed});

  hill_unlimited.scene.ball_law.damping.damping_constant = damping_constant;
  hill_unlimited.run(Vec3::Zero(), {0.0, 1000.0, 0.0}, 1, nothing);
  numbers.push_back({two + "hill.dashpot_shear.moving", 1.5960e3, expected::dashpot_shear_moving,
                     hill_unlimited.read().shear_force, prescribed});
  hill_unlimited.run(Vec3::Zero(), Vec3::Zero(), 1, nothing);
  numbers.push_back({two + "hill.dashpot_shear.stopped", 1.5522e3, expected::dashpot_shear_stopped,
                     hill_unlimited.read().shear_force, prescribed});
}

}  // namespace memo

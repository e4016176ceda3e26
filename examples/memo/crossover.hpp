// SPDX-License-Identifier: MIT
// Where the hill law's stiffness, and then its force, catch up with the linear law's (Figure 12).
//
// They do so at overlaps of 12.6 and 28.3 mm, where the centres of the grains, 12.5 mm apart at touch, would have passed each
// other and the normal turned round. (The memo says itself that overlaps beyond 2 mm mean nothing.) So the bottom grain is a
// wall here: the plane that touches its pole, with its curvature, mass and elasticity. Head-on, the overlap is the same.
#pragma once

#include <string>
#include <vector>

#include "expected.hpp"
#include "force_displacement.hpp"

namespace memo {

/// The top grain pressed into the pole of the bottom grain to 30 mm: overlap [m] and normal force [N] at each step.
template <class Law>
Table press_deep(const Law& law) {
  dem::Simulation<Law> scene(law);
  scene.add(dem::Wall{contactlaws::sphere(granite, bottom_radius), {0.0, 0.0, bottom_radius}, Vec3::UnitZ()});
  const int top =
      scene.add(dem::Ball{contactlaws::sphere(granite, top_radius), {0.0, 0.0, bottom_radius + top_radius}});
  // A quarter of a micrometre per step: what chords and straight lines between the steps miss is the square of
  // step/overlap = 2e-5, and the rounding that the difference of two forces brings up is 1e-16 over 2e-5.
  scene.drive(top, {0.0, 0.0, -0.25});
  scene.time_step = 1e-6;
  Table curve{"overlap_m", "force_N"};
  for (int i = 0; i < 120000 && !stop_requested(); ++i) {
    scene.step();
    curve.add({scene.wall_contact(0).geometry.overlap, scene.wall_contact(0).response.normal_force});
  }
  return curve;
}

/// Where `y` first rises through zero, by straight lines between the points.
inline double rises_through_zero(const std::vector<double>& x, const std::vector<double>& y) {
  for (std::size_t i = 1; i < y.size(); ++i)
    if (y[i - 1] < 0.0 && y[i] >= 0.0) return x[i] - y[i] * (x[i] - x[i - 1]) / (y[i] - y[i - 1]);
  return std::numeric_limits<double>::quiet_NaN();
}

inline void crossover(OutputFolder& folder, CheckedNumbers& numbers) {
  const Table linear = press_deep(linear_law(friction)), hill = press_deep(hill_law(friction));
  std::vector<double> overlap, lead;    // of the hill law's force over the linear law's [N], at an overlap
  std::vector<double> midway, steeper;  // the lead's slope [N/m], midway between two
  Table curves{"overlap_m", "linear_force_N", "hill_force_N"};
  for (std::size_t i = 0; i < linear.rows().size(); ++i) {
    const double o = linear.rows()[i][0], at_linear = linear.rows()[i][1], at_hill = hill.rows()[i][1];
    overlap.push_back(o);
    lead.push_back(at_hill - at_linear);
    if (i > 0) {
      midway.push_back((overlap[i] + overlap[i - 1]) / 2.0);
      steeper.push_back((lead[i] - lead[i - 1]) / (overlap[i] - overlap[i - 1]));
    }
    if (i % 200 == 199) curves.add({o, at_linear, at_hill});
  }
  curves.write_csv(folder.file("crossover.csv"));
  numbers.push_back({"two_grains.crossover.stiffness_overlap", "m", 12.5e-3, expected::crossover_stiffness_overlap,
                     rises_through_zero(midway, steeper), prescribed});
  numbers.push_back({"two_grains.crossover.force_overlap", "m", 28.2e-3, expected::crossover_force_overlap,
                     rises_through_zero(overlap, lead), prescribed});
}

}  // namespace memo

// SPDX-License-Identifier: MIT
// The overlaps at which the hill law's stiffness, and then its force, become larger than the linear law's (Figure 12).
//
// They are 12.6 and 28.3 mm. The centres of two grains are only 12.5 mm apart at touch, so at these overlaps the normal would
// have changed its sign. (The memo notes that overlaps beyond 2 mm have no physical meaning.) Therefore the bottom grain is
// replaced by a wall: the plane through its pole, with its curvature, mass and elasticity. The overlap is the same.
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
  // A quarter of a micrometre per step. Relative error of chords and of linear interpolation: the square of step/overlap,
  // 2e-5. Rounding in the difference of two forces: 1e-16 / 2e-5.
  scene.drive(top, {0.0, 0.0, -0.25});
  scene.time_step = 1e-6;
  Table curve{"overlap_m", "force_N"};
  for (int i = 0; i < 120000; ++i) {
    stop_if_requested();
    scene.step();
    curve.add({scene.wall_contact(0).geometry.overlap, scene.wall_contact(0).response.normal_force});
  }
  return curve;
}

/// The first x at which `y` changes from negative to positive, by linear interpolation.
inline double zero_crossing(const std::vector<double>& x, const std::vector<double>& y) {
  for (std::size_t i = 1; i < y.size(); ++i)
    if (y[i - 1] < 0.0 && y[i] >= 0.0) return x[i] - y[i] * (x[i] - x[i - 1]) / (y[i] - y[i - 1]);
  return std::numeric_limits<double>::quiet_NaN();
}

inline void crossover(OutputFolder& folder, CheckedNumbers& numbers) {
  const Table linear = press_deep(linear_law(friction)), hill = press_deep(hill_law(friction));
  std::vector<double> overlap, difference;  // hill law's force minus linear law's [N]
  std::vector<double> midpoint, slope;      // of the difference [N/m], at the midpoints of the steps
  Table curves{"overlap_m", "linear_force_N", "hill_force_N"};
  for (std::size_t i = 0; i < linear.rows().size(); ++i) {
    const double o = linear.rows()[i][0], at_linear = linear.rows()[i][1], at_hill = hill.rows()[i][1];
    overlap.push_back(o);
    difference.push_back(at_hill - at_linear);
    if (i > 0) {
      midpoint.push_back((overlap[i] + overlap[i - 1]) / 2.0);
      slope.push_back((difference[i] - difference[i - 1]) / (overlap[i] - overlap[i - 1]));
    }
    if (i % 200 == 199) curves.add({o, at_linear, at_hill});
  }
  curves.write_csv(folder.file("crossover.csv"));
  numbers.push_back({"two_grains.crossover.stiffness_overlap", 12.5e-3, expected::crossover_stiffness_overlap,
                     zero_crossing(midpoint, slope), prescribed});
  numbers.push_back({"two_grains.crossover.force_overlap", 28.2e-3, expected::crossover_force_overlap,
                     zero_crossing(overlap, difference), prescribed});
}

}  // namespace memo

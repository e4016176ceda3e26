// SPDX-License-Identifier: MIT
// The two grain-size distributions of the Class 5 materials (Potyondy 2019, Table 7), and random grains drawn from them.
#pragma once

#include <vector>

#include "common/random.hpp"

namespace class5 {

constexpr double pi = 3.14159265358979323846;

using common::Random;

struct SizeClass {
  double low, high;  ///< diameters [m]
  double share;      ///< of the grains' volume [1]
};
using Grading = std::vector<SizeClass>;

inline const Grading narrow{{14e-3, 20e-3, 1.0}};
inline const Grading broad{{19e-3, 23e-3, 0.07},  {16.5e-3, 19e-3, 0.10}, {14e-3, 16.5e-3, 0.09}, {12e-3, 14e-3, 0.09},
                           {9.5e-3, 12e-3, 0.09}, {7e-3, 9.5e-3, 0.07},   {6e-3, 7e-3, 0.10},     {4.8e-3, 6e-3, 0.39}};

/// Radii [m] of grains of this volume in all [m^3]: in each class, diameters are drawn with equal chance until the volume of the
/// classes so far is reached.
inline std::vector<double> draw_radii(const Grading& grading, double volume, Random& random) {
  std::vector<double> radii;
  double filled = 0.0, target = 0.0;
  for (const SizeClass& size : grading) {
    target += size.share * volume;
    while (true) {
      const double radius = random.uniform(size.low, size.high) / 2.0;
      const double grain = 4.0 / 3.0 * pi * radius * radius * radius;
      if (filled + grain / 2.0 > target) break;
      radii.push_back(radius);
      filled += grain;
    }
  }
  return radii;
}

}  // namespace class5

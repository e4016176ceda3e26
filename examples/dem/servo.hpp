// SPDX-License-Identifier: MIT
// A servo: drives a wall so that the balls press on it with a given pressure. Its speed is
//
//   v = gain (target - pressure) A / (k dt),  at most `fastest`
//
// k is the sum of the normal stiffnesses of the contacts on the wall: a step at gain 1 would mend the pressure at once, were
// the balls at rest (Itasca's servo mechanism).
#pragma once

#include <algorithm>

#include "simulation.hpp"

namespace dem {

struct Servo {
  double target = 0.0;     ///< pressure [Pa]
  double gain = 0.3;       ///< [1]
  double fastest = 1.0;    ///< largest speed of the wall [m/s]
  double stiffness = 0.0;  ///< k at the last measure() [N/m]

  /// Measures k. The stiffnesses change slowly, so every hundred steps is often enough.
  template <class Scene>
  void measure(const Scene& scene, std::size_t wall) {
    stiffness = 0.0;
    for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c) {
      if (scene.wall_contacts.first(c) != wall) continue;
      const double overlap = scene.wall_contact(c).geometry.overlap;
      if (overlap > 0.0)
        stiffness +=
            scene.wall_law.stiffness(scene.wall_contacts.pair(c), overlap, scene.wall_contacts.state(c)).normal;
    }
  }

  /// Speed towards the balls [m/s] of a wall of this area [m^2].
  double speed(const Wall& wall, double area, double time_step) const {
    const double lacking = target * area - wall.normal_force;
    if (!(stiffness > 0.0)) return lacking > 0.0 ? fastest : 0.0;  // no ball touches
    return std::clamp(gain * lacking / (stiffness * time_step), -fastest, fastest);
  }
};

}  // namespace dem

// SPDX-License-Identifier: MIT
// What a triaxial test tells: modulus, loop and residual strain of each cycle, strength.
#pragma once

#include "common/report.hpp"
#include "triaxial.hpp"

namespace class5 {

/// A load-unload cycle: from the strain at which it turns, down to a deviator of zero, and back to that strain.
struct Cycle {
  double resilient_modulus = 0.0;  ///< secant of unloading [Pa]
  double residual_strain = 0.0;    ///< where the deviator is zero, over the strain at which it turned [1]
  double loop_energy = 0.0;        ///< area of the loop [J/m^3]
};

/// @param number of the cycle, from 1
inline Cycle cycle_of(const TriaxialState& test, int number) {
  const std::vector<Sample>& samples = test.samples;
  const int unload = 2 * number;
  const auto less_strain = [](const Sample& a, const Sample& b) { return a.strain < b.strain; };
  const auto leg = [&](int l) {
    return std::find_if(samples.begin(), samples.end(), [l](const Sample& s) { return s.leg >= l; });
  };
  const auto top =
      std::max_element(leg(unload), leg(unload + 1), less_strain);  // the rate changes its sign after the goal
  const auto bottom = std::min_element(top, leg(unload + 2), less_strain);
  Cycle cycle;
  auto last = top;
  for (auto s = top + 1; s != samples.end(); last = s++) {
    if (s > bottom && s->strain >= top->strain) {  // back: up to the strain at which it turned
      const double share = (top->strain - last->strain) / (s->strain - last->strain);
      const double deviator = last->deviator + share * (s->deviator - last->deviator);
      cycle.loop_energy += (last->deviator + deviator) / 2.0 * (top->strain - last->strain);
      break;
    }
    cycle.loop_energy += (last->deviator + s->deviator) / 2.0 * (s->strain - last->strain);
    if (s <= bottom && last->deviator > 0.0 && s->deviator <= 0.0)
      cycle.residual_strain =
          last->strain + (s->strain - last->strain) * last->deviator / (last->deviator - s->deviator);
  }
  cycle.resilient_modulus = top->deviator / (top->strain - cycle.residual_strain);
  cycle.residual_strain /= top->strain;
  return cycle;
}

/// Deviator over radial stress at an axial strain [1]: mean of the samples within a twentieth of it. NaN before that strain.
inline double strength_at(const TriaxialState& test, double strain) {
  double sum = 0.0, count = 0.0;
  for (const Sample& s : test.samples) {
    if (std::abs(s.strain - strain) > strain / 20.0) continue;
    sum += s.deviator / s.radial_stress;
    count += 1.0;
  }
  return sum / count;
}

/// Largest deviation of the radial stress from the confinement in the cycles, over the confinement [1].
inline double confinement_error(const TriaxialState& test) {
  double largest = 0.0;
  const int cycles = test.samples.back().leg - 1;
  for (const Sample& s : test.samples)
    if (s.leg <= cycles) largest = std::max(largest, std::abs(s.radial_stress / confinement - 1.0));
  return largest;
}

/// Porosity of the sphere inscribed in the vessel [1].
inline double sphere_porosity(const Packing& packing) {
  dem::Balls balls;
  for (const Grain& grain : packing.grains) balls.add({contactlaws::sphere(granite, grain.radius), grain.position});
  return dem::porosity_in_sphere(balls, Vec3::Zero(), std::min(packing.size.radius, packing.size.height / 2.0));
}

}  // namespace class5

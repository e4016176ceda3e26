// SPDX-License-Identifier: MIT
// Packs the sample without stress at a given voids ratio, in two phases. Each can be stopped, and goes on with the same bits.
//
//   shrink   clumps start apart from each other in a vessel twice as large. Vessel and distances shrink slowly together, without
//            friction and gravity, under springs so soft that they give way. (The paper lets grains grow in a fixed vessel: the
//            same, on another scale. Walls alone would sweep the grains ahead of them and leave the foot of the sample loose.)
//   relax    what is left of overlaps would be kilonewtons under Hertz and would count as loading history, so the grains drive
//            each other apart under Hertz, still without friction
#pragma once

#include "dem/cases.hpp"
#include "sample.hpp"

namespace probe {

constexpr std::int64_t look_every = 100;  ///< steps between two looks at time step, energy and equilibrium

/// Grains apart from each other in a vessel `start` times as large as the sample will be.
inline Sample scattered(const SampleSize& size, const std::vector<dem::ClumpShape>& shapes, double start) {
  Random draw(size.seed);
  Sample sample{start * size.diameter / 2.0, start * size.height, draw_grains(size, shapes, draw)};
  scatter(sample.grains, shapes, sample.radius, sample.height, draw);
  return sample;
}

/// Shrinks the vessel from `start` times its size, within `duration` [s]; then lets the grains come to rest for a quarter of it.
/// @throws common::Stopped
inline Sample shrink(const SampleSize& size, const std::vector<dem::ClumpShape>& shapes, dem::CaseControl& control) {
  constexpr double start = 2.0;     // bounding spheres then fill a quarter of the vessel
  constexpr double duration = 1.0;  // [s]
  constexpr double soft = 1e5;      // [N/m]
  Sample sample = scattered(size, shapes, start);
  const double inward = (start - 1.0) * size.diameter / 2.0 / duration,
               downward = (start - 1.0) * size.height / duration;
  Specimen<Boundary> specimen(boundary_law(soft), boundary_law(soft), shapes, sample);
  specimen.set_skin(5e-3);
  auto& scene = specimen.scene;
  const double stable = 0.5 * dem::stable_time_step(scene, specimen.clumps, 4.0 * soft);
  const auto steps = static_cast<std::int64_t>(std::ceil(duration / stable)), all_steps = steps * 5 / 4;
  scene.time_step = duration / static_cast<double>(steps);
  control.resume(scene, specimen);
  while (scene.steps < all_steps) {
    if (scene.steps % look_every == 0)
      control.between_steps(scene, specimen, static_cast<double>(scene.steps) / static_cast<double>(all_steps));
    const bool shrinks = scene.steps < steps;
    scene.walls[Vessel::top].velocity.z() = shrinks ? -downward : 0.0;
    scene.walls[Vessel::side].radial_velocity = shrinks ? -inward : 0.0;
    const double lower = shrinks ? downward * scene.time_step : 0.0;
    for (dem::Clump& clump : specimen.clumps.all) clump.position *= 1.0 - lower / Vessel::height(scene);
    specimen.step();
  }
  specimen.take_places(sample);
  return sample;
}

/// A stiffness that contacts of this sample reach under the pressure [N/m]: Hertz's under a force of p d^2, d a grain's size.
inline double nominal_stiffness(double pressure) {
  constexpr double size = 40e-3, pebble = 6e-3;
  const auto pair =
      contactlaws::pair_properties(contactlaws::sphere(granite, pebble), contactlaws::sphere(granite, pebble));
  const double force = pressure * size * size;
  return std::cbrt(6.0 * pair.effective_young * pair.effective_young * force * pair.effective_radius);
}

/// @throws common::Stopped
inline Sample relax(Sample sample, const std::vector<dem::ClumpShape>& shapes, dem::CaseControl& control) {
  constexpr double duration = 0.03;  // [s]
  Specimen<Hertz> specimen(make_law<Hertz>(0.0), boundary_law(), shapes, sample);
  auto& scene = specimen.scene;
  control.resume(scene, specimen);
  while (scene.time < duration) {
    if (scene.steps % look_every == 0) {
      control.between_steps(scene, specimen, scene.time / duration);
      specimen.clumps.start(scene);
      scene.time_step = 0.5 * dem::stable_time_step(scene, specimen.clumps, nominal_stiffness(150e3));
    }
    specimen.step();
  }
  specimen.take_places(sample);
  return sample;
}

/// Both phases at once, of a small sample.
inline Sample make_sample(const SampleSize& size, const std::vector<dem::ClumpShape>& shapes) {
  dem::CaseControl no_file;
  return relax(shrink(size, shapes, no_file), shapes, no_file);
}

}  // namespace probe

// SPDX-License-Identifier: MIT
// Packs the sample without stress at a given voids ratio, in three phases. Each can be stopped, and goes on with the same bits.
//
//   shrink   clumps start apart from each other in a vessel twice as large. Vessel and distances shrink slowly together, without
//            friction and gravity, under springs so soft that they give way, to a voids ratio of `slack` more than the one asked
//            for. (The paper lets grains grow in a fixed vessel: the same, on another scale. Walls alone would sweep the grains
//            ahead of them and leave the foot of the sample loose.)
//   relax    what is left of overlaps would be kilonewtons under Hertz and would count as loading history, so the grains drive
//            each other apart under Hertz, still without friction
//   close    vessel and distances shrink by the rest under Hertz and friction, until the grains carry `jammed`. Without friction
//            these clumps do not jam at the paper's voids ratio of .700: a pressure that grows then throws them together, to .55.
#pragma once

#include <cmath>
#include <limits>

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

/// How a vessel shrinks: to `ratio` times its size within `duration` [s], unless the mean stress on the walls exceeds
/// `most_stress` [Pa] before. Then it stays for `rest` [s].
struct Shrinkage {
  double ratio, duration, rest, most_stress;
};

/// Shrinks the vessel of a specimen, and the distances of its grains. Each grain counts at least one contact of the stiffness
/// `nominal` [N/m]. @throws common::Stopped
template <class Law>
void shrink_vessel(Specimen<Law>& specimen, const Shrinkage& by, double nominal, dem::CaseControl& control) {
  auto& scene = specimen.scene;
  const double speed = (1.0 - by.ratio) / by.duration;  // of the first radius and height [1/s]
  const double inward = speed * specimen.vessel.radius(scene), downward = speed * Vessel::height(scene);
  const double stable = 0.5 * dem::stable_time_step(scene, specimen.clumps, nominal);
  const auto steps = static_cast<std::int64_t>(std::ceil(by.duration / stable)),
             all_steps = static_cast<std::int64_t>(std::ceil((by.duration + by.rest) / stable));
  scene.time_step = by.duration / static_cast<double>(steps);
  const auto stress = [&] {
    return (specimen.vessel.axial_stress(scene) + 2.0 * specimen.vessel.radial_stress(scene)) / 3.0;
  };
  control.resume(scene, specimen);
  while (scene.steps < all_steps && stress() <= by.most_stress) {
    if (scene.steps % look_every == 0)
      control.between_steps(scene, specimen, static_cast<double>(scene.steps) / static_cast<double>(all_steps));
    const bool shrinks = scene.steps < steps;
    scene.walls[Vessel::top].velocity.z() = shrinks ? -downward : 0.0;
    scene.walls[Vessel::side].radial_velocity = shrinks ? -inward : 0.0;
    const double lower = shrinks ? downward * scene.time_step : 0.0;
    for (dem::Clump& clump : specimen.clumps.all) clump.position *= 1.0 - lower / Vessel::height(scene);
    specimen.step();
  }
}

/// The sample of this size, its grains perhaps overlapping. @throws common::Stopped
inline Sample shrink(const SampleSize& size, const std::vector<dem::ClumpShape>& shapes, dem::CaseControl& control) {
  constexpr double start = 2.0;  // bounding spheres then fill a quarter of the vessel
  constexpr double soft = 1e5;   // [N/m]
  constexpr Shrinkage by{1.0 / start, 1.0, 0.25, std::numeric_limits<double>::infinity()};
  Sample sample = scattered(size, shapes, start);
  Specimen<Boundary> specimen(boundary_law(soft), boundary_law(soft), shapes, sample);
  specimen.set_skin(5e-3);
  shrink_vessel(specimen, by, 4.0 * soft, control);
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

/// A size that holds the same grains at a voids ratio of `slack` more.
inline SampleSize loosened(SampleSize size) {
  constexpr double slack = 0.004;
  const double ratio = std::cbrt(1.0 + slack / (1.0 + size.voids_ratio));
  size.diameter *= ratio;
  size.height *= ratio;
  size.voids_ratio += slack;
  return size;
}

/// The sample in a vessel of this size, or, where it carries `jammed` before, in a larger one. @throws common::Stopped
inline Sample close(Sample sample, const SampleSize& size, const std::vector<dem::ClumpShape>& shapes,
                    dem::CaseControl& control) {
  constexpr double speed = 0.01;  // of the vessel's size [1/s]
  constexpr double jammed = 3e3;  // 2 % of the pressure to come, the weight of the top platen [Pa]
  const double ratio = size.height / sample.height;
  Specimen<Hertz> specimen(make_law<Hertz>(friction), boundary_law(), shapes, sample);
  shrink_vessel(specimen, {ratio, (1.0 - ratio) / speed, 0.0, jammed}, nominal_stiffness(150e3), control);
  specimen.take_places(sample);
  return sample;
}

/// All phases at once, of a small sample.
inline Sample make_sample(const SampleSize& size, const std::vector<dem::ClumpShape>& shapes) {
  dem::CaseControl no_file;
  return close(relax(shrink(loosened(size), shapes, no_file), shapes, no_file), size, shapes, no_file);
}

}  // namespace probe

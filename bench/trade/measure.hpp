// SPDX-License-Identifier: MIT
// What a composition costs, and how far it is from the truth.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include "reference.hpp"
#include "run.hpp"

namespace trade {

/// Of forces, relative to the largest force of each contact's path; of the energy dissipated by the end, relative to the
/// largest work done on the contact.
struct Errors {
  double largest = 0.0;
  double rms = 0.0;
  double energy = 0.0;
};

inline double as_share(double error, double scale) { return error > 0.0 ? error / scale : 0.0; }

/// Runs through `scene`, which spans `scene.multiple` steps of the reference in each of its own.
inline Errors compare(Run& run, const Scene& scene, const Reference& reference, const Scene& full) {
  const auto truth = [&](std::size_t step, std::size_t contact) -> const Truth& {
    return reference.rows[full.offset[(step + 1) * scene.multiple - 1] + contact];
  };
  std::vector<double> scale(scene.contacts(), 0.0);
  for (std::size_t step = 0; step < full.steps(); ++step)
    for (std::size_t c = 0; c < full.contacts_at(step); ++c)
      scale[c] = std::max(scale[c], double(reference.rows[full.offset[step] + c].force.norm()));

  std::vector<double> stored_at_start;
  run.reset();
  for (std::size_t c = 0; c < scene.contacts(); ++c)
    stored_at_start.push_back(run.stored_energy(c, full.in_double[c].overlap));
  run.advance(0, scene.steps());

  Errors errors;
  double squares = 0.0;
  std::vector<double> work(scene.contacts(), 0.0), overlap(scene.contacts(), 0.0);
  std::vector<Vec3<double>> last(scene.contacts(), Vec3<double>::Zero());
  for (std::size_t step = 0; step < scene.steps(); ++step) {
    for (std::size_t c = 0; c < scene.contacts_at(step); ++c) {
      const std::size_t row = scene.offset[step] + c;
      const Vec3<double> force = run.force(row);
      const Vec3<long double> off = force.cast<long double>() - truth(step, c).force;
      const double error = as_share(double(off.norm()), scale[c]);
      errors.largest = std::isnan(error) ? error : std::max(errors.largest, error);
      squares += error * error;
      const ContactKinematics<double>& motion = scene.in_double[row];  // the work of energy.hpp's ledger
      work[c] -= (last[c] + force).dot(motion.velocity) / 2.0 * motion.dt;
      last[c] = force;
      overlap[c] = motion.overlap;
    }
  }
  errors.rms = std::sqrt(squares / double(scene.rows()));
  for (std::size_t c = 0; c < scene.contacts(); ++c) {
    const double dissipated = work[c] - (run.stored_energy(c, overlap[c]) - stored_at_start[c]);
    errors.energy =
        std::max(errors.energy, as_share(std::abs(dissipated - reference.dissipated[c]), reference.energy_scale[c]));
  }
  return errors;
}

/// The median of `repetitions` timings of the whole scene, each at least `least` seconds long: ns of processor time (others may
/// want the core too) per contact and step.
inline double nanoseconds(Run& run, const Scene& scene, int repetitions, double least) {
  const auto once = [&](std::size_t passes) {
    const std::clock_t begin = std::clock();
    for (std::size_t i = 0; i < passes; ++i) {
      run.reset();
      run.advance(0, scene.steps());
    }
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  once(1);  // warm up
  std::size_t passes = 1;
  while (once(passes) < least && passes < 1'000'000) passes *= 2;
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) times.push_back(once(passes));
  std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
  return times[std::size_t(repetitions / 2)] / double(passes) / double(scene.rows()) * 1e9;
}

/// How far the force at the end of a closed cycle wanders as the cycle is repeated, from the tenth (by when friction has
/// settled) until `steps` steps are done, relative to the largest force there.
inline double drift(Run& run, const Scene& scene, std::size_t steps) {
  const std::size_t period = scene.steps() - scene.cycle_start, last_row = scene.offset[scene.steps() - 1];
  const auto ends = [&] {
    std::vector<Vec3<double>> forces;
    for (std::size_t c = 0; c < scene.contacts(); ++c) forces.push_back(run.force(last_row + c));
    return forces;
  };
  const auto repeat = [&](std::size_t cycles) {
    for (std::size_t i = 0; i < cycles; ++i) run.advance(scene.cycle_start, scene.steps());
  };
  run.reset();
  run.advance(0, scene.steps());
  repeat(10);
  const auto before = ends();
  repeat(steps / period);
  const auto after = ends();
  double wander = 0.0;
  for (std::size_t c = 0; c < scene.contacts(); ++c)
    wander = std::max(wander, as_share((after[c] - before[c]).norm(), before[c].norm()));
  return wander;
}

}  // namespace trade

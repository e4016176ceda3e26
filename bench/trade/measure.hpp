// SPDX-License-Identifier: MIT
// What a composition costs, and its error against the reference.
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

/// Runs along `motion`, each step of which spans `motion.multiple` steps of `full`, the motion of the reference.
inline Errors compare(Run& run, const Trajectories& motion, const Reference& reference, const Trajectories& full) {
  const auto right = [&](std::size_t step, std::size_t contact) -> const ReferenceRow& {
    return reference.rows[full.offset[(step + 1) * motion.multiple - 1] + contact];
  };
  std::vector<double> scale(motion.contacts(), 0.0);
  for (std::size_t step = 0; step < full.steps(); ++step)
    for (std::size_t c = 0; c < full.contacts_at(step); ++c)
      scale[c] = std::max(scale[c], double(reference.rows[full.offset[step] + c].force.norm()));

  std::vector<double> stored_at_start;
  run.reset();
  for (std::size_t c = 0; c < motion.contacts(); ++c)
    stored_at_start.push_back(run.stored_energy(c, full.in_double[c].overlap));
  run.advance(0, motion.steps());

  Errors errors;
  double squares = 0.0;
  std::vector<double> work(motion.contacts(), 0.0), overlap(motion.contacts(), 0.0);
  std::vector<Vec3<double>> last(motion.contacts(), Vec3<double>::Zero());
  for (std::size_t step = 0; step < motion.steps(); ++step) {
    for (std::size_t c = 0; c < motion.contacts_at(step); ++c) {
      const std::size_t row = motion.offset[step] + c;
      const Vec3<double> force = run.force(row);
      const Vec3<long double> off = force.cast<long double>() - right(step, c).force;
      const double error = as_share(double(off.norm()), scale[c]);
      errors.largest = std::isnan(error) ? error : std::max(errors.largest, error);
      squares += error * error;
      const ContactKinematics<double>& now = motion.in_double[row];  // the work of energy.hpp's ledger
      work[c] -= (last[c] + force).dot(now.velocity) / 2.0 * now.dt;
      last[c] = force;
      overlap[c] = now.overlap;
    }
  }
  errors.rms = std::sqrt(squares / double(motion.rows()));
  for (std::size_t c = 0; c < motion.contacts(); ++c) {
    const double dissipated = work[c] - (run.stored_energy(c, overlap[c]) - stored_at_start[c]);
    errors.energy =
        std::max(errors.energy, as_share(std::abs(dissipated - reference.dissipated[c]), reference.energy_scale[c]));
  }
  return errors;
}

/// The median of `repetitions` timings of the whole motion, each at least `least` seconds long: ns of processor time (other programs may
/// use the core too) per contact and step.
inline double nanoseconds(Run& run, const Trajectories& motion, int repetitions, double least) {
  const auto once = [&](std::size_t passes) {
    const std::clock_t begin = std::clock();
    for (std::size_t i = 0; i < passes; ++i) {
      run.reset();
      run.advance(0, motion.steps());
    }
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
  };
  once(1);  // warm up
  std::size_t passes = 1;
  while (once(passes) < least && passes < 1'000'000) passes *= 2;
  std::vector<double> times;
  for (int i = 0; i < repetitions; ++i) times.push_back(once(passes));
  std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
  return times[std::size_t(repetitions / 2)] / double(passes) / double(motion.rows()) * 1e9;
}

/// How much the force at the end of a closed cycle changes as the cycle is repeated, from the tenth (by when friction has
/// settled) until `steps` steps are done, relative to the largest force there.
inline double drift(Run& run, const Trajectories& motion, std::size_t steps) {
  const std::size_t period = motion.steps() - motion.cycle_start, last_row = motion.offset[motion.steps() - 1];
  const auto ends = [&] {
    std::vector<Vec3<double>> forces;
    for (std::size_t c = 0; c < motion.contacts(); ++c) forces.push_back(run.force(last_row + c));
    return forces;
  };
  const auto repeat = [&](std::size_t cycles) {
    for (std::size_t i = 0; i < cycles; ++i) run.advance(motion.cycle_start, motion.steps());
  };
  run.reset();
  run.advance(0, motion.steps());
  repeat(10);
  const auto before = ends();
  repeat(steps / period);
  const auto after = ends();
  double change = 0.0;
  for (std::size_t c = 0; c < motion.contacts(); ++c)
    change = std::max(change, as_share((after[c] - before[c]).norm(), before[c].norm()));
  return change;
}

}  // namespace trade

// SPDX-License-Identifier: MIT
// Energy: dashpots only take it, and on a closed loop, from open to open, a contact yields none.
//
// The work of a step is -[(f_before + f_now)/2 + (F - f_now)] . v dt, where F is the load of the step and f the load at
// rest: exact for springs, and the dashpots' part is taken at the velocity that it belongs to. On steps between a few
// overlaps, each visited both ways, the elastic normal work then cancels to the last digit.
#pragma once

#include "contactlaws/verify/setup.hpp"

namespace contactlaws::verify {

namespace detail {

/// What a Load does its work on: the velocity, and the relative spin times R1 + R2 [m/s].
inline Load rate_of(const Motion& m, const Scales& scales) {
  Load rate;
  rate << m.velocity, m.relative_spin * scales.length;
  return rate;
}

struct Work {
  double done = 0.0;   ///< on the contact [J]
  double moved = 0.0;  ///< the work of all steps, without sign [J]
};

inline Work work_along(const Setup& setup, const Path& path) {
  using std::fabs;
  const Trajectory trajectory = setup.trajectory(path);
  ForceUpdate::State state = setup.update.start();
  Work work;
  Load before = Load::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto& [bodies, dt] = trajectory[i];
    const Interaction interaction = setup.update.step(bodies, dt, state);
    const Load spring = load_at_rest(setup.update, trajectory[i], state);
    if (i == 0) before.head<3>() = path[0].normal * -interaction.bridge_force;  // a bridge pulls from the start
    const Load load = (before + spring) / 2 + (load_of(bodies, interaction) - spring);
    const double step = -load.dot(rate_of(path[i], setup.scales)) * dt;
    work.done += step;
    work.moved += fabs(step);
    before = spring;
  }
  return work;
}

/// The energy gained along the path, relative to the work moved: counted if steps cut in four and in eight agree on it, so
/// that it is the law's and not the sum's. Allowed is a millionth.
inline Finding gain_along(const Setup& setup, const Path& path) {
  using std::fabs;
  Finding finding{0.0, 1e-6};
  if (path.empty() || path.back().overlap > -setup.options.claims.range.value_or(0.0)) return finding;
  if (!(work_along(setup, path).done < 0.0)) return finding;
  const Work fine = work_along(setup, refined(path, 4)), finer = work_along(setup, refined(path, 8));
  if (fabs(finer.done - fine.done) <= 0.5 * fabs(finer.done)) finding.error = -finer.done / finer.moved;
  return finding;
}

/// From touch, to and fro between four overlaps, along the contact plane and rolling, back to no slip, and open. The overlap
/// moves slowly, so that the normal dashpot does not hide what the springs yield; slip has any speed.
inline Path random_loop(const Setup& setup, Random& random, const Vector& normal, const Vector& along) {
  constexpr int levels = 4;
  const Scales& scales = setup.scales;
  const Claims& claims = setup.options.claims;
  const double friction = minimum<double>(claims.friction.value_or(1.0), 1.0), gap = claims.range.value_or(0.0);
  const double slow = 1e4 * scales.time, slip = scales.overlap * random.log_uniform(0.01, 5.0) * friction;
  Path path;
  int level = 0;
  double slipped = 0.0, rolled = 0.0;
  const auto go = [&](int to) {
    level = to;
    path.push_back({normal, scales.overlap * level / levels, Vector(0, 0, 0), slow});
  };
  const auto slide = [&](double by, double roll) {
    go(level);
    Motion& m = path.back();
    m.dt = scales.time * random.log_uniform(0.1, 1e4);
    m.velocity = along * (by / m.dt);
    m.relative_spin = along * (roll / scales.length / m.dt);
    slipped += by;
    rolled += roll;
  };
  const double first = random.uniform(0.0, levels);
  while (level < first) go(level + 1);
  const double moves = random.uniform(2.0, 16.0);
  for (int i = 0; i < moves; ++i) {
    const bool slides = random.chance(0.5), rolls = random.chance(0.3), lower = random.chance(0.5);
    const double by = random.uniform(-1, 1) * slip;
    if (slides) {
      slide(rolls ? 0.0 : by, rolls ? by : 0.0);
    } else {
      go(level == levels || (level > 1 && lower) ? level - 1 : level + 1);
    }
  }
  slide(-slipped, -rolled);
  while (level > 0) go(level - 1);
  if (gap > 0.0) path.push_back({normal, -gap * (1 + 1e-6), Vector(0, 0, 0), slow});
  return path;
}

}  // namespace detail

/// The load of a moving contact, less that at rest in the same place, never drives the motion. Of a new contact that closes
/// and opens without slip, or slips or rolls at one overlap: only there is the difference the dashpots' alone.
inline Result dashpots_dissipate(const Setup& setup, const char* name) {
  int k = 0;
  const auto make = [&](Random& random, const Vector& normal, const Vector& along) {
    const double from = setup.scales.overlap * random.log_uniform(0.01, 1.0);
    const double to = setup.scales.overlap * random.log_uniform(0.01, 1.0);
    const double speed = setup.scales.speed() * random.log_uniform(1e-2, 10.0);
    Path path{setup.move(normal, from), setup.move(normal, from)};
    Motion& m = path.back();
    using std::fabs;
    if (k % 3 == 0) m = {normal, to, Vector(0, 0, 0), fabs(to - from) / speed};
    if (k % 3 == 1) m.velocity = along * speed;
    if (k % 3 == 2) m.relative_spin = along * (speed / setup.scales.length);
    ++k;
    return path;
  };
  const std::vector<Path> tried = setup.make_paths(name, setup.options.paths, make);
  return setup.worst_of(name, "of the largest force, along the motion", tried, [&](const Path& path) {
    if (path.empty()) return Finding{};
    const Trajectory trajectory = setup.trajectory(path);
    const Record record = drive(setup.update, trajectory);
    const Load dashpots = record.loads.back() - load_at_rest(setup.update, trajectory.back(), record.state);
    const Load rate = detail::rate_of(path.back(), setup.scales);
    const double speed = load_norm(rate);
    return Finding{speed > 0.0 ? dashpots.dot(rate) / speed / record.largest_force() : 0.0, setup.scales.rounding};
  });
}

inline Result closed_loops(const Setup& setup, const char* name) {
  constexpr int loops_per_path = 20;  // few loops yield energy; a loop is cheap
  const auto loops = setup.make_paths(name, loops_per_path * setup.options.paths,
                                      [&](auto&... random) { return detail::random_loop(setup, random...); });
  return setup.worst_of(name, "of the work, gained", loops,
                        [&](const Path& path) { return detail::gain_along(setup, path); });
}

}  // namespace contactlaws::verify

// SPDX-License-Identifier: MIT
// Histories: the same state gives the same load, a restart or another owner changes nothing, smaller steps converge, closed
// cycles end where they began.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "contactlaws/verify/setup.hpp"

namespace contactlaws::verify {

namespace detail {

/// Another way to take a step, from the state before it or after it.
using OtherWay = std::function<Load(const Instant&, const ForceUpdate::State& before, const ForceUpdate::State& after)>;

/// At each step of the random paths the other way gives the same load, and leaves the steps that follow unchanged.
inline Result other_way(const Setup& setup, const char* name, double allowed, const OtherWay& other) {
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    const Trajectory trajectory = setup.trajectory(path);
    const Record alone = drive(setup.update, trajectory);
    const double largest = alone.largest_force();
    Finding finding{0.0, allowed};
    ForceUpdate::State state = setup.update.start();
    for (std::size_t i = 0; i < path.size(); ++i) {
      const ForceUpdate::State before = state;
      const Load load = setup.load(trajectory[i].bodies, trajectory[i].dt, state);
      finding.add(load_norm(load - alone.loads[i]) / largest);
      finding.add(load_norm(other(trajectory[i], before, state) - load) / largest);
    }
    return finding;
  });
}

}  // namespace detail

/// Bit by bit the same load from the same state.
inline Result purity(const Setup& setup, const char* name) {
  return detail::other_way(setup, name, 0.0, [&](const Instant& i, ForceUpdate::State before, const auto&) {
    return setup.load(i.bodies, i.dt, before);
  });
}

/// Bit by bit the same load when the state is stored and loaded before the step.
inline Result restart(const Setup& setup, const char* name) {
  return detail::other_way(setup, name, 0.0, [&](const Instant& i, const auto& before, const auto&) {
    ForceUpdate::State restarted = setup.update.restarted(before);
    return setup.load(i.bodies, i.dt, restarted);
  });
}

/// The same load when the pair is owned by the other body, with its history as the law exchanges it.
inline Result change_of_owner(const Setup& setup, const char* name) {
  return detail::other_way(setup, name, setup.scales.rounding, [&](const Instant& i, const auto& before, const auto&) {
    ForceUpdate::State exchanged = setup.update.exchanged(before);
    return Load(-setup.load({i.bodies.two, i.bodies.one}, i.dt, exchanged));
  });
}

/// A step repeated with dt = 0, as hosts do when they set up or restart: the load stays. With static friction a second
/// repetition is compared to the first, since the step in which sliding begins ends with another limit than it began with.
inline Result zero_duration(const Setup& setup, const char* name) {
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    const Trajectory trajectory = setup.trajectory(path);
    const double largest = drive(setup.update, trajectory).largest_force();
    Finding finding{0.0, setup.scales.rounding};
    ForceUpdate::State state = setup.update.start();
    for (const auto& [bodies, dt] : trajectory) {
      Load load = setup.load(bodies, dt, state);
      ForceUpdate::State copy = state;
      if (setup.options.claims.static_friction) load = setup.load(bodies, 0.0, copy);
      finding.add(load_norm(setup.load(bodies, 0.0, copy) - load) / largest);
    }
    return finding;
  });
}

namespace detail {

/// One smooth motion, in `steps`: the overlap swells and falls, slip and rolling go to and fro, the normal leans over.
inline Path smooth_path(const Scales& scales, double amplitude, int steps) {
  using std::cos;
  using std::sin;
  Path path;
  const double dt = 3 * scales.time / steps;
  const auto slip = [&](double t) {
    return Vector(Vector(sin(5 * t), cos(3 * t) - 1, 0) * amplitude * scales.overlap);
  };
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps, before = static_cast<double>(i - 1) / steps;
    const Rotation lean = rotation_about(Vector(0, 1, 0), 0.2 * t);
    const double overlap = scales.overlap * (1 - cos(5 * t)) / 2;
    const Vector velocity = lean * Vector((slip(t) - slip(before)) / dt);
    path.push_back({lean * Vector(0, 0, 1), overlap, velocity, dt, 0.0, velocity / scales.length});
  }
  set_normal_velocities(path);
  return path;
}

}  // namespace detail

/// The loads along a smooth motion, at 16 times: the median change that halving the step makes in them must fall to a quarter
/// at least (order 1/2), from the largest at 128 to 512 steps to that at 2048, or be below 1e-5, where the steps in which slip
/// begins decide. Median and largest, since a law with static friction jumps where slip begins.
/// `measure` gives the lowest order seen, from 128 steps on. A failure's path is the motion, in 16 steps.
inline Result convergence(const Setup& setup, const char* name) {
  constexpr std::size_t times = 16;
  Result result{name};
  result.worst.allowed = 0.25;
  double lowest = std::numeric_limits<double>::infinity();
  for (const double amplitude : {0.003, 0.03, 0.3}) {
    std::vector<double> changes;
    std::vector<Load> before;
    for (int steps = 128; steps <= 4096; steps *= 2) {
      const Record record = setup.drive_along(detail::smooth_path(setup.scales, amplitude, steps));
      const double largest = record.largest_force();
      std::vector<Load> now;
      for (std::size_t i = 1; i <= times; ++i)
        now.push_back(record.loads[i * record.loads.size() / times - 1] / largest);
      std::vector<double> change;
      for (std::size_t i = 0; i < before.size(); ++i) change.push_back(load_norm(now[i] - before[i]));
      std::sort(change.begin(), change.end());
      if (!change.empty()) changes.push_back(change[times / 2]);
      before = now;
    }
    const double first = *std::max_element(changes.begin(), changes.begin() + 3), last = changes.back();
    if (last <= 1e-5 + setup.scales.rounding) continue;
    using std::log2;
    lowest = minimum<double>(lowest, log2(changes.front() / last) / 4);
    if (!result.worst.add(last / first)) continue;
    if (result.worst.failed()) result.path = detail::smooth_path(setup.scales, amplitude, times);
  }
  std::ostringstream text;
  text.precision(2);
  text << "of a change is left at a 16th of the step";
  if (lowest < std::numeric_limits<double>::infinity()) text << ", order " << lowest;
  result.measure = text.str();
  if (result.worst.failed()) result.verdict = Verdict::fail;
  return result;
}

/// A cycle of overlap and slip, eight times: the force at rest after each is that after the first.
/// Allowed: eight cycles' rounding; a law that integrates F(o) drifts by the square of its step, which is no rounding.
inline Result ratcheting(const Setup& setup, const char* name) {
  constexpr int cycles = 8, steps_of_cycle = 4;
  const double friction = minimum<double>(setup.options.claims.friction.value_or(1.0), 1.0);
  const auto tried =
      setup.make_paths(name, setup.few(), [&](Random& random, const Vector& normal, const Vector& along) {
        const double other = setup.scales.overlap * random.uniform(0.3, 0.9);
        const bool opening = random.chance(0.5);  // the sense of the cycle matters
        const double out = opening ? setup.scales.overlap : other, back = opening ? other : setup.scales.overlap;
        const Vector slip = along * out * friction * random.log_uniform(1e-3, 0.03);
        Path path{setup.move(normal, out)};
        for (int i = 0; i < cycles; ++i)
          for (const Motion& m : {setup.move(normal, out, slip), setup.move(normal, back),
                                  setup.move(normal, back, -slip), setup.move(normal, out)})
            path.push_back(m);
        slow_down(path, 1e4);  // a dashpot that opens the contact resets its history
        return path;
      });
  return setup.worst_of(name, "of the largest force, in eight cycles", tried, [&](const Path& path) {
    Finding finding{0.0, cycles * setup.scales.rounding};
    if (path.size() < 1 + 2 * steps_of_cycle || (path.size() - 1) % steps_of_cycle != 0) return finding;
    // Whole cycles alone: a broken one ends elsewhere.
    const Trajectory trajectory = setup.trajectory(path);
    ForceUpdate::State state = setup.update.start();
    double largest = 0.0;
    Load first = Load::Zero(), last = Load::Zero();
    Vector slipped(0, 0, 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const auto& [bodies, dt] = trajectory[i];
      largest = maximum<double>(largest, norm<double>(setup.update.step(bodies, dt, state).force));
      slipped = slipped + tangential(path[i].velocity, path[i].normal) * path[i].dt;
      if (i == 0 || i % steps_of_cycle != 0) continue;
      const bool closed = norm<double>(slipped) <= 1e-9 * setup.scales.overlap && path[i].overlap == path[0].overlap;
      if (!closed) return Finding{};
      last = load_at_rest(setup.update, trajectory[i], state);
      if (i == steps_of_cycle) first = last;
    }
    finding.error = load_norm(last - first) / largest;
    return finding;
  });
}

}  // namespace contactlaws::verify

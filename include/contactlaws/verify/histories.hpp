// SPDX-License-Identifier: MIT
// What a history must keep to: asked twice it answers the same twice, a restart loses nothing, smaller steps lead to one
// answer, closed cycles lead back.
#pragma once

#include <cmath>
#include <limits>
#include <sstream>

#include "contactlaws/verify/trial.hpp"

namespace contactlaws::verify {

/// Bit by bit the same answers from the same state: a question asked of a copy changes nothing.
template <class Law>
Result purity(const Trial<Law>& trial) {
  return trial.judge("purity", "of the largest force", [&](const Path& path) {
    const Scene scene = trial.scene(path);
    const Answers once = answers(trial.law, scene);
    Finding finding;
    detail::State<Law> state = start_of(trial.law);
    for (std::size_t i = 0; i < scene.size(); ++i) {
      detail::State<Law> copy = state;
      const Vector asked = trial.law(scene[i].bodies, scene[i].dt, copy).force;
      const Vector again = trial.law(scene[i].bodies, scene[i].dt, state).force;
      for (const Vector& force : {asked, again}) {
        const double off = norm<double>(force - once[i].force) / largest_force(once);
        finding.see(off);
      }
    }
    return finding;
  });
}

/// Bit by bit the same answers when the state is stored and loaded before every step.
template <class Law>
Result restart(const Trial<Law>& trial) {
  constexpr const char* name = "restart";
  if constexpr (!detail::offers<detail::StoreAndLoad, Law>) {
    return not_offered(name);
  } else {
    return trial.judge(name, "of the largest force", [&](const Path& path) {
      const Scene scene = trial.scene(path);
      const Answers through = answers(trial.law, scene);
      Finding finding;
      detail::State<Law> state = start_of(trial.law);
      for (std::size_t i = 0; i < scene.size(); ++i) {
        state = trial.law.load(trial.law.store(state));
        const Vector force = trial.law(scene[i].bodies, scene[i].dt, state).force;
        const double off = norm<double>(force - through[i].force) / largest_force(through);
        finding.see(off);
      }
      return finding;
    });
  }
}

namespace detail {

/// One smooth motion, in `steps`: the overlap breathes, the slip goes to and fro, the normal leans over.
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
    const Eigen::AngleAxisd lean(0.2 * t, Vector(0, 1, 0));
    const double overlap = scales.overlap * (1 - cos(5 * t)) / 2;
    path.push_back({lean * Vector(0, 0, 1), overlap, lean * Vector((slip(t) - slip(before)) / dt), dt, 0.0});
  }
  settle(path);
  return path;
}

}  // namespace detail

/// The forces along a smooth motion, at 16 times: what half the step changes in them is to fall, from 128 steps to 2048, to
/// a quarter (order 1/2) at least, or to be below 1e-5 already, where the steps in which slip begins decide.
/// `measure` tells the lowest order seen. A failure's path is the motion, in 16 steps.
template <class Law>
Result convergence(const Trial<Law>& trial) {
  constexpr int times = 16, coarse = 128, fine = 16 * coarse;
  Result result{"step-size convergence"};
  result.worst.allowed = 0.25;
  double lowest = std::numeric_limits<double>::infinity();
  for (const double amplitude : {0.003, 0.03, 0.3}) {
    const auto forces = [&](int steps) {
      const Answers all = answers(trial.law, trial.scene(detail::smooth_path(trial.scales, amplitude, steps)));
      std::vector<Vector> sampled;
      for (int i = 1; i <= times; ++i)
        sampled.push_back(all[static_cast<std::size_t>(i * steps / times - 1)].force / largest_force(all));
      return sampled;
    };
    const auto change = [&](int steps) {
      const std::vector<Vector> here = forces(steps), halved = forces(2 * steps);
      double squares = 0.0;
      for (std::size_t i = 0; i < here.size(); ++i) squares += (here[i] - halved[i]).squaredNorm();
      using std::sqrt;
      return sqrt(squares / times);
    };
    const double first = change(coarse), last = change(fine);
    if (last <= 1e-5 + trial.rounding()) continue;
    using std::log2;
    lowest = minimum<double>(lowest, log2(first / last) / 4);
    if (!result.worst.see(last / first)) continue;
    if (result.worst.failed()) result.path = detail::smooth_path(trial.scales, amplitude, times);
  }
  std::ostringstream text;
  text.precision(2);
  text << "of a change is left at a 16th of the step";
  if (lowest < std::numeric_limits<double>::infinity()) text << ", order " << lowest;
  result.measure = text.str();
  if (result.worst.failed()) result.verdict = Verdict::fail;
  return result;
}

/// A cycle of overlap and slip, eight times over: the force at rest after each is that after the first.
/// Allowed: eight cycles' rounding; a law that integrates F(o) drifts by the square of its step, which is no rounding.
template <class Law>
Result ratcheting(const Trial<Law>& trial) {
  constexpr const char* name = "ratcheting";
  if (!trial.options.claims.no_ratcheting) return not_claimed(name);
  constexpr int cycles = 8, steps_of_cycle = 4;
  const double friction = trial.options.claims.friction.value_or(1.0);
  std::vector<Path> tried;
  for (int k = 0; k < trial.options.paths / 10 + 1; ++k) {
    const Vector normal = trial.random.direction(), along = trial.random.direction_across(normal);
    const double other = trial.scales.overlap * trial.random.uniform(0.3, 0.9);
    const bool opening = trial.random.chance(0.5);  // where the slip is, the way round matters
    const double out = opening ? trial.scales.overlap : other, back = opening ? other : trial.scales.overlap;
    const Vector slip = along * out * minimum<double>(friction, 1.0) * trial.random.log_uniform(1e-3, 0.03);
    Path path{trial.move(normal, out)};
    for (int i = 0; i < cycles; ++i)
      for (const auto& [overlap, by] :
           {std::pair(out, slip), {back, Vector(0, 0, 0)}, {back, Vector(-slip)}, {out, Vector(0, 0, 0)}})
        path.push_back(trial.move(normal, overlap, by));
    for (Motion& m : path) {  // slowly: a dashpot that opens the contact makes it forget
      m.dt *= 1e4;
      m.velocity = m.velocity / 1e4;
    }
    settle(path);
    tried.push_back(path);
  }
  return trial.judge(name, "of the largest force, in eight cycles", tried, [&](const Path& path) {
    Finding finding{0.0, cycles * trial.rounding()};
    if (path.size() < 1 + 2 * steps_of_cycle || (path.size() - 1) % steps_of_cycle != 0) return finding;
    // Whole cycles alone: what is left of a broken one leads elsewhere.
    const Scene scene = trial.scene(path);
    detail::State<Law> state = start_of(trial.law);
    Answers all;
    Vector first(0, 0, 0), drift(0, 0, 0), slipped(0, 0, 0);
    for (std::size_t i = 0; i < path.size(); ++i) {
      all.push_back(trial.law(scene[i].bodies, scene[i].dt, state));
      slipped = slipped + across(path[i].velocity, path[i].normal) * path[i].dt;
      if (i == 0 || i % steps_of_cycle != 0) continue;
      const bool closed = norm<double>(slipped) <= 1e-9 * trial.scales.overlap && path[i].overlap == path[0].overlap;
      if (!closed) return Finding{};
      const Vector force = force_at_rest(trial.law, scene[i], state);
      if (i == steps_of_cycle) first = force;
      drift = force - first;
    }
    finding.error = norm<double>(drift) / largest_force(all);
    return finding;
  });
}

}  // namespace contactlaws::verify

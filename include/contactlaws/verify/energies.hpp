// SPDX-License-Identifier: MIT
// Energy on closed loops: from open to open, whatever is done in between, a contact takes work and gives none.
//
// The work of a step is booked so that springs come out exactly: -[(f_before + f_now)/2 + (F - f_now)] . v dt, where F is the
// answer and f the force at rest; what the dashpots add is counted at the velocity that it belongs to. On steps between
// neighbours of a few overlaps the elastic normal work then cancels to the last digit.
#pragma once

#include "contactlaws/verify/trial.hpp"

namespace contactlaws::verify {

namespace detail {

struct Work {
  double done = 0.0;   ///< on the contact [J]
  double moved = 0.0;  ///< the work of all steps, without sign [J]
};

template <class Law>
Work work_along(const Trial<Law>& trial, const Path& path) {
  using std::fabs;
  const Scene scene = trial.scene(path);
  State<Law> state = start_of(trial.law);
  Work work;
  Vector before(0, 0, 0);
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Interaction answer = trial.law(scene[i].bodies, scene[i].dt, state);
    const Vector spring = force_at_rest(trial.law, scene[i], state);
    if (i == 0) before = Vector(path[0].normal * -answer.bridge_force);  // a bridge pulls from the start
    const Vector force = (before + spring) / 2 + (answer.force - spring);
    const double step = -dot<double>(force, path[i].velocity) * path[i].dt;
    work.done += step;
    work.moved += fabs(step);
    before = spring;
  }
  return work;
}

/// What the path gains, relative to the work moved: if steps cut in four and in eight agree on it, so that it is the law's and
/// not the sum's. Allowed is a millionth.
template <class Law>
Finding gain_along(const Trial<Law>& trial, const Path& path) {
  using std::fabs;
  Finding finding{0.0, 1e-6};
  if (path.empty() || path.back().overlap > -trial.options.claims.range.value_or(0.0)) return finding;
  if (!(work_along(trial, path).done < 0.0)) return finding;
  const Work fine = work_along(trial, refined(path, 4)), finer = work_along(trial, refined(path, 8));
  if (fabs(finer.done - fine.done) <= 0.5 * fabs(finer.done)) finding.error = -finer.done / finer.moved;
  return finding;
}

/// Up from touch, to and fro between four overlaps and along the contact plane, back to no slip, and open. The overlap goes slowly, so that the
/// normal dashpot does not hide what the springs yield; slip goes at any speed.
inline Path random_loop(Random& random, const Scales& scales, double friction, double gap) {
  constexpr int levels = 4;
  const Vector normal = random.direction(), along = random.direction_across(normal);
  const double slow = 1e4 * scales.time, slip = scales.overlap * random.log_uniform(0.01, 5.0) * friction;
  Path path;
  int level = 0;
  double slipped = 0.0;
  const auto go = [&](int to) {
    level = to;
    path.push_back({normal, scales.overlap * level / levels, Vector(0, 0, 0), slow, 0.0});
  };
  const auto slide = [&](double by) {
    go(level);
    path.back().dt = scales.time * random.log_uniform(0.1, 1e4);
    path.back().velocity = along * (by / path.back().dt);
    slipped += by;
  };
  const double first = random.uniform(0.0, levels);
  while (level < first) go(level + 1);
  const double moves = random.uniform(2.0, 16.0);
  for (int i = 0; i < moves; ++i) {
    if (random.chance(0.5)) {
      slide(random.uniform(-1, 1) * slip);
    } else {
      go(level == levels || (level > 1 && random.chance(0.5)) ? level - 1 : level + 1);
    }
  }
  slide(-slipped);
  while (level > 0) go(level - 1);
  if (gap > 0.0) path.push_back({normal, -gap * (1 + 1e-6), Vector(0, 0, 0), slow, 0.0});
  settle(path);
  return path;
}

}  // namespace detail

template <class Law>
Result closed_loops(const Trial<Law>& trial) {
  constexpr const char* name = "energy on closed loops";
  const Claims& claims = trial.options.claims;
  if (!claims.passive) return not_claimed(name);
  std::vector<Path> loops;
  constexpr int loops_per_path = 20;  // few loops pay; a loop is cheap
  for (int i = 0; i < loops_per_path * trial.options.paths; ++i)
    loops.push_back(detail::random_loop(trial.random, trial.scales, minimum<double>(claims.friction.value_or(1.0), 1.0),
                                        claims.range.value_or(0.0)));
  return trial.judge(name, "of the work, gained", loops,
                     [&](const Path& path) { return detail::gain_along(trial, path); });
}

}  // namespace contactlaws::verify

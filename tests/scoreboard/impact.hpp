// A head-on impact, m* dv/dt = F with a law's own force: by Runge-Kutta, fourth order, in steps that shrink towards touch,
// where o^(1/4) has no derivatives; and by leapfrog, as DEM codes step.
#pragma once

#include <algorithm>
#include <cmath>

#include "contactlaws/contact_law.hpp"
#include "random.hpp"

namespace contactlaws::test {

struct Impact {
  double deepest = 0.0;        ///< [m]
  double largest_force = 0.0;  ///< [N]
  double duration = 0.0;       ///< [s]
  double restitution = 0.0;    ///< [1]
};

/// `steps` in about `duration` [s]. Of laws without a memory between the stages of a step: elastic, or with dashpots.
template <class Law>
Impact integrate_impact(const Law& law, const PairProperties<double>& pair, double speed, int steps, double duration) {
  struct Motion {
    double overlap, separating;
  };
  const auto force_at = [&](const Motion& m) {
    return law.step(pair, {{0, 0, 1}, m.overlap, {0, 0, m.separating}, 1.0}, {}).normal_force;
  };
  const auto rate = [&](const Motion& m) { return Motion{-m.separating, force_at(m) / pair.effective_mass}; };
  const auto ahead = [](const Motion& m, const Motion& r, double dt) {
    return Motion{m.overlap + dt * r.overlap, m.separating + dt * r.separating};
  };
  const double touch = 1e-15 * speed * duration;
  Motion m{touch, -speed};
  Impact impact;
  while (m.overlap >= touch) {
    const Motion before = m;
    const double dt = std::min(duration / steps, 0.02 * m.overlap / std::abs(m.separating) + 1e-18 * duration);
    const Motion a = rate(m), b = rate(ahead(m, a, dt / 2)), c = rate(ahead(m, b, dt / 2)), d = rate(ahead(m, c, dt));
    m.overlap += dt / 6 * (a.overlap + 2 * b.overlap + 2 * c.overlap + d.overlap);
    m.separating += dt / 6 * (a.separating + 2 * b.separating + 2 * c.separating + d.separating);
    impact.duration += dt;
    impact.largest_force = std::max(impact.largest_force, force_at(m));
    if (before.separating < 0.0 && m.separating >= 0.0) {  // the turn, within this step at nearly constant force
      const double share = -before.separating / (m.separating - before.separating);
      impact.deepest = before.overlap - before.separating * share * dt / 2;
      impact.largest_force = std::max(impact.largest_force, force_at({impact.deepest, 0.0}));
    }
  }
  impact.restitution = m.separating / speed;
  return impact;
}

/// The same by leapfrog in steps of `dt` [s], the first of which ends `phase` of a step after touch. For any law.
template <class Law>
Impact leap_through_impact(const Law& law, const PairProperties<double>& pair, double speed, double dt, double phase) {
  typename Law::State state{};
  double overlap = phase * dt * speed, separating = -speed, force = 0.0, last = 0.0;
  Impact impact;
  for (int i = 0; i < 10000000 && overlap > 0.0; ++i) {
    const auto step = law.step(pair, {{0, 0, 1}, overlap, {0, 0, separating}, dt}, state);
    state = step.state;
    force = step.normal_force;
    separating += force / pair.effective_mass * dt;
    last = overlap;
    overlap -= separating * dt;
    impact.deepest = std::max(impact.deepest, overlap);
    impact.largest_force = std::max(impact.largest_force, force);
    impact.duration += dt;
  }
  // The last force acted for a whole step, from half a step before its overlap; contact ended at overlap/velocity after.
  impact.restitution = (separating + force / pair.effective_mass * (last / separating - dt / 2)) / speed;
  return impact;
}

}  // namespace contactlaws::test

// SPDX-License-Identifier: MIT
// What bounds a contact force: friction, no tension, no jump at touch, nothing across a gap, always a number; and that its
// stiffness is its derivative.
#pragma once

#include <cmath>

#include "contactlaws/verify/trial.hpp"

namespace contactlaws::verify {

/// From finite motion a finite force: also at touch itself, at rest, and in a step of no duration.
template <class Law>
Result finite_force(const Trial<Law>& trial) {
  std::vector<Path> tried = trial.paths;
  for (Path& path : tried) {
    Motion last = path.back();
    for (const double overlap : {0.0, 1e-9, 1.0}) {
      last.overlap = overlap * trial.scales.overlap;
      path.push_back(last);
    }
    last.velocity = Vector(0, 0, 0);
    path.push_back(last);
    last.dt = 0.0;
    path.push_back(last);
    settle(path);
  }
  return trial.judge("finite force", "steps with a force that is no number", tried, [&](const Path& path) {
    Finding finding;
    for (const Interaction& a : answers(trial.law, trial.scene(path))) {
      const bool finite = a.force.allFinite() && (!a.force1 || a.force1->allFinite()) &&
                          (!a.torque1 || a.torque1->allFinite()) && (!a.torque2 || a.torque2->allFinite());
      finding.error += finite ? 0.0 : 1.0;
    }
    return finding;
  });
}

template <class Law>
Result coulomb_bound(const Trial<Law>& trial) {
  constexpr const char* name = "Coulomb bound";
  if (!trial.options.claims.friction) return not_claimed(name);
  const double friction = *trial.options.claims.friction;
  return trial.judge(name, "of the largest force, beyond mu F_n", [&](const Path& path) {
    const Answers all = answers(trial.law, trial.scene(path));
    Finding finding{0.0, trial.rounding()};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double pressing = dot<double>(all[i].force, path[i].normal) + all[i].bridge_force;
      const double shear = norm<double>(across(all[i].force, path[i].normal));
      const double beyond = (shear - friction * positive_part<double>(pressing)) / largest_force(all);
      finding.see(beyond);
    }
    return finding;
  });
}

/// A long slide is resisted by mu F_n, straight against the slip. Long: ten times 1 + mu the usual overlap in one step, since
/// a shear stiffness is rarely below a tenth of the normal one.
template <class Law>
Result friction_reached(const Trial<Law>& trial) {
  constexpr const char* name = "friction reached";
  if (!trial.options.claims.friction) return not_claimed(name);
  const double friction = *trial.options.claims.friction;
  const double far = 10 * (1 + friction) * trial.scales.overlap;
  std::vector<Path> slides;
  for (int k = 0; k < trial.options.paths / 10 + 1; ++k) {
    const Vector normal = trial.random.direction(), along = trial.random.direction_across(normal);
    const double overlap = trial.scales.overlap * trial.random.uniform(0.1, 1.0);
    Path path{trial.move(normal, overlap)};
    for (int i = 0; i < 3; ++i) path.push_back(trial.move(normal, overlap, far * along));
    settle(path);
    slides.push_back(path);
  }
  return trial.judge(name, "of the friction asked", slides, [&](const Path& path) {
    if (path.empty()) return Finding{};
    const Interaction last = answers(trial.law, trial.scene(path)).back();
    const Motion& m = path.back();
    const Vector slip = across(m.velocity, m.normal);
    const double strength = friction * (dot<double>(last.force, m.normal) + last.bridge_force);
    if (!(strength > 0.0) || norm<double>(slip) * m.dt < 0.99 * far) return Finding{};
    const Vector expected = slip.normalized() * -strength;
    return Finding{norm<double>(across(last.force, m.normal) - expected) / strength, trial.rounding()};
  });
}

template <class Law>
Result no_tension(const Trial<Law>& trial) {
  constexpr const char* name = "no tension";
  if (!trial.options.claims.no_tension) return not_claimed(name);
  return trial.judge(name, "of the largest force", [&](const Path& path) {
    const Answers all = answers(trial.law, trial.scene(path));
    Finding finding{0.0, trial.rounding()};
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double pull = -dot<double>(all[i].force, path[i].normal) / largest_force(all);
      finding.see(pull);
    }
    return finding;
  });
}

namespace detail {

/// The jump of force of a new contact from an overlap of -d to one of d, at d = 1e-7 of the usual, over that at 1e-5: goes to
/// 1 where there is one, and is 10^-2p where force grows as d^p, so 0.32 even for a dashpot that grows as d^(1/4).
template <class Law>
Result jump_at_touch(const Trial<Law>& trial, const char* name, double speed) {
  std::vector<Path> touches;
  for (int k = 0; k < trial.options.paths / 10 + 1; ++k) {
    const Vector normal = trial.random.direction();
    const Vector velocity = speed * (trial.random.direction_across(normal) - normal);
    const double dt = 1e-5 * trial.scales.time;
    touches.push_back({{normal, 1e-7 * trial.scales.overlap, velocity, dt, 0.0}});
  }
  return trial.judge(name, "of it is left when the overlap falls to a hundredth", touches, [&](const Path& path) {
    const auto jump = [&](double overlap) {
      const auto force = [&](double at) {
        Path one = path;
        one.front().overlap = at;
        return answers(trial.law, trial.scene(one)).front().force;
      };
      return norm<double>(force(overlap) - force(-overlap));
    };
    if (path.empty()) return Finding{};
    const double near = jump(1e-7 * trial.scales.overlap), far = jump(1e-5 * trial.scales.overlap);
    // A jump of a millionth, or within what the overlap is rounded by, is none.
    if (near <= 1e-6 * trial.scales.force || near <= trial.rounding() * trial.scales.force) return Finding{0.0, 0.5};
    return Finding{near / far, 0.5};
  });
}

}  // namespace detail

template <class Law>
Result continuity_at_touch(const Trial<Law>& trial) {
  constexpr const char* name = "continuity at touch";
  if (!trial.options.claims.continuous_at_touch) return not_claimed(name);
  return detail::jump_at_touch(trial, name, 0.0);
}

template <class Law>
Result continuity_in_motion(const Trial<Law>& trial) {
  constexpr const char* name = "continuity in motion";
  if (!trial.options.claims.continuous_in_motion) return not_claimed(name);
  return detail::jump_at_touch(trial, name, trial.scales.speed());
}

/// Beyond its range a contact exerts nothing; when it closes again, it starts without shear.
template <class Law>
Result open_contact(const Trial<Law>& trial) {
  constexpr const char* name = "open contact";
  if (!trial.options.claims.range) return not_claimed(name);
  const double gap = *trial.options.claims.range * (1 + 1e-6) + 1e-3 * trial.scales.overlap;
  return trial.judge(name, "of the largest force", [&](const Path& path) {
    Path further = path;
    const Vector normal = path.empty() ? Vector(0, 0, 1) : path.back().normal;
    further.push_back(trial.move(normal, -gap));
    further.push_back(trial.move(normal, trial.scales.overlap));
    settle(further);
    const Answers all = answers(trial.law, trial.scene(further));
    const double across_gap = norm<double>(all[path.size()].force);
    const double shear = norm<double>(across(all.back().force, normal));
    return Finding{maximum<double>(across_gap, shear) / largest_force(all), trial.rounding()};
  });
}

/// The stiffness that the law tells is the slope of its force at rest: of loading or of unloading, where these differ;
/// and of a small slip of a new contact. Differences over h = 1e-6 of the overlap o: what a plastic
/// contact has left of o may be a hundredth, so 1e-4; and rounding times o/h.
template <class Law>
Result stiffness_is_derivative(const Trial<Law>& trial) {
  constexpr const char* name = "derivative = stiffness";
  if constexpr (!detail::offers<detail::OwnStiffness, Law>) {
    return not_offered(name);
  } else {
    using std::fabs;
    return trial.judge(name, "of the stiffness", [&](const Path& path) {
      Finding finding{0.0, 1e-3 + 1e5 * trial.rounding()};  // rounding() counts a hundred roundings, here are ten
      if (path.empty() || !(path.back().overlap > 0.0)) return finding;
      const Vector& normal = path.back().normal;
      const double overlap = path.back().overlap, h = 1e-6 * overlap;
      const auto force_at = [&](Path way) {  // the last step at rest
        settle(way);
        const Scene scene = trial.scene(way);
        detail::State<Law> state = start_of(trial.law);
        answers(trial.law, scene, state);
        return force_at_rest(trial.law, scene.back(), state);
      };
      const auto moved = [&](const Path& way, double by, const Vector& slip) {
        Path further = way;
        further.push_back(trial.move(normal, overlap + by, slip));
        return force_at(further);
      };
      const auto told = [&](const Path& way) {
        detail::State<Law> state = start_of(trial.law);
        const Scene scene = trial.scene(way);
        answers(trial.law, scene, state);
        return trial.law.stiffness(scene.back().bodies, state);
      };
      const Vector none(0, 0, 0);
      const auto along = [&](double by) { return dot<double>(moved(path, by, none), normal); };
      const double here = along(0.0), loading = (along(h) - here) / h, unloading = (here - along(-h)) / h;
      const double normal_stiffness = told(path).normal;
      const double scale = maximum<double>(fabs(normal_stiffness), maximum<double>(fabs(loading), fabs(unloading)));
      if (!(scale * overlap <= 1e-6 * trial.scales.force))  // a NaN is looked at
        finding.see(minimum<double>(fabs(loading - normal_stiffness), fabs(unloading - normal_stiffness)) / scale);

      const double friction = trial.options.claims.friction.value_or(1.0);
      if (!(friction > 0.0)) return finding;
      const Path closing{trial.move(normal, overlap)};
      const double slip = 1e-3 * minimum<double>(friction, 1.0) * overlap;
      const Vector sheared =
          moved(closing, 0.0, slip * Rotation(Eigen::Quaterniond::FromTwoVectors(Vector(0, 0, 1), normal)).col(0));
      const double slope = norm<double>(across(sheared, normal)) / slip, shear_stiffness = told(closing).shear;
      const double larger_one = maximum<double>(fabs(shear_stiffness), slope);
      if (!(larger_one * overlap <= 1e-6 * trial.scales.force)) {
        const double off = fabs(slope - shear_stiffness) / larger_one;
        finding.see(off);
      }
      return finding;
    });
  }
}

}  // namespace contactlaws::verify

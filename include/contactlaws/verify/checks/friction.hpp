// SPDX-License-Identifier: MIT
// Friction: never more than its coefficient allows, as much as it claims in a long slide, and no slip left out.
#pragma once

#include "contactlaws/verify/setup.hpp"

namespace contactlaws::verify {

namespace detail {

/// The force that friction multiplies: the normal force, and the pulls that press the surfaces together within it [N].
inline double friction_load(const Setup& setup, const Interaction& i, const Vector& normal) {
  return positive_part<double>(dot<double>(i.force, normal) + i.bridge_force + setup.options.claims.adhesion);
}

/// Straight slides at a constant overlap in this number of steps, and longer by half than gross sliding needs: ten times
/// 1 + mu the overlap, since a shear stiffness is rarely below a tenth of the normal one.
inline double long_slide(const Claims& claims, double overlap) {
  return 10 * (1 + claims.static_friction.value_or(claims.friction.value_or(0.0))) * overlap;
}
inline std::vector<Path> slides(const Setup& setup, const char* name, int steps) {
  return setup.make_paths(name, setup.few(), [&](Random& random, const Vector& normal, const Vector& along) {
    const double overlap = setup.scales.overlap * random.uniform(0.1, 1.0);
    const Vector slip = along * (1.5 * long_slide(setup.options.claims, overlap) / steps);
    Path path(static_cast<std::size_t>(steps) + 1, setup.move(normal, overlap, slip));
    path.front() = setup.move(normal, overlap);
    return path;
  });
}

inline bool is_long_slide(const Setup& setup, const Path& path) {
  Vector slipped(0, 0, 0);
  for (const Motion& m : path) slipped = slipped + tangential(m.velocity, m.normal) * m.dt;
  return !path.empty() && norm<double>(slipped) >= 0.99 * long_slide(setup.options.claims, path.back().overlap);
}

}  // namespace detail

inline Result coulomb_bound(const Setup& setup, const char* name) {
  const Claims& claims = setup.options.claims;
  const double friction = claims.static_friction.value_or(*claims.friction);
  return setup.worst_of(name, "of the largest force, beyond mu F_n", [&](const Path& path) {
    const Record record = setup.drive_along(path);
    Finding finding{0.0, setup.scales.rounding};
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Interaction& i = record.interactions[k];
      const double shear = norm<double>(tangential(i.force, path[k].normal));
      finding.add((shear - friction * detail::friction_load(setup, i, path[k].normal)) / record.largest_force());
    }
    return finding;
  });
}

/// At the end of a long slide, in few steps or in many, shear is mu F_n, straight against the slip.
inline Result friction_reached(const Setup& setup, const char* name) {
  std::vector<Path> slides = detail::slides(setup, name, 2);
  for (const Path& slow : detail::slides(setup, name, 200)) slides.push_back(slow);
  return setup.worst_of(name, "of the friction claimed", slides, [&](const Path& path) {
    if (!detail::is_long_slide(setup, path)) return Finding{};
    const Motion& m = path.back();
    const Interaction last = setup.drive_along(path).interactions.back();
    const Vector slip = tangential(m.velocity, m.normal);
    const double strength = *setup.options.claims.friction * detail::friction_load(setup, last, m.normal);
    if (!(strength > 0.0 && norm<double>(slip) > 0.0)) return Finding{};
    const Vector expected = slip.normalized() * -strength;
    return Finding{norm<double>(tangential(last.force, m.normal) - expected) / strength, setup.scales.rounding};
  });
}

/// Before the first slip of a slow slide, shear reaches the static coefficient, but for its rise in one step.
inline Result static_friction_reached(const Setup& setup, const char* name) {
  std::vector<Path> slides = detail::slides(setup, name, 500);
  for (Path& path : slides) slow_down(path, 1e4);  // the dashpot counts within the limit
  return setup.worst_of(name, "of the friction claimed", slides, [&](const Path& path) {
    const Record record = setup.drive_along(path);
    double last = 0.0, rise = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Interaction& i = record.interactions[k];
      const double load = detail::friction_load(setup, i, path[k].normal);
      const double now = load > 0.0 ? norm<double>(tangential(i.force, path[k].normal)) / load : 0.0;
      rise = maximum<double>(rise, now - last);
      largest = maximum<double>(largest, now);
      last = now;
    }
    const double claimed = *setup.options.claims.static_friction;
    if (!(claimed > 0.0) || !detail::is_long_slide(setup, path)) return Finding{};
    return Finding{(claimed - largest) / claimed, rise / claimed + setup.scales.rounding};
  });
}

/// A slow slide (and roll) whose steps double, from 1e-9 of the overlap on: the springs hold what they hold when each step
/// is done in eight. A law that drops small slips, or slow ones, differs by all of it at one of the steps; a law that
/// follows a curve with large steps, by some per cent. Relative to the spring's force, less what rounding makes of it.
inline Result slip_in_small_steps(const Setup& setup, const char* name) {
  constexpr int doublings = 31, parts = 8;
  const auto slides =
      setup.make_paths(name, setup.few(), [&](Random& random, const Vector& normal, const Vector& along) {
        const double overlap = setup.scales.overlap * random.uniform(0.1, 1.0);
        double slip = 1e-9 * overlap;
        Path path{setup.move(normal, overlap)};
        for (int i = 0; i < doublings; ++i, slip *= 2) {
          path.push_back({normal, overlap, along * (slip / setup.scales.time / 1e4), 1e4 * setup.scales.time});
          path.back().relative_spin = path.back().velocity / setup.scales.length;
        }
        return path;
      });
  return setup.worst_of(name, "of the spring's force, when a step is cut in eight", slides, [&](const Path& path) {
    const Trajectory whole = setup.trajectory(path);
    ForceUpdate::State once = setup.update.start(), cut = once;
    Finding finding{0.0, 0.25};
    for (std::size_t i = 0; i < path.size(); ++i) {
      const bool slides_only = i > 0 && path[i].overlap == path[i - 1].overlap && path[i].normal == path[i - 1].normal;
      Motion part = path[i];
      if (slides_only) {
        part.velocity = part.velocity / parts;
        part.relative_spin = part.relative_spin / parts;
      }
      const Instant in_part = setup.trajectory({part}).front();
      setup.update.step(whole[i].bodies, whole[i].dt, once);
      for (int k = 0; k < (slides_only ? parts : 1); ++k) setup.update.step(in_part.bodies, in_part.dt, cut);
      Load a = load_at_rest(setup.update, whole[i], once), b = load_at_rest(setup.update, whole[i], cut);
      const double floor = setup.scales.rounding * maximum<double>(load_norm(a), load_norm(b));
      for (Load* load : {&a, &b}) load->head<3>() = tangential(load->head<3>(), path[i].normal);
      const auto compare = [&](const Vector& x, const Vector& y) {
        const double larger = maximum<double>(norm<double>(x), norm<double>(y));
        if (!(larger <= floor)) finding.add((norm<double>(x - y) - floor) / larger);
      };
      compare(a.head<3>(), b.head<3>());
      compare(a.tail<3>(), b.tail<3>());
    }
    return finding;
  });
}

}  // namespace contactlaws::verify

// SPDX-License-Identifier: MIT
// Bounds of a contact force: always finite, no tension, no jump at touch, zero across a gap; and its stiffness.
#pragma once

#include <cmath>

#include "contactlaws/verify/setup.hpp"

namespace contactlaws::verify {

namespace detail {

/// The random paths, each ending at touch, a hair below it, and at the usual overlap in motion, at rest and with dt = 0.
inline std::vector<Path> paths_to_touch(const Setup& setup) {
  std::vector<Path> all = setup.paths;
  for (Path& path : all) {
    Motion last = path.back();
    for (const double overlap : {0.0, 1e-9, 1.0}) {
      last.overlap = overlap * setup.scales.overlap;
      path.push_back(last);
    }
    last.velocity = Vector(0, 0, 0);
    path.push_back(last);
    last.dt = 0.0;
    path.push_back(last);
    set_normal_velocities(path);
  }
  return all;
}

}  // namespace detail

/// From finite motion a finite force.
inline Result finite_force(const Setup& setup, const char* name) {
  const auto measure = [&](const Path& path) {
    Finding finding;
    for (const Interaction& i : setup.drive_along(path).interactions) {
      const bool finite = i.force.allFinite() && (!i.force1 || i.force1->allFinite()) &&
                          (!i.torque1 || i.torque1->allFinite()) && (!i.torque2 || i.torque2->allFinite());
      finding.error += finite ? 0.0 : 1.0;
    }
    return finding;
  };
  return setup.worst_of(name, "steps with a force that is no number", detail::paths_to_touch(setup), measure);
}

inline Result no_tension(const Setup& setup, const char* name) {
  return setup.worst_of(name, "of the largest force", detail::paths_to_touch(setup), [&](const Path& path) {
    const Record record = setup.drive_along(path);
    Finding finding{0.0, setup.scales.rounding};
    for (std::size_t i = 0; i < path.size(); ++i)
      finding.add(-dot<double>(record.interactions[i].force, path[i].normal) / record.largest_force());
    return finding;
  });
}

namespace detail {

/// The jump of force of a new contact from an overlap of -d to one of d, at d = 1e-7 of the usual, over that at 1e-5:
/// tends to 1 where there is a jump, and is 10^-2p where the force grows as d^p: 0.32 for a dashpot that grows as d^(1/4).
inline Result jump_at_touch(const Setup& setup, const char* name, double speed) {
  auto touches = setup.make_paths(name, setup.few(), [&](Random&, const Vector& normal, const Vector& along) {
    return Path{{normal, 1e-7 * setup.scales.overlap, along, 1e-5 * setup.scales.time}};
  });
  for (Path& path : touches)
    path.front().velocity = speed * (tangential(path.front().velocity, path.front().normal) - path.front().normal);
  return setup.worst_of(name, "of it is left when the overlap falls to a hundredth", touches, [&](const Path& path) {
    const auto force = [&](double at) {
      Path one = path;
      one.front().overlap = at;
      return setup.drive_along(one).interactions.front().force;
    };
    const auto jump = [&](double overlap) { return norm<double>(force(overlap) - force(-overlap)); };
    if (path.empty()) return Finding{};
    const double near = jump(1e-7 * setup.scales.overlap), far = jump(1e-5 * setup.scales.overlap);
    // A jump of a millionth, or within the rounding of the overlap, is none.
    if (near <= 1e-6 * setup.scales.force || near <= setup.scales.rounding * setup.scales.force)
      return Finding{0.0, 0.5};
    return Finding{near / far, 0.5};
  });
}

}  // namespace detail

inline Result continuity_at_touch(const Setup& setup, const char* name) {
  return detail::jump_at_touch(setup, name, 0.0);
}

inline Result continuity_in_motion(const Setup& setup, const char* name) {
  return detail::jump_at_touch(setup, name, setup.scales.speed());
}

/// Beyond its range a contact exerts nothing; when it closes again, it starts without shear and without a couple.
inline Result open_contact(const Setup& setup, const char* name) {
  const double gap = *setup.options.claims.range * (1 + 1e-6) + 1e-3 * setup.scales.overlap;
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    Path further = path;
    const Vector normal = path.empty() ? Vector(0, 0, 1) : path.back().normal;
    further.push_back(setup.move(normal, -gap));
    further.push_back(setup.move(normal, setup.scales.overlap));
    set_normal_velocities(further);
    const Record record = setup.drive_along(further);
    Load closed = record.loads.back();
    closed.head<3>() = tangential(closed.head<3>(), normal);
    Finding finding{load_norm(record.loads[path.size()]) / record.largest_force(), setup.scales.rounding};
    finding.add(load_norm(closed) / record.largest_force());
    return finding;
  });
}

/// The stiffness of the law is the slope of its force at rest in the direction in which the overlap moved last, and that of
/// a small slip of a new contact. Differences over h = 1e-6 of the overlap o: the elastic part of a plastic contact may be
/// a thousandth of o, so 1e-3; and rounding times o/h, of which Scales::rounding counts a hundred and here are ten.
inline Result stiffness_is_derivative(const Setup& setup, const char* name) {
  return setup.worst_of(name, "of the stiffness", [&](const Path& path) {
    using std::fabs;
    Finding finding{0.0, 1e-3 + 1e5 * setup.scales.rounding};
    if (path.empty() || !(path.back().overlap > 0.0)) return finding;
    const Vector& normal = path.back().normal;
    const double overlap = path.back().overlap;
    double before = 0.0;
    for (const Motion& m : path)
      if (m.overlap != overlap) before = m.overlap;
    const double h = overlap > before ? 1e-6 * overlap : -1e-6 * overlap;
    const auto force_after = [&](Path way, double by, const Vector& slip) {
      way.push_back(setup.move(normal, overlap + by, slip));
      set_normal_velocities(way);
      const Trajectory trajectory = setup.trajectory(way);
      return Vector(load_at_rest(setup.update, trajectory.back(), drive(setup.update, trajectory).state).head<3>());
    };
    const auto stiffness = [&](const Path& way) {
      const Trajectory trajectory = setup.trajectory(way);
      return setup.update.stiffness(trajectory.back().bodies, drive(setup.update, trajectory).state);
    };
    const auto compare = [&](double claimed, double slope) {
      const double scale = maximum<double>(fabs(claimed), fabs(slope));
      if (!(scale * overlap <= 1e-6 * setup.scales.force)) finding.add(fabs(slope - claimed) / scale);  // adds a NaN
    };
    const Vector none(0, 0, 0);
    const Vector rise = force_after(path, h, none) - force_after(path, 0.0, none);
    compare(stiffness(path).normal, dot<double>(rise, normal) / h);

    const double friction = setup.options.claims.friction.value_or(1.0);
    if (!(friction > 0.0)) return finding;
    const Path closing{setup.move(normal, overlap)};
    const double slip = 1e-3 * minimum<double>(friction, 1.0) * overlap;
    const Vector along = rotation_between(Vector(0, 0, 1), normal).col(0);
    compare(stiffness(closing).shear, norm<double>(tangential(force_after(closing, 0.0, slip * along), normal)) / slip);
    return finding;
  });
}

}  // namespace contactlaws::verify

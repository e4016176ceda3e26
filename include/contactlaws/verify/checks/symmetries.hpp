// SPDX-License-Identifier: MIT
// Properties of every law: action and reaction, and no preferred observer, numbering of the bodies, or unit.
//
// Allowed errors: rounding (Scales::rounding) where the same numbers are computed in another frame; for a turn of the
// contact in steps of an angle a, 2 a^2 a step: projecting the shear onto the new plane loses a^2/2 of it.
#pragma once

#include <cmath>

#include "contactlaws/verify/setup.hpp"

namespace contactlaws::verify {

namespace detail {

/// The largest difference between two interactions, in forces of `force` [N] and torques of force times `arm` [m].
inline double difference(const Interaction& a, const Interaction& b, double force, double arm) {
  Finding largest{norm<double>(a.force - b.force) / force};
  const auto compare = [&](const std::optional<Vector>& x, const std::optional<Vector>& y, double scale) {
    if (x && y) largest.add(norm<double>(*x - *y) / scale);
  };
  compare(a.force1, b.force1, force);
  compare(a.torque1, b.torque1, force * arm);
  compare(a.torque2, b.torque2, force * arm);
  return largest.error;
}

/// The difference between the interactions along the path, and those of another observer, translated back.
template <class Observe, class Translate>
Finding invariance(const Setup& setup, const Path& path, const ForceUpdate& update, const Observe& observe,
                   const Translate& back) {
  const Trajectory here = setup.trajectory(path);
  Trajectory there;
  double time = 0.0;
  for (const Instant& i : here) there.push_back(observe(i, time += i.dt));
  const Record expected = drive(setup.update, here), found = drive(update, there);
  const double largest = expected.largest_force();
  Finding finding{0.0, setup.scales.rounding};
  for (std::size_t i = 0; i < here.size(); ++i)
    finding.add(difference(expected.interactions[i], back(found.interactions[i]), largest, setup.scales.length));
  return finding;
}

template <class Change>
Bodies changed(const Bodies& b, const Change& change) {
  return {change(b.one), change(b.two)};
}
template <class OfForce, class OfTorque>
Interaction changed(const Interaction& i, const OfForce& force, const OfTorque& torque) {
  const auto apply = [](const std::optional<Vector>& v, const auto& f) { return v ? std::optional<Vector>(f(*v)) : v; };
  return {force(i.force), apply(i.force1, force), apply(i.torque1, torque), apply(i.torque2, torque)};
}

}  // namespace detail

inline Result third_law(const Setup& setup, const char* name) {
  return setup.worst_of(name, "of the force", [&](const Path& path) {
    Finding finding{0.0, 4 * setup.options.epsilon};  // a sum and a sign
    for (const Interaction& i : setup.drive_along(path).interactions) {
      if (!i.force1) continue;
      const double force = norm<double>(i.force), off = norm<double>(i.force + *i.force1);
      if (!(off <= 0.0)) finding.add(off / force);
    }
    return finding;
  });
}

/// Angular momentum about the centre of body 1: the torques and the moment of the force on body 2 add up to zero. A
/// couple on one body needs the opposite one on the other.
inline Result torque_balance(const Setup& setup, const char* name) {
  return setup.worst_of(name, "of force times distance", [&](const Path& path) {
    const Trajectory trajectory = setup.trajectory(path);
    const Record record = drive(setup.update, trajectory);
    const double scale = record.largest_force() * setup.scales.length;
    Finding finding{0.0, 100 * setup.options.epsilon};  // some dozen products and sums
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Interaction& i = record.interactions[k];
      if (!i.torque1 || !i.torque2) continue;
      const Vector sum = *i.torque1 + *i.torque2 + trajectory[k].bodies.branch().cross(i.force);
      finding.add(norm<double>(sum) / scale);
    }
    return finding;
  });
}

inline Result frame_indifference(const Setup& setup, const char* name) {
  const Rotation q = Random(setup.options.seed, name).rotation();
  const auto rotated = [&q](const Body& b) {
    return Body{q * b.position, q * b.velocity, q * b.spin, b.radius, b.mass};
  };
  const auto observe = [&](const Instant& i, double) { return Instant{detail::changed(i.bodies, rotated), i.dt}; };
  const auto turned = [&q](const Vector& v) { return Vector(q.transpose() * v); };
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    return detail::invariance(setup, path, setup.update, observe,
                              [&](const Interaction& i) { return detail::changed(i, turned, turned); });
  });
}

inline Result galilean_invariance(const Setup& setup, const char* name) {
  Random random(setup.options.seed, name);
  const Vector drift = 10 * setup.scales.speed() * random.direction();
  const Vector elsewhere = setup.scales.length * random.direction();
  const auto observe = [&](const Instant& i, double time) {
    const auto moved = [&](const Body& b) {
      return Body{b.position + elsewhere + drift * time, b.velocity + drift, b.spin, b.radius, b.mass};
    };
    return Instant{detail::changed(i.bodies, moved), i.dt};
  };
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    return detail::invariance(setup, path, setup.update, observe, [](const Interaction& i) { return i; });
  });
}

inline Result swap_of_bodies(const Setup& setup, const char* name) {
  const auto observe = [](const Instant& i, double) { return Instant{{i.bodies.two, i.bodies.one}, i.dt}; };
  const auto back = [](const Interaction& i) {
    return Interaction{-i.force, {}, i.torque2, i.torque1};  // force1 is the third law's
  };
  return setup.worst_of(name, "of the largest force",
                        [&](const Path& path) { return detail::invariance(setup, path, setup.update, observe, back); });
}

/// Factors of which no product of small powers is another, so that no wrong dimension of a constant cancels.
inline Result unit_scaling(const Setup& setup, const char* name) {
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    Finding worst{0.0, setup.scales.rounding};
    for (const Units& u : {Units{2.1e3, 1, 1}, Units{1, 3.7e3, 1}, Units{1, 1, 5.3e3}, Units{1.3e-3, 1.9e6, 4.1e3},
                           Units{1.7e6, 2.9e-3, 2.3e-4}, Units{4.3e-2, 1.1e-5, 3.1e-6}}) {
      const auto scaled = [&u](const Body& b) {
        return Body{b.position * u.length, b.velocity * u.velocity(), b.spin / u.time, b.radius * u.length,
                    b.mass * u.mass};
      };
      const auto observe = [&](const Instant& i, double) {
        return Instant{detail::changed(i.bodies, scaled), i.dt * u.time};
      };
      const auto force = [&u](const Vector& v) { return Vector(v / u.force()); };
      const auto torque = [&u](const Vector& v) { return Vector(v / (u.force() * u.length)); };
      const auto back = [&](const Interaction& i) { return detail::changed(i, force, torque); };
      worst.add(detail::invariance(setup, path, setup.update.in_units(u), observe, back).error);
    }
    return worst;
  });
}

namespace detail {

/// Sheared and rolled, then turned as one rigid body: the force, and the couple if claimed, must turn with it. Only steps
/// without slip, rolling and change of overlap are compared.
inline Finding turned_as_one(const Setup& setup, const Path& path) {
  using std::fabs;
  const Trajectory trajectory = setup.trajectory(path);
  ForceUpdate::State state = setup.update.start();
  Load expected = Load::Zero(), found = Load::Zero();
  Vector normal(0, 0, 1);
  double overlap = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Motion& m = path[i];
    setup.update.step(trajectory[i].bodies, m.dt, state);
    found = load_at_rest(setup.update, trajectory[i], state);
    const double slip = norm<double>(tangential(m.velocity, m.normal)) * m.dt;
    const double roll = norm<double>(m.relative_spin) * m.dt * setup.scales.length;
    if (i > 0 && overlap == m.overlap && slip + roll <= 1e-9 * setup.scales.overlap) {
      const double twist = m.normal_spin * m.dt, angle = norm<double>(normal.cross(m.normal)) + fabs(twist);
      const Rotation turn = rotation_about(m.normal, twist) * rotation_between(normal, m.normal);
      expected << turn * expected.head<3>(), turn * expected.tail<3>();
      squares += angle * angle;
    } else {
      expected = found;
      squares = 0.0;
    }
    normal = m.normal;
    overlap = m.overlap;
  }
  const auto error = [](const Vector& off, double scale) { return scale > 0.0 ? norm<double>(off) / scale : 0.0; };
  // A contact without shear, or without a couple, is measured by a thousandth of its normal force.
  const Vector force = expected.head<3>(), couple = expected.tail<3>();
  const double floor = 1e-3 * norm<double>(force);
  Finding finding{error(found.head<3>() - force, norm<double>(tangential(force, normal)) + floor),
                  2 * squares + setup.scales.rounding * 1000};
  if (setup.options.claims.couple_turns) finding.add(error(found.tail<3>() - couple, norm<double>(couple) + floor));
  return finding;
}

inline Result rigid_turn(const Setup& setup, const char* name, const char* measure, bool twist) {
  const int steps = twist ? 20 : 200;
  const double overlap = setup.scales.overlap;
  const auto turns = [&](Random& random, const Vector& start, const Vector& about) {
    const double slip = overlap * random.log_uniform(1e-3, 0.3);
    Path path{setup.move(start, overlap), setup.move(start, overlap, slip * random.direction_across(start))};
    path.back().relative_spin = random.direction_across(start) * (slip / setup.scales.length / path.back().dt);
    for (int i = 1; i <= steps; ++i) {
      const Rotation turn = rotation_about(about, static_cast<double>(i) / steps);
      path.push_back(setup.move(twist ? start : Vector(turn * start), overlap));
      if (twist) path.back().normal_spin = 1.0 / steps / path.back().dt;
    }
    return path;
  };
  return setup.worst_of(name, measure, setup.make_paths(name, setup.few(), turns),
                        [&](const Path& path) { return turned_as_one(setup, path); });
}

}  // namespace detail

inline Result rigid_spin(const Setup& setup, const char* name) {
  return detail::rigid_turn(setup, name, "of the shear force, after a turn of 1 rad", false);
}

inline Result rigid_twist(const Setup& setup, const char* name) {
  return detail::rigid_turn(setup, name, "of the shear force, after a twist of 1 rad", true);
}

}  // namespace contactlaws::verify

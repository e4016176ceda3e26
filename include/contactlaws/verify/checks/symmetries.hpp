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

/// The difference between the interactions along the path, transformed, and those of the transformed trajectory.
template <class OfBodies, class OfInteraction>
Finding invariance(const Setup& setup, const Path& path, const OfBodies& of_bodies, const OfInteraction& transform) {
  const Trajectory here = setup.trajectory(path);
  Trajectory there;
  double time = 0.0;
  for (const Instant& i : here) there.push_back({of_bodies(i.bodies, time += i.dt), i.dt});
  const Record expected = drive(setup.update, here), found = drive(setup.update, there);
  Finding finding{0.0, setup.scales.rounding};
  for (std::size_t i = 0; i < here.size(); ++i)
    finding.add(difference(transform(expected.interactions[i]), found.interactions[i], expected.largest_force(),
                           setup.scales.length));
  return finding;
}

/// Whether any interaction along the random paths has it: an open contact may return a force alone.
template <class Has>
bool ever(const Setup& setup, const Has& has) {
  for (const Path& path : setup.paths)
    for (const Interaction& i : setup.drive_along(path).interactions)
      if (has(i)) return true;
  return false;
}

}  // namespace detail

inline Result third_law(const Setup& setup) {
  constexpr const char* name = "third law";
  if (!detail::ever(setup, [](const Interaction& i) { return i.force1.has_value(); })) return not_offered(name);
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
inline Result torque_balance(const Setup& setup) {
  constexpr const char* name = "torque balance";
  if (!detail::ever(setup, [](const Interaction& i) { return i.torque1 && i.torque2; })) return not_offered(name);
  return setup.worst_of(name, "of force times distance", [&](const Path& path) {
    const Trajectory trajectory = setup.trajectory(path);
    const Record record = drive(setup.update, trajectory);
    Finding finding{0.0, 100 * setup.options.epsilon};  // some dozen products and sums
    for (std::size_t k = 0; k < path.size(); ++k) {
      const Interaction& i = record.interactions[k];
      if (!i.torque1 || !i.torque2) continue;
      const Vector sum = *i.torque1 + *i.torque2 + trajectory[k].bodies.branch().cross(i.force);
      finding.add(norm<double>(sum) / (record.largest_force() * setup.scales.length));
    }
    return finding;
  });
}

inline Result frame_indifference(const Setup& setup) {
  constexpr const char* name = "frame indifference";
  const Rotation q = Random(setup.options.seed, name).rotation();
  const auto turned = [&q](const std::optional<Vector>& v) { return v ? std::optional<Vector>(q * *v) : v; };
  const auto bodies = [&q](Bodies b, double) {
    for (Body* body : {&b.one, &b.two})
      *body = {q * body->position, q * body->velocity, q * body->spin, body->radius, body->mass};
    return b;
  };
  const auto interaction = [&](const Interaction& i) {
    return Interaction{q * i.force, turned(i.force1), turned(i.torque1), turned(i.torque2), i.bridge_force};
  };
  return setup.worst_of(name, "of the largest force",
                        [&](const Path& path) { return detail::invariance(setup, path, bodies, interaction); });
}

inline Result galilean_invariance(const Setup& setup) {
  constexpr const char* name = "Galilean invariance";
  Random random(setup.options.seed, name);
  const Vector drift = 10 * setup.scales.speed() * random.direction();
  const Vector elsewhere = setup.scales.length * random.direction();
  const auto bodies = [&](Bodies b, double time) {
    for (Body* body : {&b.one, &b.two}) {
      body->position = body->position + elsewhere + drift * time;
      body->velocity = body->velocity + drift;
    }
    return b;
  };
  const auto interaction = [](const Interaction& i) { return i; };
  return setup.worst_of(name, "of the largest force",
                        [&](const Path& path) { return detail::invariance(setup, path, bodies, interaction); });
}

inline Result swap_of_bodies(const Setup& setup) {
  const auto bodies = [](const Bodies& b, double) { return Bodies{b.two, b.one}; };
  const auto interaction = [](const Interaction& i) {
    return Interaction{-i.force, {}, i.torque2, i.torque1, i.bridge_force};  // force1 is the third law's
  };
  return setup.worst_of("swap of the bodies", "of the largest force",
                        [&](const Path& path) { return detail::invariance(setup, path, bodies, interaction); });
}

/// At each step the pair changes its owner, with its history as the law exchanges it.
inline Result change_of_owner(const Setup& setup) {
  constexpr const char* name = "change of owner";
  if (!setup.update.exchanged) return not_offered(name);
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    const Trajectory trajectory = setup.trajectory(path);
    const double largest = drive(setup.update, trajectory).largest_force();
    Finding finding{0.0, setup.scales.rounding};
    ForceUpdate::State state = setup.update.start();
    for (const auto& [bodies, dt] : trajectory) {
      ForceUpdate::State other = setup.update.exchanged(state);
      const Bodies swapped{bodies.two, bodies.one};
      const Load there = load_of(swapped, setup.update.step(swapped, dt, other));
      const Load here = load_of(bodies, setup.update.step(bodies, dt, state));
      finding.add(load_norm(here + there) / largest);
    }
    return finding;
  });
}

namespace detail {

/// Sheared and rolled, then turned as one rigid body: the force, and the couple if claimed, must turn with it. Only steps without slip, rolling
/// and change of overlap are compared.
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

inline std::vector<Path> turns(const Setup& setup, const char* name, bool twist) {
  Random random(setup.options.seed, name);
  const int steps = twist ? 20 : 200;
  const double overlap = setup.scales.overlap;
  std::vector<Path> all;
  for (int k = 0; k < setup.few_paths(); ++k) {
    const Vector start = random.direction();
    const Vector about = random.direction_across(start);
    const double slip = overlap * random.log_uniform(1e-3, 0.3);
    Path path{setup.move(start, overlap), setup.move(start, overlap, slip * random.direction_across(start))};
    path.back().relative_spin = random.direction_across(start) * (slip / setup.scales.length / path.back().dt);
    for (int i = 1; i <= steps; ++i) {
      const Rotation turn = rotation_about(about, static_cast<double>(i) / steps);
      path.push_back(setup.move(twist ? start : Vector(turn * start), overlap));
      if (twist) path.back().normal_spin = 1.0 / steps / path.back().dt;
    }
    set_normal_velocities(path);
    all.push_back(path);
  }
  return all;
}

}  // namespace detail

inline Result rigid_spin(const Setup& setup) {
  constexpr const char* name = "rigid spin";
  return setup.worst_of(name, "of the shear force, after a turn of 1 rad", detail::turns(setup, name, false),
                        [&](const Path& path) { return detail::turned_as_one(setup, path); });
}

inline Result rigid_twist(const Setup& setup) {
  constexpr const char* name = "rigid twist";
  if (!setup.options.claims.follows_twist) return not_claimed(name);
  return setup.worst_of(name, "of the shear force, after a twist of 1 rad", detail::turns(setup, name, true),
                        [&](const Path& path) { return detail::turned_as_one(setup, path); });
}

/// Factors of which no product of small powers is another, so that no wrong dimension of a constant cancels.
inline Result unit_scaling(const Setup& setup) {
  constexpr const char* name = "unit scaling";
  if (!setup.update.in_units) return not_offered(name);
  return setup.worst_of(name, "of the largest force", [&](const Path& path) {
    const Trajectory trajectory = setup.trajectory(path);
    const Record here = drive(setup.update, trajectory);
    Finding finding{0.0, setup.scales.rounding};
    for (const Units& u : {Units{2.1e3, 1, 1}, Units{1, 3.7e3, 1}, Units{1, 1, 5.3e3}, Units{1.3e-3, 1.9e6, 4.1e3},
                           Units{1.7e6, 2.9e-3, 2.3e-4}, Units{4.3e-2, 1.1e-5, 3.1e-6}}) {
      Trajectory scaled = trajectory;
      for (Instant& i : scaled) {
        i.dt *= u.time;
        for (Body* b : {&i.bodies.one, &i.bodies.two})
          *b = {b->position * u.length, b->velocity * u.velocity(), b->spin / u.time, b->radius * u.length,
                b->mass * u.mass};
      }
      const Record there = drive(setup.update.in_units(u), scaled);
      for (std::size_t i = 0; i < path.size(); ++i)
        finding.add(load_norm(there.loads[i] / u.force() - here.loads[i]) / here.largest_force());
    }
    return finding;
  });
}

}  // namespace contactlaws::verify

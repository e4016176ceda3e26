// SPDX-License-Identifier: MIT
// What holds for every law: action and reaction, and that no observer, no numbering and no unit is preferred.
//
// Allowed errors: rounding (Trial::rounding) where the same numbers are computed in another frame; for a turn of the contact
// in steps of an angle a, 2 a^2 a step: projecting the shear onto the new plane loses a^2/2 of it.
#pragma once

#include <cmath>

#include "contactlaws/verify/trial.hpp"

namespace contactlaws::verify {

namespace detail {

inline std::optional<Vector> turned(const std::optional<Vector>& v, const Rotation& rotation) {
  if (!v) return {};
  return Vector(rotation * *v);
}

/// The difference between what the law answers along the path and what another observer of it makes of the answers there.
template <class Law, class Observe, class Translate>
Finding observed(const Trial<Law>& trial, const Path& path, const Observe& observe, const Translate& translate) {
  const Scene scene = trial.scene(path);
  Scene seen;
  double time = 0.0;
  for (const Moment& m : scene) seen.push_back({observe(m.bodies, time += m.dt), m.dt});
  const Answers here = answers(trial.law, scene), there = answers(trial.law, seen);
  Finding finding{0.0, trial.rounding()};
  for (std::size_t i = 0; i < here.size(); ++i) {
    const double off = difference(translate(here[i]), there[i], largest_force(here), trial.length());
    finding.see(off);
  }
  return finding;
}

/// Whether any answer along the random paths has it: an open contact may well answer with a force alone.
template <class Law, class Has>
bool ever(const Trial<Law>& trial, const Has& has) {
  for (const Path& path : trial.paths)
    for (const Interaction& a : answers(trial.law, trial.scene(path)))
      if (has(a)) return true;
  return false;
}

}  // namespace detail

template <class Law>
Result third_law(const Trial<Law>& trial) {
  constexpr const char* name = "third law";
  if (!detail::ever(trial, [](const Interaction& a) { return a.force1.has_value(); })) return not_offered(name);
  return trial.judge(name, "of the force", [&](const Path& path) {
    Finding finding{0.0, 4 * trial.options.epsilon};  // a sum and a sign
    for (const Interaction& a : answers(trial.law, trial.scene(path))) {
      if (!a.force1) continue;
      const double force = norm<double>(a.force), off = norm<double>(a.force + *a.force1);
      if (!(off <= 0.0)) finding.see(off / force);
    }
    return finding;
  });
}

/// Torques and the forces' couple add up to nothing, or the pair gains angular momentum from nowhere.
template <class Law>
Result torque_balance(const Trial<Law>& trial) {
  constexpr const char* name = "torque balance";
  if (!detail::ever(trial, [](const Interaction& a) { return a.torque1 && a.torque2; })) return not_offered(name);
  return trial.judge(name, "of force times distance", [&](const Path& path) {
    const Scene scene = trial.scene(path);
    const Answers all = answers(trial.law, scene);
    const double scale = largest_force(all) * trial.length();
    Finding finding{0.0, 100 * trial.options.epsilon};  // some dozen products and sums
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].torque1 || !all[i].torque2) continue;
      const Vector sum = *all[i].torque1 + *all[i].torque2 + scene[i].bodies.branch().cross(all[i].force);
      const double off = norm<double>(sum) / scale;
      finding.see(off);
    }
    return finding;
  });
}

template <class Law>
Result frame_indifference(const Trial<Law>& trial) {
  const Rotation q = trial.random.rotation();
  const auto observe = [&q](Bodies bodies, double) {
    for (Body* b : {&bodies.one, &bodies.two}) {
      b->position = q * b->position;
      b->velocity = q * b->velocity;
      b->spin = q * b->spin;
    }
    return bodies;
  };
  const auto translate = [&q](const Interaction& a) {
    return Interaction{q * a.force, detail::turned(a.force1, q), detail::turned(a.torque1, q),
                       detail::turned(a.torque2, q), a.bridge_force};
  };
  return trial.judge("frame indifference", "of the largest force",
                     [&](const Path& path) { return detail::observed(trial, path, observe, translate); });
}

template <class Law>
Result galilean_invariance(const Trial<Law>& trial) {
  const Vector drift = 10 * trial.scales.speed() * trial.random.direction();
  const Vector elsewhere = trial.length() * trial.random.direction();
  const auto observe = [&](Bodies bodies, double time) {
    for (Body* b : {&bodies.one, &bodies.two}) {
      b->position = b->position + elsewhere + drift * time;
      b->velocity = b->velocity + drift;
    }
    return bodies;
  };
  return trial.judge("Galilean invariance", "of the largest force", [&](const Path& path) {
    return detail::observed(trial, path, observe, [](const Interaction& a) { return a; });
  });
}

template <class Law>
Result swap_of_bodies(const Trial<Law>& trial) {
  const auto observe = [](const Bodies& bodies, double) { return Bodies{bodies.two, bodies.one}; };
  const auto translate = [](const Interaction& a) {
    return Interaction{-a.force, {}, a.torque2, a.torque1, a.bridge_force};  // force1 is the third law's
  };
  return trial.judge("swap of the bodies", "of the largest force",
                     [&](const Path& path) { return detail::observed(trial, path, observe, translate); });
}

/// A pair that changes its owner half way, with its history as the law says it is to be handed over.
template <class Law>
Result change_of_owner(const Trial<Law>& trial) {
  constexpr const char* name = "change of owner";
  if constexpr (!detail::offers<detail::Exchanged, Law>) {
    return not_offered(name);
  } else {
    return trial.judge(name, "of the largest force", [&](const Path& path) {
      const Scene scene = trial.scene(path);
      const Answers here = answers(trial.law, scene);
      Finding finding{0.0, trial.rounding()};
      detail::State<Law> state = start_of(trial.law);
      for (std::size_t i = 0; i < scene.size(); ++i) {
        const Bodies& b = scene[i].bodies;
        detail::State<Law> other = trial.law.exchanged(state);
        const Vector force = trial.law(Bodies{b.two, b.one}, scene[i].dt, other).force;
        const double off = norm<double>(force + here[i].force) / largest_force(here);
        finding.see(off);
        trial.law(b, scene[i].dt, state);
      }
      return finding;
    });
  }
}

namespace detail {

/// Sheared, then turned as one body: forces are to turn with it. Of steps that neither slip nor change the overlap.
template <class Law>
Finding turned_as_one(const Trial<Law>& trial, const Path& path) {
  using std::fabs;
  const Scene scene = trial.scene(path);
  State<Law> state = start_of(trial.law);
  Vector expected(0, 0, 0), force(0, 0, 0), normal(0, 0, 1);
  double overlap = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Motion& m = path[i];
    trial.law(scene[i].bodies, m.dt, state);
    force = force_at_rest(trial.law, scene[i], state);
    const double slip = norm<double>(across(m.velocity, m.normal)) * m.dt;
    if (i > 0 && overlap == m.overlap && slip <= 1e-9 * trial.scales.overlap) {
      const double twist = m.normal_spin * m.dt, angle = normal.cross(m.normal).norm() + fabs(twist);
      const Eigen::AngleAxisd about(twist, m.normal);
      expected = about * (Eigen::Quaterniond::FromTwoVectors(normal, m.normal) * expected);
      squares += angle * angle;
    } else {
      expected = force;
      squares = 0.0;
    }
    normal = m.normal;
    overlap = m.overlap;
  }
  // A contact that has no shear is judged by a thousandth of its normal force.
  const double scale = norm<double>(across(expected, normal)) + 1e-3 * norm<double>(expected);
  return {scale > 0.0 ? norm<double>(force - expected) / scale : 0.0, 2 * squares + trial.rounding() * 1000};
}

template <class Law>
std::vector<Path> turns(const Trial<Law>& trial, bool twist) {
  const int steps = twist ? 20 : 200;
  std::vector<Path> all;
  for (int k = 0; k < trial.options.paths / 10 + 1; ++k) {
    const Vector start = trial.random.direction(), about = trial.random.direction_across(start);
    Path path{trial.move(start, trial.scales.overlap)};
    const double slip = trial.scales.overlap * trial.random.log_uniform(1e-3, 0.3);
    path.push_back(trial.move(start, trial.scales.overlap, slip * trial.random.direction_across(start)));
    for (int i = 1; i <= steps; ++i) {
      const Eigen::AngleAxisd turn(static_cast<double>(i) / steps, about);
      path.push_back(trial.move(twist ? start : Vector(turn * start), trial.scales.overlap));
      if (twist) path.back().normal_spin = 1.0 / steps / path.back().dt;
    }
    settle(path);
    all.push_back(path);
  }
  return all;
}

}  // namespace detail

template <class Law>
Result rigid_spin(const Trial<Law>& trial) {
  return trial.judge("rigid spin", "of the shear force, after a turn of 1 rad", detail::turns(trial, false),
                     [&](const Path& path) { return detail::turned_as_one(trial, path); });
}

template <class Law>
Result rigid_twist(const Trial<Law>& trial) {
  constexpr const char* name = "rigid twist";
  if (!trial.options.claims.follows_twist) return not_claimed(name);
  return trial.judge(name, "of the shear force, after a twist of 1 rad", detail::turns(trial, true),
                     [&](const Path& path) { return detail::turned_as_one(trial, path); });
}

template <class Law>
Result unit_scaling(const Trial<Law>& trial) {
  constexpr const char* name = "unit scaling";
  if constexpr (!detail::offers<detail::InUnits, Law>) {
    return not_offered(name);
  } else {
    return trial.judge(name, "of the largest force", [&](const Path& path) {
      const Scene scene = trial.scene(path);
      const Answers here = answers(trial.law, scene);
      Finding finding{0.0, trial.rounding()};
      for (const Units& u : {Units{1e3, 1.0, 1.0}, Units{1e-3, 1e6, 1e3}, Units{1e6, 1e-3, 1e-4}}) {
        Scene scaled = scene;
        for (Moment& m : scaled) {
          m.dt *= u.time;
          for (Body* b : {&m.bodies.one, &m.bodies.two})
            *b = {b->position * u.length, b->velocity * u.velocity(), b->spin / u.time, b->radius * u.length,
                  b->mass * u.mass};
        }
        const Answers there = answers(trial.law.in_units(u), scaled);
        for (std::size_t i = 0; i < here.size(); ++i) {
          const double off = norm<double>(there[i].force / u.force() - here[i].force) / largest_force(here);
          finding.see(off);
        }
      }
      return finding;
    });
  }
}

}  // namespace contactlaws::verify

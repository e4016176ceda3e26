// SPDX-License-Identifier: MIT
// What a scene can be asked: a stable time step, and how far it is from equilibrium.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "contactlaws/timestep.hpp"
#include "simulation.hpp"

namespace dem {

namespace detail {

template <class Law>
void add_stiffness(const Law& law, const Contacts<Law>& contacts, bool first_is_ball,
                   std::vector<contactlaws::BodyStiffness<double>>& stiffness) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const contactlaws::ContactGeometry<double>& geometry = contacts.geometry[c];
    const auto k = law.stiffness(contacts.pair[c], geometry.overlap, contacts.state[c]);
    if (first_is_ball) stiffness[contacts.first(c)].add(k, geometry.normal, geometry.arm1.norm());
    stiffness[contacts.second(c)].add(k, geometry.normal, geometry.arm2.norm());
  }
}

template <class Law>
void add_loads(const Contacts<Law>& contacts, bool first_is_ball, std::vector<double>& load) {
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const double pressed_and_pulled = std::abs(contacts.response[c].surface) + contacts.response[c].attraction;
    if (first_is_ball) load[contacts.first(c)] += pressed_and_pulled;
    load[contacts.second(c)] += pressed_and_pulled;
  }
}

}  // namespace detail

/// Largest stable step [s], before a safety factor (contactlaws/timestep.hpp). Contacts that are listed but open count as
/// barely touching, and every ball as if it touched its twin, so that only an impact comes as a surprise.
template <class BallLaw, class WallLaw>
double stable_time_step(Simulation<BallLaw, WallLaw>& scene) {
  scene.start();
  const Balls& balls = scene.balls;
  std::vector<contactlaws::BodyStiffness<double>> stiffness(balls.size());
  detail::add_stiffness(scene.ball_law, scene.ball_contacts, true, stiffness);
  detail::add_stiffness(scene.wall_law, scene.wall_contacts, false, stiffness);
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (!balls.free[b]) continue;
    contactlaws::BodyStiffness<double> with_twin;
    if (balls.side[b].normal_compliance > 0.0)  // a rigid ball has no twin to touch
      with_twin.add(scene.ball_law.stiffness(twins(balls.side[b]), 0.0, {}), Vec3::UnitX(), balls.radius[b]);
    step = contactlaws::stable_time_step(balls.mass[b], balls.inertia[b], with_twin, step);
    step = contactlaws::stable_time_step(balls.mass[b], balls.inertia[b], stiffness[b], step);
  }
  return step;
}

/// How far the free balls are from equilibrium: the sum of their unbalanced forces (and moments, over the radius) against
/// the sum of all that presses and pulls them [1].
template <class BallLaw, class WallLaw>
double unbalanced_ratio(const Simulation<BallLaw, WallLaw>& scene) {
  const Balls& balls = scene.balls;
  std::vector<double> load(balls.size());
  detail::add_loads(scene.ball_contacts, true, load);
  detail::add_loads(scene.wall_contacts, false, load);
  double unbalanced = 0.0, total = 0.0;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (!balls.free[b]) continue;
    const Vec3 weight = balls.mass[b] * scene.gravity;
    unbalanced += (balls.force[b] + weight).norm() + balls.moment[b].norm() / balls.radius[b];
    total += load[b] + weight.norm();
  }
  return total > 0.0 ? unbalanced / total : 0.0;
}

}  // namespace dem

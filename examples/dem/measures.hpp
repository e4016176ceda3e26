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

/// Calls `visit` with each contact of the scene: its list, its number, a look at it, and whether its first body is a ball.
template <class Scene, class Visit>
void for_each_contact(const Scene& scene, const Visit& visit) {
  for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
    visit(scene.ball_law, scene.ball_contacts, c, scene.ball_contact(c), true);
  for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c)
    visit(scene.wall_law, scene.wall_contacts, c, scene.wall_contact(c), false);
}

}  // namespace detail

/// Largest stable step [s], before a safety factor (contactlaws/timestep.hpp). Contacts that are listed but open count as
/// barely touching, and every ball as if it touched its twin, so that only an impact comes as a surprise.
template <class Scene>
double stable_time_step(Scene& scene) {
  scene.start();
  const Balls& balls = scene.balls;
  std::vector<contactlaws::BodyStiffness<double>> stiffness(balls.size());
  detail::for_each_contact(
      scene, [&stiffness](const auto& law, const auto& contacts, std::size_t c, const auto& look, bool first_is_ball) {
        const contactlaws::ContactGeometry<double>& geometry = look.geometry;
        const auto k = law.stiffness(contacts.template pair_at<double>(c), geometry.overlap, contacts.state(c));
        if (first_is_ball) stiffness[contacts.first(c)].add(k, geometry.normal, geometry.arm1.norm());
        stiffness[contacts.second(c)].add(k, geometry.normal, geometry.arm2.norm());
      });
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
template <class Scene>
double unbalanced_ratio(const Scene& scene) {
  const Balls& balls = scene.balls;
  std::vector<double> load(balls.size());
  detail::for_each_contact(
      scene, [&load](const auto&, const auto& contacts, std::size_t c, const auto& look, bool first_is_ball) {
        const double pressed_and_pulled = std::abs(look.response.normal_force) + look.response.bridge_force;
        if (first_is_ball) load[contacts.first(c)] += pressed_and_pulled;
        load[contacts.second(c)] += pressed_and_pulled;
      });
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

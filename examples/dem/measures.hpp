// SPDX-License-Identifier: MIT
// Measures of a scene: its largest stable time step, and its distance from equilibrium.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "contactlaws/timestep.hpp"
#include "simulation.hpp"

namespace dem {

namespace detail {

/// Calls `visit(law, contacts, number, outcome, whether the first body is a ball)` for each contact of the scene.
template <class Scene, class Visit>
void for_each_contact(const Scene& scene, const Visit& visit) {
  for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
    visit(scene.ball_law, scene.ball_contacts, c, scene.ball_contact(c), true);
  for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c)
    visit(scene.wall_law, scene.wall_contacts, c, scene.wall_contact(c), false);
}

/// A ball against its like, or against one of another elasticity.
inline contactlaws::PairProperties<double> like_pair(const contactlaws::ContactBody<double>& ball,
                                                     contactlaws::ContactBody<double> other) {
  other.curvature = ball.curvature;
  other.radius = ball.radius;
  other.inverse_mass = ball.inverse_mass;
  return contactlaws::pair_properties(ball, other);
}

/// The stiffness of a new contact at this overlap, in radii.
template <class Law>
contactlaws::ContactStiffness<double> stiffness_at(const Law& law, const contactlaws::PairProperties<double>& pair,
                                                   double overlap_in_radii) {
  return law.stiffness(pair, pair.min_radius * overlap_in_radii, {});
}
/// Whether a law is a linear spring: its stiffness does not grow with the overlap.
template <class Law>
bool is_linear(const Law& law, const contactlaws::PairProperties<double>& pair) {
  return stiffness_at(law, pair, 0.1).normal <= stiffness_at(law, pair, 0.01).normal;
}

}  // namespace detail

/// Largest step [s], before a safety factor (contactlaws/timestep.hpp). The smallest of
/// - the stable step for the contacts as they are,
/// - the stable step for each ball against its like at an overlap of 2e-4 radii,
/// - a tenth of the duration of the shortest impact that the present speeds allow: each ball against one of its size, of the
///   stiffest material in the scene, at the sum of its speed and the largest. (An impact on a wall or on a larger ball lasts up
///   to 1.15 times as long.) Without it where both laws are linear springs.
template <class Scene>
double stable_time_step(Scene& scene) {
  scene.start();
  const Balls& balls = scene.balls;
  std::vector<contactlaws::BodyStiffness<double>> stiffness(balls.size());
  detail::for_each_contact(
      scene, [&stiffness](const auto& law, const auto& contacts, std::size_t c, const auto& outcome, bool ball_first) {
        const contactlaws::ContactGeometry<double>& geometry = outcome.geometry;
        const auto k = law.stiffness(contacts.pair(c), geometry.overlap, contacts.state(c));
        if (ball_first) stiffness[contacts.first(c)].add(k, geometry.normal, geometry.arm1.norm());
        stiffness[contacts.second(c)].add(k, geometry.normal, geometry.arm2.norm());
      });

  contactlaws::ContactBody<double> stiffest{};
  stiffest.normal_compliance = stiffest.shear_compliance = std::numeric_limits<double>::infinity();
  double fastest = 0.0;  // [m/s]
  const auto include = [&](const contactlaws::ContactBody<double>& side, const Vec3& velocity) {
    if (side.normal_compliance < stiffest.normal_compliance) stiffest = side;
    fastest = std::max(fastest, velocity.norm());
  };
  for (std::size_t b = 0; b < balls.size(); ++b) include(balls.side[b], balls.velocity[b]);
  for (const Wall& wall : scene.walls) include(wall.side, wall.velocity);

  double step = std::numeric_limits<double>::infinity();
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (!balls.free[b]) continue;
    step = contactlaws::stable_time_step(balls.mass[b], balls.inertia[b], stiffness[b], step);
    const contactlaws::ContactBody<double>& side = balls.side[b];
    if (!(side.normal_compliance > 0.0)) continue;  // two rigid balls have no stiffness
    const auto like = detail::like_pair(side, side);
    contactlaws::BodyStiffness<double> touching;
    touching.add(detail::stiffness_at(scene.ball_law, like, 2e-4), Vec3::UnitX(), balls.radius[b]);
    step = contactlaws::stable_time_step(balls.mass[b], balls.inertia[b], touching, step);
    const double speed = balls.velocity[b].norm() + fastest;
    if (speed > 0.0 && !(detail::is_linear(scene.ball_law, like) && detail::is_linear(scene.wall_law, like)))
      step = std::min(step, contactlaws::impact_duration(detail::like_pair(side, stiffest), speed) / 10.0);
  }
  return step;
}

/// Distance of the free balls from equilibrium: the sum of their unbalanced forces (and torques, over the radius) by the sum of
/// the normal forces and weights on them [1].
template <class Scene>
double unbalanced_ratio(const Scene& scene) {
  const Balls& balls = scene.balls;
  std::vector<double> load(balls.size());
  detail::for_each_contact(
      scene, [&load](const auto&, const auto& contacts, std::size_t c, const auto& outcome, bool ball_first) {
        const double normal = std::abs(outcome.response.normal_force) + outcome.response.bridge_force;
        if (ball_first) load[contacts.first(c)] += normal;
        load[contacts.second(c)] += normal;
      });
  double unbalanced = 0.0, total = 0.0;
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (!balls.free[b]) continue;
    const Vec3 weight = balls.mass[b] * scene.gravity;
    unbalanced += (balls.force[b] + weight).norm() + balls.torque[b].norm() / balls.radius[b];
    total += load[b] + weight.norm();
  }
  return total > 0.0 ? unbalanced / total : 0.0;
}

}  // namespace dem

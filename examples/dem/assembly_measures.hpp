// SPDX-License-Identifier: MIT
// Measures of an assembly of balls: porosity, stress, coordination.
#pragma once

#include <cmath>
#include <vector>

#include "contactlaws/core/scalar.hpp"
#include "measures.hpp"

namespace dem {

/// Volume that two spheres share [m^3].
inline double shared_volume(double radius1, double radius2, double distance) {
  const double pi = contactlaws::pi<double>();
  const double smaller = std::min(radius1, radius2), depth = radius1 + radius2 - distance;
  if (depth <= 0.0) return 0.0;
  if (distance <= std::abs(radius1 - radius2)) return 4.0 / 3.0 * pi * smaller * smaller * smaller;
  const double difference = radius1 - radius2;
  return pi * depth * depth *
         (distance * distance + 2.0 * distance * (radius1 + radius2) - 3.0 * difference * difference) /
         (12.0 * distance);
}

/// Share of a sphere that no ball fills [1]. The overlap of two balls counts twice.
inline double porosity_in_sphere(const Balls& balls, const Vec3& centre, double radius) {
  double filled = 0.0;
  for (std::size_t b = 0; b < balls.size(); ++b)
    filled += shared_volume(radius, balls.radius[b], (balls.position[b] - centre).norm());
  return 1.0 - filled / (4.0 / 3.0 * contactlaws::pi<double>() * radius * radius * radius);
}

/// Mean stress of the assembly [Pa], compression > 0, from the walls: sum over the contacts at walls of place times force, by
/// the volume [m^3].
template <class Scene>
Eigen::Matrix3d wall_stress(const Scene& scene, double volume) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c) {
    const auto contact = scene.wall_contact(c);
    const Vec3 place = scene.balls.position[scene.wall_contacts.second(c)] + contact.geometry.arm2;
    sum -= contact.response.force * place.transpose();
  }
  return sum / volume;
}

/// The same from all contacts: branch vector times force, for a wall from the contact to the ball (Love 1927). It differs from
/// wall_stress() by the sum of force times position over the balls, which is zero at rest.
template <class Scene>
Eigen::Matrix3d contact_stress(const Scene& scene, double volume) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  detail::for_each_contact(scene, [&sum](const auto&, const auto&, std::size_t, const auto& outcome, bool ball_first) {
    const auto& geometry = outcome.geometry;
    const Vec3 branch = ball_first ? Vec3(geometry.arm1 - geometry.arm2) : Vec3(-geometry.arm2);
    sum += outcome.response.force * branch.transpose();
  });
  return sum / volume;
}

/// What is missing to equilibrium in the stress: sum of force times position over the balls, by the volume [Pa].
inline Eigen::Matrix3d unbalanced_stress(const Balls& balls, double volume) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t b = 0; b < balls.size(); ++b) sum += balls.force[b] * balls.position[b].transpose();
  return sum / volume;
}

struct Coordination {
  double mean = 0.0;         ///< other balls that a ball touches [1]
  std::size_t rattlers = 0;  ///< balls that touch fewer than three bodies, walls included
};
template <class Scene>
Coordination coordination(const Scene& scene) {
  std::vector<int> contacts(scene.balls.size());
  double between_balls = 0.0;
  detail::for_each_contact(scene,
                           [&](const auto&, const auto& list, std::size_t c, const auto& outcome, bool ball_first) {
                             if (!(outcome.geometry.overlap > 0.0)) return;
                             ++contacts[list.second(c)];
                             if (!ball_first) return;
                             ++contacts[list.first(c)];
                             between_balls += 1.0;
                           });
  Coordination result{2.0 * between_balls / static_cast<double>(std::max<std::size_t>(1, scene.balls.size())), 0};
  for (const int count : contacts) result.rattlers += count < 3 ? 1 : 0;
  return result;
}

}  // namespace dem

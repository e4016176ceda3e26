// SPDX-License-Identifier: MIT
// Walls: planes, and a cylinder with the balls inside. At rest or driven at a prescribed velocity; a plane may turn too.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "balls.hpp"

namespace dem {

/// A plane through `point`, with the balls on the side that `facing` points to; or, where `radius` > 0, a cylinder about the
/// axis through `point` along `facing`, with the balls inside. A ball meets a cylinder as it meets the plane that touches the
/// cylinder at the point nearest to the ball.
struct Wall {
  contactlaws::ContactBody<double> side;  ///< elasticity: contactlaws::plane(material), perhaps .rigid()
  Vec3 point;                             ///< [m]
  Vec3 facing;                            ///< unit vector
  Vec3 velocity = Vec3::Zero();           ///< [m/s]
  Vec3 force = Vec3::Zero();              ///< of all contacts on the wall [N]
  double radius = 0.0;                    ///< of a cylinder [m]
  double radial_velocity = 0.0;           ///< of a cylinder, outward [m/s]
  double normal_force = 0.0;   ///< sum of the components along the normals of the contacts; compression > 0 [N]
  Vec3 spin = Vec3::Zero();    ///< of a plane, about `point` [rad/s]
  Vec3 torque = Vec3::Zero();  ///< of all contacts on the wall, about `point` [N m]
  double extent = 0.0;         ///< of a plane that turns: largest distance of its contacts from `point` [m]
  int group = -1;              ///< it does not meet the balls of this group; -1 for none

  /// The plane that a ball at `position` meets.
  contactlaws::BodyMotion<double> nearest(const Vec3& position, Vec3& normal) const {
    normal = facing;
    if (!(radius > 0.0)) return {point, velocity, spin};
    const Vec3 from_axis = position - point;
    const Vec3 outward = from_axis - facing * facing.dot(from_axis);
    const double distance = outward.norm();
    normal = distance > 0.0 ? Vec3(-outward / distance) : Vec3(facing.unitOrthogonal());
    return {position - outward - normal * radius, velocity - normal * radial_velocity, Vec3::Zero()};
  }

  void move(double duration) {
    point += velocity * duration;
    radius += radial_velocity * duration;
    if (spin != Vec3::Zero()) facing = (facing + spin.cross(facing) * duration).normalized();
  }
  /// Largest distance between a point of this wall and where it was `then` [m].
  double distance_from(const Wall& then) const {
    return (point - then.point).norm() + std::abs(radius - then.radius) + (facing - then.facing).norm() * extent;
  }
  /// Adds a contact with a ball at `position` [m], at `arm` [m] from its centre, with this force on the ball [N].
  void add_contact(const Vec3& position, double arm, const Vec3& on_ball) {
    Vec3 normal;
    nearest(position, normal);
    force -= on_ball;
    torque -= Vec3(position - normal * arm - point).cross(on_ball);
    normal_force += normal.dot(on_ball);
  }
};

/// @throws std::invalid_argument unless `facing` has a length of 1 and the radius is not negative
inline void check(const Wall& wall) {
  contactlaws::require_in(contactlaws::Range::not_negative(), wall.radius, "Wall", "radius", "m");
  // Rounding errors of a normalised vector are below 1e-15.
  contactlaws::require_in(contactlaws::Range::closed(1.0 - 1e-9, 1.0 + 1e-9), wall.facing.norm(), "Wall",
                          "the length of facing", "1");
}

/// The six walls of a box, facing inwards: x low, x high, y low, y high, z low (the bottom), z high.
/// @throws std::invalid_argument unless each edge from `low` to `high` is positive [m]
inline std::array<Wall, 6> box_of_walls(const contactlaws::ContactBody<double>& side, const Vec3& low,
                                        const Vec3& high) {
  std::array<Wall, 6> walls;
  for (int axis = 0; axis < 3; ++axis) {
    contactlaws::require_in(contactlaws::Range::positive(), high[axis] - low[axis], "box_of_walls", "edge", "m");
    const Vec3 along = Vec3::Unit(axis);
    const auto first = static_cast<std::size_t>(2 * axis);
    walls[first] = {side, low, along};
    walls[first + 1] = {side, high, -along};
  }
  return walls;
}

}  // namespace dem

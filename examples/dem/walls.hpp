// SPDX-License-Identifier: MIT
// Walls: planes, at rest or driven at a prescribed velocity.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "balls.hpp"

namespace dem {

/// A plane through `point`. Balls are on the side that `facing` points to.
struct Wall {
  contactlaws::ContactBody<double> side;  ///< elasticity: contactlaws::plane(material), perhaps .rigid()
  Vec3 point;                             ///< [m]
  Vec3 facing;                            ///< unit vector
  Vec3 velocity = Vec3::Zero();           ///< [m/s]
  Vec3 force = Vec3::Zero();              ///< of all contacts on the wall [N]

  contactlaws::BodyMotion<double> motion() const { return {point, velocity, Vec3::Zero()}; }
};

/// @throws std::invalid_argument unless `facing` has a length of 1
inline void check(const Wall& wall) {
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

// SPDX-License-Identifier: MIT
// The bodies that move: spheres, as plain arrays with one entry per ball. A ball's place in them is its id.
#pragma once

#include <cstddef>
#include <vector>

#include "contactlaws/kinematics.hpp"
#include "contactlaws/pair.hpp"
#include "packs.hpp"

namespace dem {

/// A ball as it enters a scene.
struct Ball {
  contactlaws::ContactBody<double> side;  ///< radius, mass and elasticity: contactlaws::sphere(material, radius)
  Vec3 position;                          ///< [m]
  Vec3 velocity = Vec3::Zero();           ///< [m/s]
  Vec3 spin = Vec3::Zero();               ///< [rad/s]
  bool free = true;  ///< false: moves as it is told, whatever the forces. Its mass counts in m* all the same.
};

/// A ball of this side against its like.
inline contactlaws::PairProperties<double> twins(const contactlaws::ContactBody<double>& side) {
  return {side.radius / 2.0,
          0.5 / side.normal_compliance,
          0.5 / side.shear_compliance,
          0.5 / side.inverse_mass,
          side.radius,
          2.0 * side.radius};
}

struct Balls {
  std::vector<Row> position;                           ///< [m], at the time of the scene; and the radius
  std::vector<Row> velocity;                           ///< [m/s], half a step earlier
  std::vector<Row> spin;                               ///< [rad/s], half a step earlier
  std::vector<Row> force;                              ///< of all contacts [N]
  std::vector<Row> moment;                             ///< of all contacts, about the centre [N m]
  std::vector<double> radius;                          ///< [m]
  std::vector<double> mass;                            ///< [kg]
  std::vector<double> inertia;                         ///< 2/5 m R^2 [kg m^2]
  std::vector<contactlaws::ContactBody<double>> side;  ///< what pair_properties() asks for
  std::vector<char> free;                              ///< whether forces move it

  std::size_t size() const { return position.size(); }

  /// The new ball's id. @throws std::invalid_argument unless radius and mass are positive and finite
  int add(const Ball& ball) {
    using contactlaws::Range;
    const double r = ball.side.radius;
    const double m = 1.0 / ball.side.inverse_mass;
    contactlaws::require_in(Range::positive(), r, "Ball", "radius", "m");
    if (ball.free) contactlaws::require_in(Range::positive(), m, "Ball", "mass", "kg");
    position.push_back(ball.position);
    position.back().more = r;
    velocity.push_back(ball.velocity);
    spin.push_back(ball.spin);
    force.emplace_back();
    moment.emplace_back();
    radius.push_back(r);
    mass.push_back(m);
    inertia.push_back(0.4 * m * r * r);
    side.push_back(ball.side);
    free.push_back(ball.free);
    return static_cast<int>(size()) - 1;
  }
};

}  // namespace dem

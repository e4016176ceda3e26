// SPDX-License-Identifier: MIT
// The moving bodies: spheres, one array per quantity. A ball's index in them is its id.
#pragma once

#include <cstddef>
#include <vector>

#include "contactlaws/kinematics.hpp"
#include "contactlaws/pair.hpp"

namespace dem {

using Vec3 = contactlaws::Vec3<double>;

/// A vector with one number more: four doubles, which load and store as one register.
struct alignas(32) Row : Vec3 {
  double w = 0.0;

  Row() : Vec3(Vec3::Zero()) {}
  Row(const Vec3& vector) : Vec3(vector) {}  // NOLINT: converts a vector
  using Vec3::operator=;                     // w keeps its value

  auto all() { return Eigen::Map<Eigen::Vector4d, Eigen::Aligned32>(data()); }
  auto all() const { return Eigen::Map<const Eigen::Vector4d, Eigen::Aligned32>(data()); }
};
static_assert(sizeof(Row) == 4 * sizeof(double), "contactlaws::gather_rows reads an array of Row as doubles");

/// A ball to add to a scene.
struct Ball {
  contactlaws::ContactBody<double> side;  ///< radius, mass and elasticity: contactlaws::sphere(material, radius)
  Vec3 position;                          ///< [m]
  Vec3 velocity = Vec3::Zero();           ///< [m/s]
  Vec3 spin = Vec3::Zero();               ///< [rad/s]
  bool free = true;  ///< false: velocity and spin are prescribed. The mass counts in m* all the same.
  int group = -1;    ///< see Balls
};

struct Balls {
  std::vector<Row> position;                           ///< [m] at the time of the scene; w is the radius
  std::vector<Row> velocity;                           ///< [m/s], half a step earlier
  std::vector<Row> spin;                               ///< [rad/s], half a step earlier
  std::vector<Row> force;                              ///< of all contacts [N]
  std::vector<Row> torque;                             ///< of all contacts, about the centre [N m]
  std::vector<double> radius;                          ///< [m]
  std::vector<double> mass;                            ///< [kg]
  std::vector<double> inertia;                         ///< 2/5 m R^2 [kg m^2]
  std::vector<contactlaws::ContactBody<double>> side;  ///< input of pair_properties()
  std::vector<char> free;                              ///< whether forces move it
  /// No contact acts between two balls of one group. From 0 on it is a rigid body, which moves its balls (clumps.hpp); below -1
  /// the balls move by themselves; -1 for none.
  std::vector<int> group;

  std::size_t size() const { return position.size(); }

  /// The new ball's id. @throws std::invalid_argument unless the radius (and the mass, if free) is positive and finite
  int add(const Ball& ball) {
    check(ball.side, ball.free);
    position.push_back(ball.position);
    velocity.push_back(ball.velocity);
    spin.push_back(ball.spin);
    force.emplace_back();
    torque.emplace_back();
    radius.emplace_back();
    mass.emplace_back();
    inertia.emplace_back();
    side.emplace_back();
    free.push_back(ball.free);
    group.push_back(ball.group);
    set_body(size() - 1, ball.side);
    return static_cast<int>(size()) - 1;
  }

  /// Gives a ball another radius, mass and elasticity. @throws as add()
  void change(std::size_t ball, const contactlaws::ContactBody<double>& body) {
    check(body, free[ball]);
    set_body(ball, body);
  }

 private:
  static void check(const contactlaws::ContactBody<double>& body, bool is_free) {
    using contactlaws::Range;
    contactlaws::require_in(Range::positive(), body.radius, "Ball", "radius", "m");
    if (is_free) contactlaws::require_in(Range::positive(), 1.0 / body.inverse_mass, "Ball", "mass", "kg");
  }
  void set_body(std::size_t b, const contactlaws::ContactBody<double>& body) {
    side[b] = body;
    position[b].w = radius[b] = body.radius;
    mass[b] = 1.0 / body.inverse_mass;
    inertia[b] = 0.4 * mass[b] * radius[b] * radius[b];
  }
};

}  // namespace dem

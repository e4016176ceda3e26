// SPDX-License-Identifier: MIT
// Geometry and motion of contacts between balls, and between a wall and a ball: one contact, or a pack of contacts.
#pragma once

#include <vector>

#include "contactlaws/rows.hpp"
#include "walls.hpp"

namespace dem {

using contactlaws::Ids;

template <class T>
struct ContactMotion {
  contactlaws::ContactGeometry<T> geometry;      ///< now
  contactlaws::ContactKinematics<T> kinematics;  ///< over the last step
};

/// Between balls.
struct BallMotion {
  const Balls& balls;
  double dt;  ///< of the last step [s]

  template <class T>
  CONTACTLAWS_HD ContactMotion<T> at(const Ids<T>& one, const Ids<T>& two) const {
    const std::array<T, 4> place1 = rows<T>(balls.position, one), place2 = rows<T>(balls.position, two);
    const contactlaws::BodyMotion<T> body1 = body<T>(place1, one), body2 = body<T>(place2, two);
    const T &radius1 = place1[3], &radius2 = place2[3];
    const contactlaws::Vec3<T> centres = body2.velocity - body1.velocity;
    const ContactMotion<T> moved{
        // made in place: a copy would go through memory
        contactlaws::sphere_sphere<T>(body1.position, radius1, body2.position, radius2),
        contactlaws::at_full_step<T>(contactlaws::contact_kinematics<T>(moved.geometry, body1, body2, T(dt)), centres,
                                     T(radius1 + radius2 - moved.geometry.overlap))};
    return moved;
  }

 private:
  template <class T>
  CONTACTLAWS_HD static std::array<T, 4> rows(const std::vector<Row>& rows, const Ids<T>& ids) {
    return contactlaws::gather_rows<T>(rows.data()->data(), ids);
  }
  template <class T>
  CONTACTLAWS_HD contactlaws::BodyMotion<T> body(const std::array<T, 4>& place, const Ids<T>& ids) const {
    const std::array<T, 4> velocity = rows<T>(balls.velocity, ids), spin = rows<T>(balls.spin, ids);
    return {{place[0], place[1], place[2]}, {velocity[0], velocity[1], velocity[2]}, {spin[0], spin[1], spin[2]}};
  }
};

/// Between a wall and a ball, one at a time: they are few.
struct WallMotion {
  const std::vector<Wall>& walls;
  const Balls& balls;
  double dt;  ///< of the last step [s]

  template <class T>
  ContactMotion<T> at(const Ids<T>& wall, const Ids<T>& ball) const {
    const Wall& w = walls[wall[0]];
    const std::size_t b = ball[0];
    const contactlaws::BodyMotion<double> body{balls.position[b], balls.velocity[b], balls.spin[b]};
    Vec3 normal;
    const contactlaws::BodyMotion<double> plane = w.nearest(body.position, normal);
    const auto geometry = contactlaws::plane_sphere<double>(plane.position, normal, body.position, balls.radius[b]);
    return {geometry, contactlaws::contact_kinematics<double>(geometry, plane, body, dt)};
  }
};

}  // namespace dem

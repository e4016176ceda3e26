// SPDX-License-Identifier: MIT
// Where the two bodies of a contact meet, and how they moved: one contact at a time, or a pack of contacts.
#pragma once

#include <vector>

#include "packs.hpp"
#include "walls.hpp"

namespace dem {

template <class T>
struct Meeting {
  contactlaws::ContactGeometry<T> geometry;  ///< now
  contactlaws::ContactKinematics<T> motion;  ///< over the last step
};

/// Ball with ball.
struct BallsMeet {
  const Balls& balls;
  double dt;  ///< of the last step [s]

  template <class T>
  CONTACTLAWS_HD Meeting<T> at(const Ids<T>& one, const Ids<T>& two) const {
    const Rows<T> place1 = gather<T>(balls.position, one), place2 = gather<T>(balls.position, two);
    const contactlaws::BodyMotion<T> motion1 = motion(place1, one), motion2 = motion(place2, two);
    const T &radius1 = place1.more, &radius2 = place2.more;
    const auto geometry = contactlaws::sphere_sphere<T>(motion1.position, radius1, motion2.position, radius2);
    const auto before = contactlaws::contact_kinematics<T>(geometry, motion1, motion2, T(dt));
    return {geometry, contactlaws::at_full_step<T>(before, contactlaws::Vec3<T>(motion2.velocity - motion1.velocity),
                                                   radius1 + radius2 - geometry.overlap)};
  }

  double overlap(std::size_t i, std::size_t j) const { return at<double>({i}, {j}).geometry.overlap; }

 private:
  template <class T>
  CONTACTLAWS_HD contactlaws::BodyMotion<T> motion(const Rows<T>& place, const Ids<T>& ids) const {
    return {place.vector, gather<T>(balls.velocity, ids).vector, gather<T>(balls.spin, ids).vector};
  }
};

/// Wall with ball: these are few, and asked one at a time.
struct WallMeetsBall {
  const std::vector<Wall>& walls;
  const Balls& balls;
  double dt;  ///< of the last step [s]

  template <class T>
  Meeting<T> at(const Ids<T>& wall, const Ids<T>& ball) const {
    const Wall& w = walls[wall[0]];
    const std::size_t b = ball[0];
    const contactlaws::BodyMotion<double> motion{balls.position[b], balls.velocity[b], balls.spin[b]};
    const auto geometry = contactlaws::plane_sphere<double>(w.point, w.facing, motion.position, balls.radius[b]);
    return {geometry, contactlaws::contact_kinematics(geometry, w.motion(), motion, dt)};
  }

  double overlap(std::size_t w, std::size_t b) const { return at<double>({w}, {b}).geometry.overlap; }
};

}  // namespace dem

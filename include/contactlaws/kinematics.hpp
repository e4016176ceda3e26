// SPDX-License-Identifier: MIT
// How two bodies meet: the one sign convention of the library, and the kinematics that a law asks for.
//
//            body 1                  body 2
//         .---------.             .---------.
//       /             \    n    /             \        n         unit normal, from body 1 to body 2
//      |      x1 +-----|-|--->-|-----+ x2      |       overlap   > 0 where the bodies interpenetrate; gap = -overlap
//       \             / xc      \             /        xc        contact point, the middle of the overlap (or gap):
//         '---------'             '---------'                    x1 + n (R1 - overlap/2), so the arms are R - overlap/2
//
//      velocity = v2 - v1 at xc:  velocity.n > 0 is separating
//      force    acts on body 2 at xc (body 1 gets the opposite): compression pushes body 2 along +n
//
// SI units: m, kg, s, N, Pa. (Potyondy 2019, Eqs 3-6.)
#pragma once

#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

/// What a law is told of the motion at each step.
template <class T>
struct ContactKinematics {
  Vec3<T> normal;        ///< unit normal from body 1 to body 2
  T overlap;             ///< [m], negative across a gap
  Vec3<T> velocity;      ///< of body 2 relative to body 1 at the contact point [m/s]
  T dt;                  ///< time since the last step [s]
  T normal_spin = T(0);  ///< mean of the two bodies' spins about the normal [rad/s]; read by rotation::Rotate alone

  template <class U>
  CONTACTLAWS_HD ContactKinematics<U> cast() const {
    const auto vector = [](const Vec3<T>& v) {
      return Vec3<U>(scalar_cast<U>(v.x()), scalar_cast<U>(v.y()), scalar_cast<U>(v.z()));
    };
    return {vector(normal), scalar_cast<U>(overlap), vector(velocity), scalar_cast<U>(dt), scalar_cast<U>(normal_spin)};
  }
};

/// A body's motion, as a host stores it.
template <class T>
struct BodyMotion {
  Vec3<T> position;  ///< of the centre [m]
  Vec3<T> velocity;  ///< of the centre [m/s]
  Vec3<T> spin;      ///< [rad/s]
};

/// A contact's place: normal, overlap, and the arms from the two centres to the contact point.
template <class T>
struct ContactGeometry {
  Vec3<T> normal;
  T overlap;     ///< [m]
  Vec3<T> arm1;  ///< from body 1's centre to the contact point [m]
  Vec3<T> arm2;  ///< from body 2's centre to the contact point [m]
};

/// Two spheres. The centres must differ.
template <class T>
CONTACTLAWS_HD ContactGeometry<T> sphere_sphere(const Vec3<T>& x1, const T& radius1, const Vec3<T>& x2,
                                                const T& radius2) noexcept {
  const Vec3<T> branch = x2 - x1;
  const T distance = norm<T>(branch);
  const Vec3<T> normal = branch / distance;
  const T overlap = radius1 + radius2 - distance;
  const T half = overlap / T(2);
  return {normal, overlap, normal * (radius1 - half), normal * (half - radius2)};
}

/// A plane (body 1: through `point`, facing along the unit vector `facing`; its arm runs from `point`) and a sphere.
template <class T>
CONTACTLAWS_HD ContactGeometry<T> plane_sphere(const Vec3<T>& point, const Vec3<T>& facing, const Vec3<T>& x2,
                                               const T& radius2) noexcept {
  const Vec3<T> from_point = x2 - point;
  const T overlap = radius2 - dot<T>(from_point, facing);
  const Vec3<T> arm2 = facing * (overlap / T(2) - radius2);
  return {facing, overlap, from_point + arm2, arm2};
}

/// The kinematics at a contact of two moving bodies, over the step `dt` [s].
template <class T>
CONTACTLAWS_HD ContactKinematics<T> contact_kinematics(const ContactGeometry<T>& geometry, const BodyMotion<T>& body1,
                                                       const BodyMotion<T>& body2, const T& dt) noexcept {
  const Vec3<T> at1 = body1.velocity + body1.spin.cross(geometry.arm1);
  const Vec3<T> at2 = body2.velocity + body2.spin.cross(geometry.arm2);
  const Vec3<T> both_spins = body1.spin + body2.spin;
  return {geometry.normal, geometry.overlap, at2 - at1, dt, dot<T>(both_spins, geometry.normal) / T(2)};
}

/// A motion measured half a step ago (leapfrog: velocities live between positions), brought to the contact plane of now:
/// turned as the normal turned since. `centres` is the velocity of centre 2 relative to centre 1 [m/s], `distance` theirs
/// [m]. Unturned, a part of the normal velocity would pass for sliding, and in a grain that vibrates at a slant it adds up.
/// (Vyas et al. 2025, doi 10.1016/j.cpc.2025.109524, trace small grains that stick to large ones to that.)
template <class T>
CONTACTLAWS_HD ContactKinematics<T> at_full_step(const ContactKinematics<T>& motion, const Vec3<T>& centres,
                                                 const T& distance) noexcept {
  const Vec3<T>& n = motion.normal;
  const Vec3<T>& v = motion.velocity;
  const T half = motion.dt / (T(2) * distance);
  const Vec3<T> turn = (centres - n * dot<T>(n, centres)) * half;  // of the normal, in half a step
  const Vec3<T> velocity = v + turn * dot<T>(n, v) - n * dot<T>(turn, v);
  return {n, motion.overlap, velocity, motion.dt, motion.normal_spin};
}

}  // namespace contactlaws

// SPDX-License-Identifier: MIT
// The contact of two bodies: the sign convention of the whole library, and the motion that a law needs.
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
//      couple   acts on body 2 (body 1 gets the opposite), from the relative spin w2 - w1
//
// SI units: m, kg, s, N, Pa. (Potyondy 2019, Eqs 3-6.)
#pragma once

#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

/// The motion of a contact over one step: the input of a law.
template <class T>
struct ContactKinematics {
  Vec3<T> normal;        ///< unit normal from body 1 to body 2
  T overlap;             ///< [m], negative across a gap
  Vec3<T> velocity;      ///< of body 2 relative to body 1 at the contact point [m/s]
  T dt;                  ///< time since the last step [s]
  T normal_spin = T(0);  ///< mean of the two spins, along the normal [rad/s]; read by rotation::Rotate
  Vec3<T> relative_spin = Vec3<T>(T(0), T(0), T(0));  ///< w2 - w1 [rad/s]; read by rolling laws

  template <class U>
  CONTACTLAWS_HD ContactKinematics<U> cast() const {
    const auto vector = [](const Vec3<T>& v) {
      return Vec3<U>(scalar_cast<U>(v.x()), scalar_cast<U>(v.y()), scalar_cast<U>(v.z()));
    };
    return {vector(normal),     scalar_cast<U>(overlap),     vector(velocity),
            scalar_cast<U>(dt), scalar_cast<U>(normal_spin), vector(relative_spin)};
  }
};

/// The motion of a body, as a host stores it.
template <class T>
struct BodyMotion {
  Vec3<T> position;  ///< of the centre [m]
  Vec3<T> velocity;  ///< of the centre [m/s]
  Vec3<T> spin;      ///< [rad/s]
};

/// The geometry of a contact: normal, overlap, and the arms from the two centres to the contact point.
template <class T>
struct ContactGeometry {
  Vec3<T> normal;  ///< unit normal from body 1 to body 2
  T overlap;       ///< [m]
  Vec3<T> arm1;    ///< from body 1's centre to the contact point [m]
  Vec3<T> arm2;    ///< from body 2's centre to the contact point [m]
};

/// Two spheres. The centres must differ.
template <class T>
CONTACTLAWS_HD ContactGeometry<T> sphere_sphere(const Vec3<T>& x1, const NonDeduced<T>& radius1, const Vec3<T>& x2,
                                                const NonDeduced<T>& radius2) noexcept {
  const Vec3<T> branch = x2 - x1;
  const T distance = norm<T>(branch);
  const Vec3<T> normal = branch / distance;
  const T overlap = radius1 + radius2 - distance;
  const T half = overlap / T(2);
  return {normal, overlap, normal * (radius1 - half), normal * (half - radius2)};
}
/// The same for any vectors of one scalar, expressions of Eigen among them.
template <class X1, class X2, class T = typename X1::Scalar>
CONTACTLAWS_HD ContactGeometry<T> sphere_sphere(const X1& x1, const NonDeduced<T>& radius1, const X2& x2,
                                                const NonDeduced<T>& radius2) noexcept {
  return sphere_sphere<T>(Vec3<T>(x1), radius1, Vec3<T>(x2), radius2);
}

/// A plane (body 1: through `point`, facing along the unit vector `facing`; its arm starts at `point`) and a sphere.
template <class T>
CONTACTLAWS_HD ContactGeometry<T> plane_sphere(const Vec3<T>& point, const Vec3<T>& facing, const Vec3<T>& x2,
                                               const NonDeduced<T>& radius2) noexcept {
  const Vec3<T> from_point = x2 - point;
  const T overlap = radius2 - dot<T>(from_point, facing);
  const Vec3<T> arm2 = facing * (overlap / T(2) - radius2);
  return {facing, overlap, from_point + arm2, arm2};
}
/// The same for any vectors of one scalar.
template <class X1, class X2, class X3, class T = typename X1::Scalar>
CONTACTLAWS_HD ContactGeometry<T> plane_sphere(const X1& point, const X2& facing, const X3& x2,
                                               const NonDeduced<T>& radius2) noexcept {
  return plane_sphere<T>(Vec3<T>(point), Vec3<T>(facing), Vec3<T>(x2), radius2);
}

/// The kinematics at a contact of two moving bodies, over the step `dt` [s].
template <class T>
CONTACTLAWS_HD ContactKinematics<T> contact_kinematics(const ContactGeometry<T>& geometry, const BodyMotion<T>& body1,
                                                       const BodyMotion<T>& body2, const T& dt) noexcept {
  const Vec3<T> at1 = body1.velocity + body1.spin.cross(geometry.arm1);
  const Vec3<T> at2 = body2.velocity + body2.spin.cross(geometry.arm2);
  const Vec3<T> both_spins = body1.spin + body2.spin;
  return {geometry.normal,        geometry.overlap, at2 - at1, dt, dot<T>(both_spins, geometry.normal) / T(2),
          body2.spin - body1.spin};
}

/// A contact of two spheres, whose arms lie along the normal: the fast path for hosts with arrays of bodies.
template <class T>
struct SphereContact {
  ContactKinematics<T> kinematics;
  T arm1;      ///< from centre 1 to the contact point, along the normal [m]
  T arm2;      ///< from centre 2 to the contact point, against the normal [m]
  T distance;  ///< of the centres [m]
};

/// The contact of two moving spheres, from arrays of three numbers each: positions x [m], velocities v [m/s], spins w [rad/s].
/// A wall is a body 1 of radius 0 at the wall's point nearest to centre 2. One square root, one division. Error: 4 eps of the
/// normal, overlap within 4 eps of the coordinates, velocity within 16 eps of the speeds (tests/composition/test_kinematics.cpp).
/// Domain: centres that differ, by a distance whose square neither over- nor underflows.
template <class T>
CONTACTLAWS_HD SphereContact<T> sphere_contact(const T* x1, const T* v1, const T* w1, const NonDeduced<T>& radius1,
                                               const T* x2, const T* v2, const T* w2, const NonDeduced<T>& radius2,
                                               const NonDeduced<T>& dt) noexcept {
  using std::sqrt;
  // By components: they stay in registers, where a vector would be stored and loaded again at once.
  const T x = x2[0] - x1[0], y = x2[1] - x1[1], z = x2[2] - x1[2];
  const T distance = sqrt(T(x * x + y * y + z * z));
  const T inverse = T(1) / distance;
  const T nx = x * inverse, ny = y * inverse, nz = z * inverse;
  const T overlap = radius1 + radius2 - distance;
  const T half = overlap / T(2);
  const T arm1 = radius1 - half, arm2 = radius2 - half;
  // w1 x (arm1 n) and w2 x (-arm2 n): one cross product
  const T sx = w1[0] * arm1 + w2[0] * arm2, sy = w1[1] * arm1 + w2[1] * arm2, sz = w1[2] * arm1 + w2[2] * arm2;
  const Vec3<T> velocity(v2[0] - v1[0] - (sy * nz - sz * ny), v2[1] - v1[1] - (sz * nx - sx * nz),
                         v2[2] - v1[2] - (sx * ny - sy * nx));
  const T normal_spin = ((w1[0] + w2[0]) * nx + (w1[1] + w2[1]) * ny + (w1[2] + w2[2]) * nz) / T(2);
  const Vec3<T> relative_spin(w2[0] - w1[0], w2[1] - w1[1], w2[2] - w1[2]);
  return {{Vec3<T>(nx, ny, nz), overlap, velocity, dt, normal_spin, relative_spin}, arm1, arm2, distance};
}

/// The torques about the two centres of a force and a couple on body 2 [N m].
template <class T>
struct Torques {
  Vec3<T> on1;  ///< on body 1
  Vec3<T> on2;  ///< on body 2
};
/// The torques of a force and a couple on body 2.
template <class T>
CONTACTLAWS_HD Torques<T> torques(const SphereContact<T>& contact, const Vec3<T>& force,
                                  const Vec3<T>& couple) noexcept {
  const Vec3<T> turning = contact.kinematics.normal.cross(force);
  return {turning * T(-contact.arm1) - couple, turning * T(-contact.arm2) + couple};
}

/// Leapfrog velocities belong to half a step before the positions. This turns such a velocity by half a step's turn of the
/// normal, into the contact plane of the positions. Without the turn, a part of the normal velocity counts as slip; for a
/// vibrating grain it accumulates (Vyas et al. 2025, doi 10.1016/j.cpc.2025.109524). First order in the angle of turn.
/// `centres` is the velocity of centre 2 relative to centre 1 [m/s], `distance` that of the centres [m].
template <class T>
CONTACTLAWS_HD ContactKinematics<T> at_full_step(const ContactKinematics<T>& motion, const Vec3<T>& centres,
                                                 const T& distance) noexcept {
  const Vec3<T>& n = motion.normal;
  const Vec3<T>& v = motion.velocity;
  const T half = motion.dt / (T(2) * distance);
  const Vec3<T> turn = (centres - n * dot<T>(n, centres)) * half;  // of the normal, in half a step
  const Vec3<T> velocity = v + turn * dot<T>(n, v) - n * dot<T>(turn, v);
  return {n, motion.overlap, velocity, motion.dt, motion.normal_spin, motion.relative_spin};
}

}  // namespace contactlaws

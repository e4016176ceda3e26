// SPDX-License-Identifier: MIT
// The stored shear vector s follows the contact plane as the contact turns. Three ways; `angle` is the turn in one step:
//
//   Project         s - (s.n) n                           length shrinks by O(angle^2) a step
//   ProjectRestore  the same, scaled to the old length    length exact; direction wrong by O(angle^2) a step; rotation
//                                                         about the normal is ignored
//   Rotate          rotated with the normal, then about   exact for any turn below 180 degrees; stores the last normal
//                   it by the mean spin of the two bodies (three more values of state)
//
// Source: the projection is Luding's (2008), Rotate is Rodrigues' rotation formula. Domain: unit normals; ProjectRestore
// projects without restoring the length where |s|^2 leaves the range of T (in float |s| < 1e-20 or > 1e19).
// Error beyond the table: <= 9 eps |s| a step, and 2e-12 of the length over 1e6 steps of a tumbling pair
// (tests/laws/test_rotation.cpp).
#pragma once

#include <array>
#include <limits>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/core/scalar.hpp"

namespace contactlaws::rotation {

template <class T>
struct Project {
  struct State {};
  static constexpr std::array<StateValue, 0> state_values() { return {}; }
  template <class U>
  using Rebind = Project<U>;

  /// The stored `shear` in the plane of `normal`; `twist` [rad] is the rotation about the normal since the last step.
  CONTACTLAWS_HD static Vec3<T> apply(State&, const Vec3<T>& shear, const Vec3<T>& normal,
                                      const T& /*twist*/) noexcept {
    return shear - normal * dot<T>(shear, normal);
  }
};

template <class T>
struct ProjectRestore {
  struct State {};
  static constexpr std::array<StateValue, 0> state_values() { return {}; }
  template <class U>
  using Rebind = ProjectRestore<U>;

  CONTACTLAWS_HD static Vec3<T> apply(State&, const Vec3<T>& shear, const Vec3<T>& normal,
                                      const T& /*twist*/) noexcept {
    const T out_of_plane = dot<T>(shear, normal);
    const T lost = out_of_plane * out_of_plane;
    const T kept = dot<T>(shear, shear) - lost;  // the squared length in the plane
    // A shear along the normal has no length left to restore. Turns below the second bound cost 1e-13 in a million steps.
    using Lane = typename ScalarTraits<T>::Lane;
    const Mask<T> shorter = kept > T(0) && lost > kept * T(std::numeric_limits<Lane>::epsilon() / Lane(1024));
    if (!any<T>(shorter)) return shear - normal * out_of_plane;
    // The restored length is a small correction: adding it to 1 first would lose it to rounding at every step.
    const T length = select<T>(shorter, kept, T(1));
    const std::array<T, 2> roots = sqrt_pair<T>(length, T(length + lost));
    const T gain = select<T>(shorter, lost, T(0)) / (length + roots[0] * roots[1]);
    const T away = out_of_plane + out_of_plane * gain;
    return shear + (shear * gain - normal * away);
  }
};

template <class T>
struct Rotate {
  struct State {
    std::array<T, 3> last_normal = {T(0), T(0), T(0)};  ///< of the step before; 0 for a new contact
  };
  static constexpr std::array<StateValue, 3> state_values() {
    return {{{"last_normal_x", "1", -1, ValueKind::vector},
             {"last_normal_y", "1", -1, ValueKind::vector},
             {"last_normal_z", "1", -1, ValueKind::vector}}};
  }
  template <class U>
  using Rebind = Rotate<U>;

  CONTACTLAWS_HD static Vec3<T> apply(State& state, const Vec3<T>& shear, const Vec3<T>& normal,
                                      const T& twist) noexcept {
    using std::cos;
    using std::sin;
    const Vec3<T> last(state.last_normal[0], state.last_normal[1], state.last_normal[2]);
    state.last_normal = {normal.x(), normal.y(), normal.z()};
    // Rodrigues' formula for the shortest rotation from `last` to `normal`, as a change added to `shear`: no angle is
    // computed, and the second-order terms of a small rotation are not lost to rounding.
    const Vec3<T> axis = last.cross(normal);  // times the sine
    const Vec3<T> step = normal - last;
    const T cosine = dot<T>(last, normal);
    const T one_plus_cosine = T(1) + cosine;
    const T along = dot<T>(axis, shear) / select<T>(one_plus_cosine > T(0), one_plus_cosine, T(1));
    const T one_minus_cosine = dot<T>(step, step) / T(2);
    const Vec3<T> turned = shear + (axis.cross(shear) + (axis * along - shear * one_minus_cosine));
    if (!any<T>(twist < T(0) || twist > T(0))) return turned + normal.cross(turned) * twist;  // keeps the derivative
    const T half_sine = sin(T(twist / T(2))), half_cosine = cos(T(twist / T(2)));
    return turned + (normal.cross(turned) * half_cosine - turned * half_sine) * T(T(2) * half_sine);
  }
};

}  // namespace contactlaws::rotation

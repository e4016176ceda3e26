// SPDX-License-Identifier: MIT
// The stored shear vector s follows the contact plane as the contact turns. Three ways; `angle` is the turn in one step:
//
//   Project         s - (s.n) n                           length shrinks by O(angle^2) a step
//   ProjectRestore  the same, scaled to the old length    length exact; direction wrong by O(angle^2) a step; rotation
//                                                         about the normal is ignored
//   Rotate          rotated with the normal, then about   exact for any turn below 180 degrees; stores the last normal
//                   it by the mean spin of the two bodies (three more values of state)
//
// Rotate turns the slip of the step, which is added to s, about the normal by half of the step's spin: the slip happens during the
// whole step. Without that, a contact that sticks gains shear force in cycles of shear and spin.
// With x a quarter of the spin, tan(x) = x (945 - 105 x^2 + x^4) / (945 - 420 x^2 + 15 x^4) (Lambert's continued fraction); the sine
// and cosine of 2x are rational in it. The length is exact for any spin; the angle is exact to rounding up to 0.5 rad a step, to
// 1e-13 at 1 rad and 2e-8 at 3.
//
// Source: the projection is Luding's (2008), Rotate is Rodrigues' rotation formula. Domain: unit normals, a spin below pi a step;
// ProjectRestore projects without restoring the length where |s|^2 leaves the range of T (in float |s| < 1e-20 or > 1e19).
// Error beyond the table: <= 9 eps |s| a step, and 2e-12 of the length over 1e6 steps of a tumbling pair
// (tests/laws/test_rotation.cpp).
#pragma once

#include <array>
#include <limits>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/core/scalar.hpp"

namespace contactlaws::rotation {

namespace detail {

/// Sine and 1 - cosine of half of a rotation about the normal.
template <class T>
struct HalfTwist {
  T sine, versine;

  CONTACTLAWS_HD explicit HalfTwist(const T& twist) noexcept {
    const T x = twist / T(4), square = x * x;
    const T rise = x * (T(945) + square * (square - T(105)));
    const T run = T(945) + square * (T(15) * square - T(420));
    const T scaled = T(2) * rise / (rise * rise + run * run);
    sine = run * scaled;
    versine = rise * scaled;
  }
  /// A vector of the contact plane, rotated about its normal by half of the twist.
  CONTACTLAWS_HD Vec3<T> half(const Vec3<T>& v, const Vec3<T>& normal) const noexcept {
    return v + (normal.cross(v) * sine - v * versine);
  }
  /// The same by the whole twist.
  CONTACTLAWS_HD Vec3<T> whole(const Vec3<T>& v, const Vec3<T>& normal) const noexcept {
    return v + (normal.cross(v) * (T(1) - versine) - v * sine) * T(T(2) * sine);
  }
};

/// sqrt(1 + x) - 1 of x >= 0. Up to 1e-4, a turn by half a degree, no root is needed: the series' next term is 5e-18 of it.
template <class T>
CONTACTLAWS_HD T root_gain(const T& x) noexcept {
  using std::sqrt;
  const auto by_root = [&x] { return T(x / (T(1) + T(sqrt(T(T(1) + x))))); };
  if constexpr (std::numeric_limits<typename ScalarTraits<T>::Lane>::digits > 53) {
    return by_root();
  } else {
    const T series = x * (T(T(1) / T(2)) - x * (T(T(1) / T(8)) - x * (T(T(1) / T(16)) - x * T(T(5) / T(128)))));
    const Mask<T> large = x > T(1e-4F);
    if (!any<T>(large)) return series;
    return select<T>(large, by_root(), series);
  }
}

}  // namespace detail

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
  /// The slip of the step as it is: this rule does not read the spin.
  CONTACTLAWS_HD static Vec3<T> slip(const Vec3<T>& slip, const Vec3<T>&, const T& /*twist*/) noexcept { return slip; }
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
    const T gain = detail::root_gain<T>(T(select<T>(shorter, lost, T(0)) / select<T>(shorter, kept, T(1))));
    const T away = out_of_plane + out_of_plane * gain;
    return shear + (shear * gain - normal * away);
  }
  /// The slip of the step as it is: this rule does not read the spin.
  CONTACTLAWS_HD static Vec3<T> slip(const Vec3<T>& slip, const Vec3<T>&, const T& /*twist*/) noexcept { return slip; }
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
    return detail::HalfTwist<T>(twist).whole(turned, normal);
  }
  /// The slip of the step, rotated by half of the spin.
  CONTACTLAWS_HD static Vec3<T> slip(const Vec3<T>& slip, const Vec3<T>& normal, const T& twist) noexcept {
    return detail::HalfTwist<T>(twist).half(slip, normal);
  }
};

}  // namespace contactlaws::rotation

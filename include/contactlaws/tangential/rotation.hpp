// SPDX-License-Identifier: MIT
// Carrying the stored shear vector to the new contact plane as the contact turns. Three ways, by what they keep:
//
//   Project         s - (s.n) n                            loses length as the plane turns: O(angle^2) a step
//   ProjectRestore  the same, stretched to its old length  keeps length; direction right to O(angle^2) a step
//   Rotate          turned with the normal, then about it  exact for any turn short of reversal; stores the last normal
//                   by the pair's common spin              (three values more of state)
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

  /// The stored `shear` in the plane of `normal`; `twist` [rad] is the turn about the normal since the last step.
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
    // A shear that lies along the normal has nothing left to stretch; a turn that small costs 1e-13 in a million steps.
    using Lane = typename ScalarTraits<T>::Lane;
    const Mask<T> shorter = kept > T(0) && lost > kept * T(std::numeric_limits<Lane>::epsilon() / Lane(1024));
    if (!any<T>(shorter)) return shear - normal * out_of_plane;
    // What the stretch to the old length adds is small, and summed first: beside 1 it would be rounded away, step after step.
    const T length = select<T>(shorter, kept, T(1));
    const Eigen::Array<T, 2, 1> roots = sqrt_pair<T>(length, T(length + lost));
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
    return {{{"last_normal_x", "1", -1}, {"last_normal_y", "1", -1}, {"last_normal_z", "1", -1}}};
  }
  template <class U>
  using Rebind = Rotate<U>;

  CONTACTLAWS_HD static Vec3<T> apply(State& state, const Vec3<T>& shear, const Vec3<T>& normal,
                                      const T& twist) noexcept {
    using std::cos;
    using std::sin;
    const Vec3<T> last(state.last_normal[0], state.last_normal[1], state.last_normal[2]);
    state.last_normal = {normal.x(), normal.y(), normal.z()};
    // Rodrigues' formula for the shortest turn from `last` to `normal`, as a change: no angle is ever formed, and a small
    // turn's second order is not rounded away.
    const Vec3<T> axis = last.cross(normal);  // times the sine
    const Vec3<T> step = normal - last;
    const T cosine = dot<T>(last, normal);
    const T one_plus_cosine = T(1) + cosine;
    const T along = dot<T>(axis, shear) / select<T>(one_plus_cosine > T(0), one_plus_cosine, T(1));
    const T one_minus_cosine = dot<T>(step, step) / T(2);
    const Vec3<T> turned = shear + (axis.cross(shear) + (axis * along - shear * one_minus_cosine));
    if (!any<T>(twist < T(0) || twist > T(0))) return turned + normal.cross(turned) * twist;  // the derivative stays
    const T half_sine = sin(T(twist / T(2))), half_cosine = cos(T(twist / T(2)));
    return turned + (normal.cross(turned) * half_cosine - turned * half_sine) * T(T(2) * half_sine);
  }
};

}  // namespace contactlaws::rotation

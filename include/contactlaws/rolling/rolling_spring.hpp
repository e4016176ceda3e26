// SPDX-License-Identifier: MIT
// Rolling resistance: an elastic-plastic spring against rolling, w_r the relative spin in the contact plane, P >= 0 the
// friction load, k_n the tangent of the normal law:
//
//   M* = rotated M - k_r w_r dt,   |M| <= mu_r R* P, direction kept     M acts on body 2, is the history
//   k_r = 9/4 k_n (mu_r R*)^2      w_r = w - (w.n) n,   w = w2 - w1
//
// Ai, Chen, Rotter & Ooi (2011), model C, without its dashpot. A ball that rolls on a plane
// at v0 stops after v0 / (5/7 mu_r g); on an incline it stays if tan(angle) < mu_r. Twisting (w.n) is free.
// Domain: any step; mu_r >= 0. History: three values. Error of one step: 9 ULP of the larger of M and k_r w_r dt
// (tests/laws/test_rolling_spring.cpp). M does not change with k_n: like ShearForce it is not conservative on closed loops
// that change the overlap.
#pragma once

#include <array>

#include "contactlaws/core/limit.hpp"
#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"
#include "contactlaws/tangential/rotation.hpp"

namespace contactlaws {

/// The empty rolling slot.
template <class T>
struct NoRolling {
  using Slot = RollingSlot<T>;
  template <class U>
  using Rebind = NoRolling<U>;
  static constexpr bool acts = false;

  struct State {};
  static constexpr const char* name = "NoRolling";
  static constexpr std::array<Parameter<NoRolling, T>, 0> parameters() { return {}; }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }
};

template <class T>
struct RollingSpring {
  using Slot = RollingSlot<T>;
  template <class U>
  using Rebind = RollingSpring<U>;
  static constexpr bool acts = true;

  T rolling_friction = T(0);  ///< mu_r [1]

  struct State {
    std::array<T, 3> rolling_couple = {T(0), T(0), T(0)};  ///< M [N m]
  };
  static constexpr const char* name = "RollingSpring";
  static constexpr std::array<Parameter<RollingSpring, T>, 1> parameters() {
    return {{{"rolling_friction", "1", &RollingSpring::rolling_friction, Range::not_negative()}}};
  }
  /// A couple from the relative spin changes sign when the bodies are swapped.
  static constexpr std::array<StateValue, 3> state_values() {
    return {{{"rolling_x", "N m", -1, ValueKind::vector},
             {"rolling_y", "N m", -1, ValueKind::vector},
             {"rolling_z", "N m", -1, ValueKind::vector}}};
  }

  /// k_r [N m]
  CONTACTLAWS_HD T stiffness(const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    const T arm = rolling_friction * pair.effective_radius;
    return T(T(9) / T(4)) * normal_stiffness * (arm * arm);
  }

  CONTACTLAWS_HD RollingResponse<T> respond(State& state, const RollingInput<T>& in) const noexcept {
    typename rotation::ProjectRestore<T>::State none;
    const Vec3<T>& n = in.kinematics.normal;
    const Vec3<T>& spin = in.kinematics.relative_spin;
    const Vec3<T> stored(state.rolling_couple[0], state.rolling_couple[1], state.rolling_couple[2]);
    const Vec3<T> rolled = (spin - n * dot<T>(spin, n)) * in.kinematics.dt;
    const T k = stiffness(in.pair, in.normal_stiffness);
    const Vec3<T> trial = rotation::ProjectRestore<T>::apply(none, stored, n, T(0)) - rolled * k;
    const T limit = rolling_friction * in.pair.effective_radius * in.load;
    const detail::LengthLimit<T> limited = detail::length_limit<T>(trial, limit, limit);
    const Vec3<T> couple = trial * limited.factor;
    state.rolling_couple = {couple.x(), couple.y(), couple.z()};
    return {couple, select<T>(limited.exceeded, limited.excess * limit, T(0)) / select<T>(k > T(0), k, T(1))};
  }

  /// Stored energy M^2 / (2 k_r) [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    const Vec3<T> couple(state.rolling_couple[0], state.rolling_couple[1], state.rolling_couple[2]);
    const T k = stiffness(pair, normal_stiffness);
    const Mask<T> closed = k > T(0);
    return select<T>(closed, dot<T>(couple, couple), T(0)) / (T(2) * select<T>(closed, k, T(1)));
  }
};

}  // namespace contactlaws

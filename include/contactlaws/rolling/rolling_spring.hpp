// SPDX-License-Identifier: MIT
// Rolling resistance: an elastic-plastic spring against rolling, w_r the relative spin in the contact plane, P >= 0 the
// friction load, k_n the tangent of the normal law:
//
//   M* = rotated M - k_r w_r dt,   |M| <= mu_r R* P, direction kept     M acts on body 2, is the history
//   k_r = 9/4 k_n (mu_r R*)^2      w_r = w - (w.n) n,   w = w2 - w1
//
// J. Ai, J.-F. Chen, J. M. Rotter & J. Y. Ooi (2011), Assessment of rolling resistance models in discrete element simulations, Powder
// Technology 206, model C, without its dashpot. A ball that rolls on a plane
// at v0 stops after v0 / (5/7 mu_r g); on an incline it stays if tan(angle) < mu_r. Twisting (w.n) is free.
// Domain: any step; mu_r >= 0. History: three values. Error of one step: 9 ULP of the larger of M and k_r w_r dt
// (tests/laws/test_rolling_spring.cpp). M does not change with k_n: like ShearForce it is not conservative on closed loops
// that change the overlap.
#pragma once

#include <array>
#include <limits>

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

namespace detail {

template <class T>
struct Rolled {
  RollingResponse<T> response;
  Vec3<T> spin;   ///< w_r [rad/s]
  Mask<T> slips;  ///< at the limit, to roundings: a step of dt = 0 finds what the one before found
};
/// One step of the spring k against rolling, whose couple is at most `limit`.
template <class T>
CONTACTLAWS_HD Rolled<T> roll(std::array<T, 3>& stored, const RollingInput<T>& in, const T& k,
                              const T& limit) noexcept {
  typename rotation::ProjectRestore<T>::State none;
  const Vec3<T>& n = in.kinematics.normal;
  const Vec3<T>& spin = in.kinematics.relative_spin;
  const Vec3<T> before = rotation::ProjectRestore<T>::apply(none, {stored[0], stored[1], stored[2]}, n, T(0));
  const Vec3<T> rolling = spin - n * dot<T>(spin, n);
  const Vec3<T> trial = before - rolling * in.kinematics.dt * k;
  const LengthLimit<T> limited = length_limit<T>(trial, limit, limit);
  const Vec3<T> couple = trial * limited.factor;
  stored = {couple.x(), couple.y(), couple.z()};
  using Lane = typename ScalarTraits<T>::Lane;
  const Mask<T> slips =
      negate<T>(norm<T>(couple) < limit * T(Lane(1) - Lane(16) * std::numeric_limits<Lane>::epsilon()));
  const T work = select<T>(limited.exceeded, T(limited.excess * limit), T(0)) / select<T>(k > T(0), k, T(1));
  return {{couple, work, T(0)}, rolling, slips};
}
/// M^2 / (2 k_r) [J]
template <class T>
CONTACTLAWS_HD T rolling_energy(const std::array<T, 3>& stored, const T& k) noexcept {
  const Vec3<T> couple(stored[0], stored[1], stored[2]);
  return spring_energy<T>(dot<T>(couple, couple), k);
}

}  // namespace detail

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
    const T limit = rolling_friction * in.pair.effective_radius * in.load;
    return detail::roll<T>(state.rolling_couple, in, stiffness(in.pair, in.normal_stiffness), limit).response;
  }

  /// Stored energy M^2 / (2 k_r) [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return detail::rolling_energy<T>(state.rolling_couple, stiffness(pair, normal_stiffness));
  }
};

}  // namespace contactlaws

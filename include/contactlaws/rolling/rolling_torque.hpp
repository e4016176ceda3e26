// SPDX-License-Identifier: MIT
// Constant directional torque against rolling, w_r the relative spin in the contact plane, P >= 0 the friction load:
//
//   M = -mu_r R* P w_r / |w_r|      w_r = w - (w.n) n,   w = w2 - w1;   M acts on body 2, and is 0 at rest
//
// J. Ai, J.-F. Chen, J. M. Rotter & J. Y. Ooi (2011), Assessment of rolling resistance models in discrete element simulations, Powder
// Technology 206, model A; LIGGGHTS cdt. It has no static solution: at rest it bears no couple, and a ball that has
// stopped is driven to and fro by mu_r R* P dt / I from step to step. Take RollingSpring where grains come to rest.
// A ball that rolls on a plane at v0 stops after v0 / (5/7 mu_r g). Twisting (w.n) is free. Domain: any step; mu_r >= 0.
// No history. Error: 4 ULP of the couple (tests/laws/test_rolling_laws.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

template <class T>
struct RollingTorque {
  using Slot = RollingSlot<T>;
  template <class U>
  using Rebind = RollingTorque<U>;
  static constexpr bool acts = true;

  T rolling_friction = T(0);  ///< mu_r [1]

  struct State {};
  static constexpr const char* name = "RollingTorque";
  static constexpr std::array<Parameter<RollingTorque, T>, 1> parameters() {
    return {{{"rolling_friction", "1", &RollingTorque::rolling_friction, Range::not_negative()}}};
  }
  static constexpr std::array<StateValue, 0> state_values() { return {}; }

  CONTACTLAWS_HD RollingResponse<T> respond(State&, const RollingInput<T>& in) const noexcept {
    const Vec3<T>& n = in.kinematics.normal;
    const Vec3<T>& spin = in.kinematics.relative_spin;
    const Vec3<T> rolling = spin - n * dot<T>(spin, n);
    const Mask<T> rests = dot<T>(rolling, rolling) <= T(0);  // a length has no derivative at 0
    if (all<T>(rests)) return {rolling * T(0), T(0), T(0)};
    const T speed = norm<T>(rolling);
    const T limit = rolling_friction * in.pair.effective_radius * in.load;
    const T divisor = select<T>(speed > T(0), speed, T(1));
    return {rolling * T(-limit / divisor), T(limit * speed * in.kinematics.dt), T(0)};
  }
  CONTACTLAWS_HD T energy(const State&, const PairProperties<T>&, const T&) const noexcept { return T(0); }
};

}  // namespace contactlaws

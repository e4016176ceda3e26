// SPDX-License-Identifier: MIT
// Twisting resistance: an elastic-plastic spring against the relative spin about the normal, P >= 0 the friction load, a the contact
// radius of Hertz, k_s = 8 G* a Mindlin's shear stiffness:
//
//   M* = M - k_t (w.n) dt,   |M| <= 2/3 mu a P      M n acts on body 2; M is the history
//   k_t = 1/2 k_s a^2 = 4 G* a^3,   a = k_n / (2 E*)
//
// J. S. Marshall (2009), Discrete-element modeling of particulate aerosol flows, J. Comput. Phys. 228, Eqs 30, 32 and 34 (numbers as
// LAMMPS's sources and documentation of twisting marshall give them), without the dashpot: that is in twisting_spring_dashpot.hpp. The
// limit is that of a constant pressure over the contact. A ball that spins on a plane under the limit L stops after I w0 / L.
// RollAndTwist puts a rolling law and this one into the slot. Domain: beside normal laws with the tangent 2 E* a, any step.
// History: one value. M does not change with k_t: like ShearForce it is not conservative on closed loops that change the overlap.
// Error of one step: 6 ULP of the larger of M and k_t (w.n) dt (tests/laws/test_rolling_laws.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

namespace detail {

template <class T>
struct Twisted {
  T spin;           ///< w.n [rad/s]
  T friction_work;  ///< [J]
};
/// One step of the spring k against twisting, whose couple is at most `limit`. `stored` is the couple before, and then after.
template <class T>
CONTACTLAWS_HD Twisted<T> twist(T& stored, const RollingInput<T>& in, const T& k, const T& limit) noexcept {
  const T spin = dot<T>(in.kinematics.relative_spin, in.kinematics.normal);
  const T trial = stored - k * T(spin * in.kinematics.dt);
  const T low = maximum<T>(trial, T(-limit));
  const T couple = minimum<T>(low, limit);
  const T slid = select<T>(trial < couple, T(couple - trial), T(trial - couple));
  stored = couple;
  return {spin, T(slid * limit / select<T>(k > T(0), k, T(1)))};
}
/// a of a normal law with the tangent 2 E* a [m]
template <class T>
CONTACTLAWS_HD T radius_of_tangent(const PairProperties<T>& pair, const T& normal_stiffness) noexcept {
  return normal_stiffness / (T(2) * pair.effective_young);
}

}  // namespace detail

template <class T>
struct TwistingSpring {
  using Slot = RollingSlot<T>;
  template <class U>
  using Rebind = TwistingSpring<U>;
  static constexpr bool acts = true;

  T twisting_friction = T(0);  ///< mu, that of sliding [1]

  struct State {
    T twisting_couple = T(0);  ///< M [N m]
  };
  static constexpr const char* name = "TwistingSpring";
  static constexpr std::array<Parameter<TwistingSpring, T>, 1> parameters() {
    return {{{"twisting_friction", "1", &TwistingSpring::twisting_friction, Range::not_negative()}}};
  }
  /// Swapping the bodies turns both the spin and the normal.
  static constexpr std::array<StateValue, 1> state_values() { return {{{"twisting_couple", "N m", +1}}}; }

  /// k_t [N m]
  CONTACTLAWS_HD T stiffness(const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    const T a = detail::radius_of_tangent<T>(pair, normal_stiffness);
    return T(4) * pair.effective_shear * a * (a * a);
  }

  /// The largest couple over P [m]
  CONTACTLAWS_HD T reach(const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return T(T(2) / T(3)) * twisting_friction * detail::radius_of_tangent<T>(pair, normal_stiffness);
  }

  CONTACTLAWS_HD RollingResponse<T> respond(State& state, const RollingInput<T>& in) const noexcept {
    const T limit = reach(in.pair, in.normal_stiffness) * in.load;
    const detail::Twisted<T> twisted =
        detail::twist<T>(state.twisting_couple, in, stiffness(in.pair, in.normal_stiffness), limit);
    return {in.kinematics.normal * state.twisting_couple, twisted.friction_work, T(0)};
  }

  /// Stored energy M^2 / (2 k_t) [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return detail::spring_energy<T>(state.twisting_couple * state.twisting_couple, stiffness(pair, normal_stiffness));
  }
};

/// Two laws in the rolling slot: one against rolling, one against twisting.
template <class T, class Rolling, class Twisting = TwistingSpring<T>>
struct RollAndTwist : Rolling, Twisting {
  using Slot = RollingSlot<T>;
  template <class U>
  using Rebind = RollAndTwist<U, typename Rolling::template Rebind<U>, typename Twisting::template Rebind<U>>;
  static constexpr bool acts = true;

  struct CONTACTLAWS_EMPTY_BASES State : Rolling::State, Twisting::State {};
  static constexpr const char* name = "RollAndTwist";
  static constexpr auto parameters() {
    return concatenate(inherited<RollAndTwist, T>(Rolling::parameters()),
                       inherited<RollAndTwist, T>(Twisting::parameters()));
  }
  static constexpr auto state_values() { return concatenate(Rolling::state_values(), Twisting::state_values()); }

  CONTACTLAWS_HD RollingResponse<T> respond(State& state, const RollingInput<T>& in) const noexcept {
    const RollingResponse<T> roll = Rolling::respond(state, in), twist = Twisting::respond(state, in);
    return {roll.couple + twist.couple, T(roll.friction_work + twist.friction_work),
            T(roll.dashpot_work + twist.dashpot_work)};
  }
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return Rolling::energy(state, pair, normal_stiffness) + Twisting::energy(state, pair, normal_stiffness);
  }
};

}  // namespace contactlaws

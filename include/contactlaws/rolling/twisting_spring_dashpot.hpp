// SPDX-License-Identifier: MIT
// Twisting resistance by an elastic-plastic spring and a dashpot, w.n the relative spin about the normal, P >= 0 the friction load:
//
//   M* = M - k_t (w.n) dt,   |M| <= L                                   M is the history (as TwistingSpring)
//   couple on body 2 = (M - c_t (w.n)) n,   |couple| <= L
//
//   MarshallTwisting   k_t = 1/2 k_s a^2,  c_t = 1/2 c_s a^2,  L = 2/3 mu a P;   k_s = 8 G* a,  c_s = alpha_t sqrt(m* k_s)
//   GivenTwisting      k_t, c_t, L = r_t P                              given; LAMMPS twisting sds
//
// J. S. Marshall (2009), Discrete-element modeling of particulate aerosol flows, J. Comput. Phys. 228, Eqs 30, 32 to 34 (numbers as
// LAMMPS's sources and documentation of twisting marshall give them). c_s is the coefficient of a dashpot against sliding: with
// alpha_t the constant of Dashpots, it is theirs. As in the shear slot friction limits the spring, and then spring and dashpot together;
// LAMMPS shortens the spring where the sum is limited, so that there the spring alone is below L while the contact twists.
// Domain: MarshallTwisting beside normal laws with the tangent 2 E* a; any step. History: one value.
// Error of one step: 8 ULP of the larger of the terms (tests/laws/test_rolling_laws.cpp).
#pragma once

#include "contactlaws/rolling/twisting_spring.hpp"

namespace contactlaws {

template <class T>
struct MarshallTwisting {
  template <class U>
  using Rebind = MarshallTwisting<U>;
  T twisting_friction = T(0);  ///< mu, that of sliding [1]
  T twisting_damping = T(0);   ///< alpha_t, that of a dashpot against sliding [1]
  static constexpr std::array<Parameter<MarshallTwisting, T>, 2> parameters() {
    return {{{"twisting_friction", "1", &MarshallTwisting::twisting_friction, Range::not_negative()},
             {"twisting_damping", "1", &MarshallTwisting::twisting_damping, Range::not_negative()}}};
  }
  /// k_t [N m]
  CONTACTLAWS_HD T stiffness(const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return TwistingSpring<T>{twisting_friction}.stiffness(pair, normal_stiffness);
  }
  /// c_t [N m s]
  CONTACTLAWS_HD T viscosity(const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    const T a = detail::radius_of_tangent<T>(pair, normal_stiffness);
    const Mask<T> touches = a > T(0);  // a square root has no derivative at 0
    const T shear_stiffness = T(8) * pair.effective_shear * select<T>(touches, a, T(1));
    const T sliding = twisting_damping * sqrt_of_product<T>(pair.effective_mass, shear_stiffness);
    return select<T>(touches, T(sliding * (a * a) / T(2)), T(0));
  }
  /// L over P [m]
  CONTACTLAWS_HD T reach(const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return TwistingSpring<T>{twisting_friction}.reach(pair, normal_stiffness);
  }
};
template <class T>
struct GivenTwisting {
  template <class U>
  using Rebind = GivenTwisting<U>;
  T twisting_stiffness = T(0);  ///< k_t [N m]
  T twisting_reach = T(0);      ///< r_t, the largest couple over the load [m]
  T twisting_viscosity = T(0);  ///< c_t [N m s]
  static constexpr std::array<Parameter<GivenTwisting, T>, 3> parameters() {
    return {{{"twisting_stiffness", "N m", &GivenTwisting::twisting_stiffness, Range::positive()},
             {"twisting_reach", "m", &GivenTwisting::twisting_reach, Range::not_negative()},
             {"twisting_viscosity", "N m s", &GivenTwisting::twisting_viscosity, Range::not_negative()}}};
  }
  CONTACTLAWS_HD T stiffness(const PairProperties<T>&, const T&) const noexcept { return twisting_stiffness; }
  CONTACTLAWS_HD T viscosity(const PairProperties<T>&, const T&) const noexcept { return twisting_viscosity; }
  CONTACTLAWS_HD T reach(const PairProperties<T>&, const T&) const noexcept { return twisting_reach; }
};

template <class T, class Rule = MarshallTwisting<T>>
struct TwistingSpringDashpot : Rule {
  using Slot = RollingSlot<T>;
  template <class U>
  using Rebind = TwistingSpringDashpot<U, typename Rule::template Rebind<U>>;
  static constexpr bool acts = true;

  using State = typename TwistingSpring<T>::State;
  static constexpr const char* name = "TwistingSpringDashpot";
  static constexpr auto parameters() { return inherited<TwistingSpringDashpot, T>(Rule::parameters()); }
  static constexpr auto state_values() { return TwistingSpring<T>::state_values(); }

  CONTACTLAWS_HD RollingResponse<T> respond(State& state, const RollingInput<T>& in) const noexcept {
    const T limit = this->reach(in.pair, in.normal_stiffness) * in.load;
    const detail::Twisted<T> twisted =
        detail::twist<T>(state.twisting_couple, in, this->stiffness(in.pair, in.normal_stiffness), limit);
    const T spring = state.twisting_couple;
    const T total = spring - this->viscosity(in.pair, in.normal_stiffness) * twisted.spin;
    const T low = maximum<T>(total, T(-limit));
    const T couple = minimum<T>(low, limit);
    return {in.kinematics.normal * couple, twisted.friction_work,
            T(T(spring - couple) * T(twisted.spin * in.kinematics.dt))};
  }

  /// Stored energy M^2 / (2 k_t) [J].
  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return detail::spring_energy<T>(state.twisting_couple * state.twisting_couple,
                                    this->stiffness(pair, normal_stiffness));
  }
};

}  // namespace contactlaws

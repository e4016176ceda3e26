// SPDX-License-Identifier: MIT
// Rolling resistance by an elastic-plastic spring and a dashpot, w_r the relative spin in the contact plane, P >= 0 the friction
// load, k_n the tangent of the normal law:
//
//   M* = rotated M - k_r w_r dt,   |M| <= mu_r R* P, direction kept     M is the history (as RollingSpring)
//   couple on body 2 = M - c_r w_r where |M*| is within the limit, else M;   c_r = alpha_r sqrt(m* R*^2 k_r)
//
//   AiRolling     k_r = 9/4 k_n (mu_r R*)^2       Ai et al. (2011), model C
//   ShearRolling  k_r = k_s R*^2                  Iwashita & Oda (1998); PFC's rolling resistance linear model
//   GivenRolling  k_r                             a given stiffness
//
// J. Ai, J.-F. Chen, J. M. Rotter & J. Y. Ooi (2011), Assessment of rolling resistance models in discrete element simulations, Powder
// Technology 206; K. Iwashita & M. Oda (1998), Rolling resistance at contacts in simulation of shear band development by DEM, J. Eng.
// Mech. 124. The dashpot ends where the spring yields (Ai et al.: f = 0). Their inertia about the contact point is m* R*^2 here, so that alpha_r
// is counted as alpha of Dashpots: 2 is critical where the moment of inertia is m* R*^2.
// Domain: any step. History: three values. Error of one step: as RollingSpring.
#pragma once

#include "contactlaws/rolling/rolling_spring.hpp"

namespace contactlaws {

template <class T>
struct AiRolling {
  template <class U>
  using Rebind = AiRolling<U>;
  static constexpr std::array<Parameter<AiRolling, T>, 0> parameters() { return {}; }
  CONTACTLAWS_HD T rolling_stiffness_of(const T& rolling_friction, const PairProperties<T>& pair,
                                        const T& normal_stiffness) const noexcept {
    return RollingSpring<T>{rolling_friction}.stiffness(pair, normal_stiffness);
  }
};
template <class T>
struct ShearRolling {
  template <class U>
  using Rebind = ShearRolling<U>;
  T stiffness_ratio = T(1);  ///< k_s / k_n [1]; Mindlin's: mindlin_ratio(pair)
  static constexpr std::array<Parameter<ShearRolling, T>, 1> parameters() {
    return {{{"stiffness_ratio", "1", &ShearRolling::stiffness_ratio, Range::positive()}}};
  }
  CONTACTLAWS_HD T rolling_stiffness_of(const T&, const PairProperties<T>& pair,
                                        const T& normal_stiffness) const noexcept {
    return stiffness_ratio * normal_stiffness * (pair.effective_radius * pair.effective_radius);
  }
};
template <class T>
struct GivenRolling {
  template <class U>
  using Rebind = GivenRolling<U>;
  T rolling_stiffness = T(0);  ///< k_r [N m]
  static constexpr std::array<Parameter<GivenRolling, T>, 1> parameters() {
    return {{{"rolling_stiffness", "N m", &GivenRolling::rolling_stiffness, Range::positive()}}};
  }
  CONTACTLAWS_HD T rolling_stiffness_of(const T&, const PairProperties<T>&, const T&) const noexcept {
    return rolling_stiffness;
  }
};

template <class T, class Stiffness = AiRolling<T>>
struct RollingSpringDashpot : Stiffness {
  using Slot = RollingSlot<T>;
  template <class U>
  using Rebind = RollingSpringDashpot<U, typename Stiffness::template Rebind<U>>;
  static constexpr bool acts = true;

  T rolling_friction = T(0);  ///< mu_r [1]
  T rolling_damping = T(0);   ///< alpha_r [1]

  using State = typename RollingSpring<T>::State;
  static constexpr const char* name = "RollingSpringDashpot";
  static constexpr auto parameters() {
    using This = RollingSpringDashpot;
    const std::array<Parameter<This, T>, 2> own{
        {{"rolling_friction", "1", &This::rolling_friction, Range::not_negative()},
         {"rolling_damping", "1", &This::rolling_damping, Range::not_negative()}}};
    return concatenate(own, inherited<This, T>(Stiffness::parameters()));
  }
  static constexpr auto state_values() { return RollingSpring<T>::state_values(); }

  /// k_r [N m]
  CONTACTLAWS_HD T stiffness(const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return this->rolling_stiffness_of(rolling_friction, pair, normal_stiffness);
  }

  CONTACTLAWS_HD RollingResponse<T> respond(State& state, const RollingInput<T>& in) const noexcept {
    const T k = stiffness(in.pair, in.normal_stiffness);
    const T limit = rolling_friction * in.pair.effective_radius * in.load;
    detail::Rolled<T> rolled = detail::roll<T>(state.rolling_couple, in, k, limit);
    const Mask<T> stiff = k > T(0);  // a square root has no derivative at 0
    const T root = sqrt_of_product<T>(in.pair.effective_mass, select<T>(stiff, k, T(1)));
    const T critical = in.pair.effective_radius * root;
    const T c = select<T>(rolled.slips || negate<T>(stiff), T(0), T(rolling_damping * critical));
    rolled.response.couple = rolled.response.couple - rolled.spin * c;
    rolled.response.dashpot_work = c * dot<T>(rolled.spin, rolled.spin) * in.kinematics.dt;
    return rolled.response;
  }

  CONTACTLAWS_HD T energy(const State& state, const PairProperties<T>& pair, const T& normal_stiffness) const noexcept {
    return detail::rolling_energy<T>(state.rolling_couple, stiffness(pair, normal_stiffness));
  }
};

}  // namespace contactlaws

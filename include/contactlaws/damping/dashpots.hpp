// SPDX-License-Identifier: MIT
// Viscous dashpots beside the springs. The damping ratio does not depend on the speed of an impact:
//
//   normal   F_d = -c_n v_n,   c_n = alpha   sqrt(m* k_n)     k_n [N/m]: the secant of the normal spring, F/d
//   shear    F_d = -c_s v_s,   c_s = alpha_s sqrt(m* k_s)     k_s [N/m]: the shear stiffness
//
// d is the elastic indentation: the overlap of smooth bodies, less for rough ones (normal/pohrt_popov.hpp).
// Tsuji, Tanaka & Ishida (1992); Potyondy (2019) Eqs 13, 17 and Table 4. For a linear spring alpha is twice the damping
// ratio. Domain: alpha >= 0; m* k must not underflow. No history.
// alpha from a coefficient of restitution: restitution.hpp. Error: <= 2 ULP in a coefficient, <= 3 in c_s = dashpot_ratio
// c_n (tests/laws/test_dashpots.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

/// Whether the normal dashpot may pull at the end of an impact, where its force exceeds the spring's.
enum class Tension {
  allowed,  ///< the sum of both, as Potyondy (2019) Eq. 13 has it
  clipped   ///< the sum is never below zero (of an adhesive law: never below minus its adhesion)
};

/// Which coefficient the shear dashpot has: DEM codes differ.
enum class ShearDashpot {
  like_normal,  ///< alpha_s = alpha (Potyondy 2019)
  none,         ///< alpha_s = 0: damping in the normal direction only
  given,        ///< alpha_s is a parameter of its own
  in_ratio      ///< alpha_s = alpha, sqrt(k_s / k_n) prepared: one root less in each step, for springs of a fixed ratio
};

/// The empty damping slot.
template <class T>
struct NoDashpots {
  using Slot = DampingSlot<T>;
  template <class U>
  using Rebind = NoDashpots<U>;
  static constexpr bool acts = false;
  static constexpr bool damps_shear = false;

  static constexpr const char* name = "NoDashpots";
  static constexpr std::array<Parameter<NoDashpots, T>, 0> parameters() { return {}; }

  CONTACTLAWS_HD DampingCoefficients<T> coefficients(const T&, const T&, const T&) const noexcept {
    return {T(0), T(0)};
  }
  CONTACTLAWS_HD T normal_force(const T& elastic, const T&, const T&) const noexcept { return elastic; }
  CONTACTLAWS_HD T stiffness_factor() const noexcept { return T(1); }
};

template <class T, Tension tension = Tension::allowed, ShearDashpot shear_dashpot = ShearDashpot::like_normal>
struct Dashpots {
  using Slot = DampingSlot<T>;
  template <class U>
  using Rebind = Dashpots<U, tension, shear_dashpot>;
  static constexpr bool acts = true;
  static constexpr bool damps_shear = shear_dashpot != ShearDashpot::none;

  T damping_constant = T(0);        ///< alpha [1]
  T shear_damping_constant = T(0);  ///< alpha_s [1]; a parameter with ShearDashpot::given, else unused

  static constexpr const char* name = "Dashpots";
  static constexpr auto parameters() {
    const std::array<Parameter<Dashpots, T>, 1> normal{
        {{"damping_constant", "1", &Dashpots::damping_constant, Range::not_negative()}}};
    if constexpr (shear_dashpot == ShearDashpot::given) {
      const std::array<Parameter<Dashpots, T>, 1> shear{
          {{"shear_damping_constant", "1", &Dashpots::shear_damping_constant, Range::not_negative()}}};
      return concatenate(normal, shear);
    } else {
      return normal;
    }
  }

  /// c_n and c_s [kg/s] for an effective mass [kg], the normal secant and the shear stiffness [N/m].
  CONTACTLAWS_HD DampingCoefficients<T> coefficients(const T& mass, const T& secant, const T& shear) const noexcept {
    if constexpr (shear_dashpot == ShearDashpot::none) {
      using std::sqrt;
      return {damping_constant * T(sqrt(T(mass * secant))), T(0)};
    } else {
      const std::array<T, 2> roots = sqrt_pair<T>(mass * secant, mass * shear);
      const T& in_shear = shear_dashpot == ShearDashpot::given ? shear_damping_constant : damping_constant;
      return {damping_constant * roots[0], in_shear * roots[1]};
    }
  }

  /// Spring and dashpot together [N]; `separating` = v_n [m/s].
  CONTACTLAWS_HD T normal_force(const T& elastic, const T& coefficient, const T& separating) const noexcept {
    const T total = elastic - coefficient * separating;
    if constexpr (tension == Tension::clipped) return positive_part<T>(total);
    return total;
  }

  /// Factor on the stiffness of a contact in the estimate of a stable step (Potyondy 2019, Eqs 20-21):
  /// 1 / (sqrt(1 + b^2) - b)^2 = (sqrt(1 + b^2) + b)^2, b = alpha/2, of the larger alpha where there are two.
  CONTACTLAWS_HD T stiffness_factor() const noexcept {
    using std::sqrt;
    T alpha = damping_constant;
    if constexpr (shear_dashpot == ShearDashpot::given) alpha = maximum<T>(alpha, shear_damping_constant);
    const T b = alpha / T(2);
    const T root = T(sqrt(T(T(1) + b * b))) + b;
    return root * root;
  }
};

/// c_s = dashpot_ratio c_n. mindlin_dashpot_ratio() gives the ratio for Mindlin's shear stiffness beside Hertz. With another
/// ratio than sqrt(k_s / k_n), alpha_s is not alpha, and stiffness_factor(), which reads alpha alone, may be too small.
template <class T, Tension tension>
struct Dashpots<T, tension, ShearDashpot::in_ratio> : Dashpots<T, tension, ShearDashpot::none> {
  using OfNormal = Dashpots<T, tension, ShearDashpot::none>;  ///< what computes c_n
  template <class U>
  using Rebind = Dashpots<U, tension, ShearDashpot::in_ratio>;
  static constexpr bool damps_shear = true;

  T dashpot_ratio = T(0);  ///< c_s / c_n = sqrt(k_s / k_n) [1]

  static constexpr auto parameters() {
    const std::array<Parameter<Dashpots, T>, 1> ratio{
        {{"dashpot_ratio", "1", &Dashpots::dashpot_ratio, Range::positive()}}};
    return concatenate(inherited<Dashpots, T>(OfNormal::parameters()), ratio);
  }

  CONTACTLAWS_HD DampingCoefficients<T> coefficients(const T& mass, const T& secant, const T& shear) const noexcept {
    const T normal = OfNormal::coefficients(mass, secant, shear).normal;
    return {normal, dashpot_ratio * normal};
  }
};

/// sqrt(k_s / k_n) of Mindlin's shear stiffness 8 G* a (Mindlin 1949) and Hertz's secant 4/3 E* a: sqrt(6 G*/E*) [1]. It lies
/// between 1 and sqrt(2). Error: <= 2 ULP.
template <class T>
T mindlin_dashpot_ratio(const EffectiveModuli<T>& moduli) {
  using std::sqrt;
  return sqrt(T(T(6) * moduli.shear / moduli.young));
}

}  // namespace contactlaws

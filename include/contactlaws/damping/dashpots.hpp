// SPDX-License-Identifier: MIT
// Viscous dashpots beside the springs, at a damping that no impact speed changes:
//
//   normal   F_d = -c_n v_n,   c_n = alpha sqrt(m* k_n o^(1/2))     k_n o^(1/2): the normal law's secant stiffness
//   shear    F_d = -c_s v_s,   c_s = alpha sqrt(m* k_s o^(1/2))     k_s o^(1/2): the shear stiffness
//
// Tsuji, Tanaka & Ishida (1992); Potyondy (2019) Eqs 13, 17 and Table 4. For a linear spring the same form holds and
// alpha is twice the damping ratio. Domain: alpha >= 0; m* k must not underflow. No history.
// alpha from a coefficient of restitution: restitution.hpp. Error: <= 2 ULP in a coefficient (tests/laws/test_dashpots.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/slot.hpp"

namespace contactlaws {

/// Whether the normal dashpot may pull at the end of an impact, when spring and dashpot together would.
enum class Tension {
  allowed,  ///< the sum of both, as Potyondy (2019) Eq. 13 writes it
  clipped   ///< never below zero
};

/// No dashpots: nothing computed.
template <class T>
struct NoDashpots {
  template <class U>
  using Rebind = NoDashpots<U>;
  static constexpr bool acts = false;

  static constexpr const char* name = "NoDashpots";
  static constexpr std::array<Parameter<NoDashpots, T>, 0> parameters() { return {}; }

  CONTACTLAWS_HD DampingCoefficients<T> coefficients(const T&, const T&, const T&) const noexcept {
    return {T(0), T(0)};
  }
  CONTACTLAWS_HD T normal_force(const T& elastic, const T&, const T&) const noexcept { return elastic; }
  CONTACTLAWS_HD T stiffness_factor() const noexcept { return T(1); }
};

template <class T, Tension tension = Tension::allowed>
struct Dashpots {
  template <class U>
  using Rebind = Dashpots<U, tension>;
  static constexpr bool acts = true;

  T damping_constant = T(0);  ///< alpha [1]

  static constexpr const char* name = "Dashpots";
  static constexpr std::array<Parameter<Dashpots, T>, 1> parameters() {
    return {{{"damping_constant", "1", &Dashpots::damping_constant, Range::not_negative()}}};
  }

  /// c_n and c_s [kg/s] for an effective mass [kg], a normal secant stiffness and a shear stiffness [N/m].
  CONTACTLAWS_HD DampingCoefficients<T> coefficients(const T& mass, const T& secant, const T& shear) const noexcept {
    const Eigen::Array<T, 2, 1> roots = sqrt_pair<T>(mass * secant, mass * shear);
    return {damping_constant * roots[0], damping_constant * roots[1]};
  }

  /// Spring and dashpot together [N]; `separating` = v_n [m/s].
  CONTACTLAWS_HD T normal_force(const T& elastic, const T& coefficient, const T& separating) const noexcept {
    const T total = elastic - coefficient * separating;
    if constexpr (tension == Tension::clipped) return positive_part<T>(total);
    return total;
  }

  /// Factor on a contact's stiffness in the estimate of a stable step (Potyondy 2019, Eqs 20-21):
  /// 1 / (sqrt(1 + b^2) - b)^2 = (sqrt(1 + b^2) + b)^2, b = alpha/2.
  CONTACTLAWS_HD T stiffness_factor() const noexcept {
    using std::sqrt;
    const T b = damping_constant / T(2);
    const T root = T(sqrt(T(T(1) + b * b))) + b;
    return root * root;
  }
};

}  // namespace contactlaws

// SPDX-License-Identifier: MIT
// Ready-made laws: the compositions that scenes ask for, and the memo's properties for the hill law.
#pragma once

#include "contactlaws/contact_law.hpp"
#include "contactlaws/core/validate.hpp"
#include "contactlaws/normal/hertz.hpp"
#include "contactlaws/normal/linear.hpp"
#include "contactlaws/normal/pohrt_popov.hpp"

namespace contactlaws {

/// Hertz alone: frictionless, undamped, dry. No state.
template <class T>
using SmoothHertz = ContactLaw<Hertz<T>>;

/// Hertz-Mindlin with dashpots and friction (Potyondy 2019, dry). State: the shear force.
template <class T, Tension tension = Tension::allowed>
using DryHill = ContactLaw<Hertz<T>, Dashpots<T, tension>, ShearForce<T>>;

/// The hill law: DryHill and a liquid bridge (Potyondy 2019). State: the shear force and the moisture state.
template <class T, Tension tension = Tension::allowed>
using Hill = ContactLaw<Hertz<T>, Dashpots<T, tension>, ShearForce<T>, SuctionBridge<T>>;

/// Linear springs from an effective modulus, with friction (Potyondy 2019, Sec. 2.1). State: the shear force.
template <class T>
using LinearFriction = ContactLaw<LinearModulus<T>, NoDashpots<T>, ShearForce<T, ConstantRatio<T>>>;

/// Linear springs of a given stiffness, dashpots and friction (Cundall & Strack 1979). State: the shear force.
template <class T, Tension tension = Tension::allowed>
using LinearSpringDashpot = ContactLaw<LinearSpring<T>, Dashpots<T, tension>, ShearForce<T, ConstantRatio<T>>>;

/// Rough ballast: Pohrt-Popov with loading history, friction, shear in a constant ratio (Tolomeo & McDowell 2022).
/// State: the largest overlap and the shear force.
template <class T>
using RoughBallast = ContactLaw<PohrtPopovElastoPlastic<T>, NoDashpots<T>, ShearForce<T, ConstantRatio<T>>>;

/// Properties of the hill law, with the memo's ranges and defaults (Potyondy 2019, Table 5).
template <class T>
struct HillProperties {
  T friction = T(0);          ///< mu [1]
  T suction = T(0);           ///< psi [Pa]
  T damping_constant = T(0);  ///< alpha_h [1]

  static constexpr const char* name = "HillProperties";
  static constexpr std::array<Parameter<HillProperties, T>, 3> parameters() {
    return {{{"friction", "1", &HillProperties::friction, Range::not_negative()},
             {"suction", "Pa", &HillProperties::suction, Range::not_negative()},
             {"damping_constant", "1", &HillProperties::damping_constant, Range::closed(0.0, 1.0)}}};
  }
};

/// The hill law. @throws std::invalid_argument naming the property out of range
template <class T>
Hill<T> hill(const HillProperties<T>& properties) {
  checked(properties);
  Hill<T> law;
  law.shear.friction = properties.friction;
  law.bridge.suction = properties.suction;
  law.damping.damping_constant = properties.damping_constant;
  return law;
}

/// The hill law that is never wet. @throws std::invalid_argument naming the property out of range
template <class T>
DryHill<T> dry_hill(const HillProperties<T>& properties) {
  const Hill<T> wet = hill(properties);
  return {wet.normal, wet.damping, wet.shear, {}};
}

}  // namespace contactlaws

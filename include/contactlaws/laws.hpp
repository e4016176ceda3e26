// SPDX-License-Identifier: MIT
// Ready-made laws, each with a maker that checks its parameters. Parameters are assigned by name:
//
//   HillProperties<double> properties;
//   properties.friction = 0.4;
//   properties.suction = 200e3;
//   const auto law = hill(properties);
//
// A maker throws std::invalid_argument naming the parameter, its value, unit and range. Programs that read names at run time
// use set_parameter(properties, "friction", 0.4).
#pragma once

#include "contactlaws/bridge/capillary_bridge.hpp"
#include "contactlaws/contact_law.hpp"
#include "contactlaws/core/validate.hpp"
#include "contactlaws/normal/dmt.hpp"
#include "contactlaws/normal/hertz.hpp"
#include "contactlaws/normal/jkr.hpp"
#include "contactlaws/normal/linear.hpp"
#include "contactlaws/normal/pohrt_popov.hpp"
#include "contactlaws/normal/thornton_ning.hpp"

namespace contactlaws {

/// Hertz alone: frictionless, undamped, dry. No state.
template <class T>
using SmoothHertz = ContactLaw<Hertz<T>>;

/// Hertz-Mindlin with dashpots and friction (Potyondy 2019, dry). State: the shear force.
template <class T, Tension tension = Tension::allowed, ShearDashpot shear = ShearDashpot::like_normal>
using DryHill = ContactLaw<Hertz<T>, Dashpots<T, tension, shear>, ShearForce<T>>;

/// The hill law: DryHill and a liquid bridge (Potyondy 2019). State: the shear force and the moisture.
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

/// Grains that yield: Thornton-Ning with Mindlin's shear and friction, for metals and soft salts. State: the largest overlap and the
/// shear force.
template <class T>
using PlasticGrains = ContactLaw<ThorntonNing<T>, NoDashpots<T>, ShearForce<T>>;

/// Cohesive powder: JKR adhesion, dashpots, friction, rolling resistance (Johnson, Kendall & Roberts 1971). State: whether the
/// contact holds, the shear force and the rolling couple.
template <class T, Tension tension = Tension::allowed>
using CohesivePowder = ContactLaw<Jkr<T>, Dashpots<T, tension>, ShearForce<T>, Dry<T>, RollingSpring<T>>;

/// Wet grains: DryHill, whose dashpots do not pull, and a liquid bridge of a given volume, by default formed where grains touch.
/// State: the shear force, the volume of the bridge and what ruptured bridges returned.
template <class T, template <class> class ForceRule = YoungLaplace, Wets wets = Wets::at_touch>
using WetGrains =
    ContactLaw<Hertz<T>, Dashpots<T, Tension::clipped>, ShearForce<T>, CapillaryBridge<T, ForceRule, wets>>;

/// First member of the properties: a list of numbers in braces does not compile, so none can land in the wrong place.
struct ByName {
  explicit ByName() = default;
};

template <class T>
struct DryHillProperties {
  ByName by_name = ByName();
  T friction = T(0);          ///< mu [1]
  T damping_constant = T(0);  ///< alpha [1]; from a coefficient of restitution: damping_constant()

  static constexpr const char* name = "DryHillProperties";
  static constexpr std::array<Parameter<DryHillProperties, T>, 2> parameters() {
    return {{{"friction", "1", &DryHillProperties::friction, Range::any()},
             {"damping_constant", "1", &DryHillProperties::damping_constant, Range::any()}}};
  }
};

template <class T>
struct HillProperties {
  ByName by_name = ByName();
  T friction = T(0);          ///< mu [1]
  T suction = T(0);           ///< psi [Pa]
  T damping_constant = T(0);  ///< alpha [1]; from a coefficient of restitution: damping_constant()

  static constexpr const char* name = "HillProperties";
  static constexpr std::array<Parameter<HillProperties, T>, 3> parameters() {
    return {{{"friction", "1", &HillProperties::friction, Range::any()},
             {"suction", "Pa", &HillProperties::suction, Range::any()},
             {"damping_constant", "1", &HillProperties::damping_constant, Range::any()}}};
  }
};

template <class T>
struct WetGrainsProperties {
  ByName by_name = ByName();
  T friction = T(0);          ///< mu [1]
  T damping_constant = T(0);  ///< alpha [1]; from a coefficient of restitution: damping_constant()
  T surface_tension = T(0);   ///< gamma [N/m]
  T contact_angle = T(0);     ///< theta [rad]
  T bridge_volume = T(0);     ///< of each new bridge [m^3]

  static constexpr const char* name = "WetGrainsProperties";
  static constexpr std::array<Parameter<WetGrainsProperties, T>, 5> parameters() {
    return {{{"friction", "1", &WetGrainsProperties::friction, Range::any()},
             {"damping_constant", "1", &WetGrainsProperties::damping_constant, Range::any()},
             {"surface_tension", "N/m", &WetGrainsProperties::surface_tension, Range::any()},
             {"contact_angle", "rad", &WetGrainsProperties::contact_angle, Range::any()},
             {"bridge_volume", "m^3", &WetGrainsProperties::bridge_volume, Range::any()}}};
  }
};

template <class T>
struct LinearFrictionProperties {
  ByName by_name = ByName();
  T modulus = T(0);          ///< effective modulus E [Pa]
  T friction = T(0);         ///< mu [1]
  T stiffness_ratio = T(1);  ///< k_s / k_n [1], the inverse of kappa

  static constexpr const char* name = "LinearFrictionProperties";
  static constexpr std::array<Parameter<LinearFrictionProperties, T>, 3> parameters() {
    return {{{"modulus", "Pa", &LinearFrictionProperties::modulus, Range::any()},
             {"friction", "1", &LinearFrictionProperties::friction, Range::any()},
             {"stiffness_ratio", "1", &LinearFrictionProperties::stiffness_ratio, Range::any()}}};
  }
};

template <class T>
struct LinearSpringDashpotProperties {
  ByName by_name = ByName();
  T normal_stiffness = T(0);  ///< k_n [N/m]
  T friction = T(0);          ///< mu [1]
  T stiffness_ratio = T(1);   ///< k_s / k_n [1]
  T damping_constant = T(0);  ///< alpha [1]; from a coefficient of restitution: damping_constant()

  static constexpr const char* name = "LinearSpringDashpotProperties";
  static constexpr std::array<Parameter<LinearSpringDashpotProperties, T>, 4> parameters() {
    return {{{"normal_stiffness", "N/m", &LinearSpringDashpotProperties::normal_stiffness, Range::any()},
             {"friction", "1", &LinearSpringDashpotProperties::friction, Range::any()},
             {"stiffness_ratio", "1", &LinearSpringDashpotProperties::stiffness_ratio, Range::any()},
             {"damping_constant", "1", &LinearSpringDashpotProperties::damping_constant, Range::any()}}};
  }
};

template <class T>
struct RoughBallastProperties {
  ByName by_name = ByName();
  T fractal_dimension = T(0);  ///< D_f [1]
  T roughness = T(0);          ///< h [m]
  T friction = T(0);           ///< mu [1]
  T stiffness_ratio = T(1);    ///< k_s / k_n [1]; Mindlin's: mindlin_ratio(pair)

  static constexpr const char* name = "RoughBallastProperties";
  static constexpr std::array<Parameter<RoughBallastProperties, T>, 4> parameters() {
    return {{{"fractal_dimension", "1", &RoughBallastProperties::fractal_dimension, Range::any()},
             {"roughness", "m", &RoughBallastProperties::roughness, Range::any()},
             {"friction", "1", &RoughBallastProperties::friction, Range::any()},
             {"stiffness_ratio", "1", &RoughBallastProperties::stiffness_ratio, Range::any()}}};
  }
};

template <class T>
struct PlasticGrainsProperties {
  ByName by_name = ByName();
  T yield_pressure = T(0);  ///< p_y [Pa]
  T friction = T(0);        ///< mu [1]

  static constexpr const char* name = "PlasticGrainsProperties";
  static constexpr std::array<Parameter<PlasticGrainsProperties, T>, 2> parameters() {
    return {{{"yield_pressure", "Pa", &PlasticGrainsProperties::yield_pressure, Range::any()},
             {"friction", "1", &PlasticGrainsProperties::friction, Range::any()}}};
  }
};

template <class T>
struct CohesivePowderProperties {
  ByName by_name = ByName();
  T work_of_adhesion = T(0);  ///< w [J/m^2], twice the surface energy of one material
  T friction = T(0);          ///< mu [1]
  T rolling_friction = T(0);  ///< mu_r [1]
  T damping_constant = T(0);  ///< alpha [1]

  static constexpr const char* name = "CohesivePowderProperties";
  static constexpr std::array<Parameter<CohesivePowderProperties, T>, 4> parameters() {
    return {{{"work_of_adhesion", "J/m^2", &CohesivePowderProperties::work_of_adhesion, Range::any()},
             {"friction", "1", &CohesivePowderProperties::friction, Range::any()},
             {"rolling_friction", "1", &CohesivePowderProperties::rolling_friction, Range::any()},
             {"damping_constant", "1", &CohesivePowderProperties::damping_constant, Range::any()}}};
  }
};

/// Makes SmoothHertz.
template <class T>
SmoothHertz<T> smooth_hertz() {
  return {};
}

/// Makes DryHill. @throws std::invalid_argument on a parameter out of its range
template <Tension tension = Tension::allowed, class T>
DryHill<T, tension> dry_hill(const DryHillProperties<T>& properties) {
  DryHill<T, tension> law;
  law.damping.damping_constant = properties.damping_constant;
  law.shear.friction = properties.friction;
  return checked(law);
}

/// Makes DryHill for contacts of one pair of materials: c_s/c_n is prepared from effective_moduli(), forces are equal to rounding.
/// Other materials get a wrong shear dashpot, unnoticed. @throws std::invalid_argument on a parameter out of its range
template <Tension tension = Tension::allowed, class T>
DryHill<T, tension, ShearDashpot::in_ratio> dry_hill(const DryHillProperties<T>& properties,
                                                     const EffectiveModuli<T>& moduli) {
  DryHill<T, tension, ShearDashpot::in_ratio> law;
  law.damping.damping_constant = properties.damping_constant;
  law.damping.dashpot_ratio = mindlin_dashpot_ratio(moduli);
  law.shear.friction = properties.friction;
  return checked(law);
}

/// Makes Hill. @throws std::invalid_argument on a parameter out of its range
template <Tension tension = Tension::allowed, class T>
Hill<T, tension> hill(const HillProperties<T>& properties) {
  Hill<T, tension> law;
  law.damping.damping_constant = properties.damping_constant;
  law.shear.friction = properties.friction;
  law.bridge.suction = properties.suction;
  return checked(law);
}

/// Makes WetGrains. @throws std::invalid_argument on a parameter out of its range
template <template <class> class ForceRule = YoungLaplace, Wets wets = Wets::at_touch, class T>
WetGrains<T, ForceRule, wets> wet_grains(const WetGrainsProperties<T>& properties) {
  WetGrains<T, ForceRule, wets> law;
  law.damping.damping_constant = properties.damping_constant;
  law.shear.friction = properties.friction;
  law.bridge.surface_tension = properties.surface_tension;
  law.bridge.contact_angle = properties.contact_angle;
  law.bridge.bridge_volume = properties.bridge_volume;
  law = checked(law);
  law.bridge.prepare();
  return law;
}

/// Makes LinearFriction. @throws std::invalid_argument on a parameter out of its range
template <class T>
LinearFriction<T> linear_friction(const LinearFrictionProperties<T>& properties) {
  LinearFriction<T> law;
  law.normal.modulus = properties.modulus;
  law.shear.friction = properties.friction;
  law.shear.ratio = properties.stiffness_ratio;
  return checked(law);
}

/// Makes LinearSpringDashpot. @throws std::invalid_argument on a parameter out of its range
template <Tension tension = Tension::allowed, class T>
LinearSpringDashpot<T, tension> linear_spring_dashpot(const LinearSpringDashpotProperties<T>& properties) {
  LinearSpringDashpot<T, tension> law;
  law.normal.normal_stiffness = properties.normal_stiffness;
  law.damping.damping_constant = properties.damping_constant;
  law.shear.friction = properties.friction;
  law.shear.ratio = properties.stiffness_ratio;
  return checked(law);
}

/// Makes RoughBallast. @throws std::invalid_argument on a parameter out of its range
template <class T>
RoughBallast<T> rough_ballast(const RoughBallastProperties<T>& properties) {
  RoughBallast<T> law;
  law.normal = PohrtPopovElastoPlastic<T>::of({properties.fractal_dimension, properties.roughness});
  law.shear.friction = properties.friction;
  law.shear.ratio = properties.stiffness_ratio;
  return checked(law);
}

/// Makes PlasticGrains. @throws std::invalid_argument on a parameter out of its range
template <class T>
PlasticGrains<T> plastic_grains(const PlasticGrainsProperties<T>& properties) {
  PlasticGrains<T> law;
  law.normal.yield_pressure = properties.yield_pressure;
  law.shear.friction = properties.friction;
  return checked(law);
}

/// Makes CohesivePowder. @throws std::invalid_argument on a parameter out of its range
template <Tension tension = Tension::allowed, class T>
CohesivePowder<T, tension> cohesive_powder(const CohesivePowderProperties<T>& properties) {
  CohesivePowder<T, tension> law;
  law.normal.work_of_adhesion = properties.work_of_adhesion;
  law.damping.damping_constant = properties.damping_constant;
  law.shear.friction = properties.friction;
  law.rolling.rolling_friction = properties.rolling_friction;
  return checked(law);
}

}  // namespace contactlaws

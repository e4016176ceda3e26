// SPDX-License-Identifier: MIT
// Effective properties of a pair of bodies, from materials, shapes and masses (Potyondy 2019, Table 4):
//
//   1/R* = c1 + c2                    c = 1/R, 0 for a plane, negative for a concave wall
//   1/E* = sum (1 - nu^2) / E         0 for a rigid body
//   1/G* = sum 2 (2 - nu)(1 + nu) / E
//   1/m* = sum 1/m                    0 for a fixed body
//
// Two ways: from two ContactBody, checked, once per pair; or from the EffectiveModuli of two materials, checked once per
// pair of materials, with the radii and masses of every contact.
//
// Domain: linear elastic isotropic materials; surfaces that do not conform (1/R* > 0).
// Error: R* <= 4 ULP, E* and G* <= 6, m* <= 9 (tests/composition/test_pair.cpp).
#pragma once

#include <array>

#include "contactlaws/core/parameter.hpp"
#include "contactlaws/core/scalar.hpp"
#include "contactlaws/core/validate.hpp"

namespace contactlaws {

/// A linear elastic, isotropic material.
template <class T>
struct ElasticMaterial {
  T young;    ///< Young's modulus E [Pa]
  T poisson;  ///< Poisson's ratio nu [1]
  T density;  ///< [kg/m^3]

  static constexpr const char* name = "ElasticMaterial";
  static constexpr std::array<Parameter<ElasticMaterial, T>, 3> parameters() {
    return {{{"young", "Pa", &ElasticMaterial::young, Range::positive()},
             {"poisson", "1", &ElasticMaterial::poisson, Range::left_open(-1.0, 0.5)},
             {"density", "kg/m^3", &ElasticMaterial::density, Range::positive()}}};
  }
};

/// The properties of a pair of bodies that a law needs. Where a host fills them itself, checked(pair) checks them.
template <class T>
struct PairProperties {
  T effective_radius;  ///<  R* [m]
  T effective_young;   ///< effective modulus E* [Pa]
  T effective_shear;   ///< effective shear modulus G* [Pa]
  T effective_mass;    ///< effective mass m* [kg]
  T min_radius;        ///< R_o, of the smaller body [m]
  T length;            ///< L = R1 + R2, the distance of the centres at touch; a wall adds nothing [m]

  static constexpr const char* name = "PairProperties";
  static constexpr std::array<Parameter<PairProperties, T>, 6> parameters() {
    return {{{"effective_radius", "m", &PairProperties::effective_radius, Range::positive()},
             {"effective_young", "Pa", &PairProperties::effective_young, Range::positive()},
             {"effective_shear", "Pa", &PairProperties::effective_shear, Range::positive()},
             {"effective_mass", "kg", &PairProperties::effective_mass, Range::positive()},
             {"min_radius", "m", &PairProperties::min_radius, Range::positive()},
             {"length", "m", &PairProperties::length, Range::positive()}}};
  }

  /// The same properties, each converted by `convert`: rounded to float, loaded into a pack.
  template <class U, class Convert>
  CONTACTLAWS_HD PairProperties<U> map(const Convert& convert) const {
    return {convert(effective_radius), convert(effective_young), convert(effective_shear),
            convert(effective_mass),   convert(min_radius),      convert(length)};
  }
  template <class U>
  CONTACTLAWS_HD PairProperties<U> cast() const {
    return map<U>([](const T& x) { return scalar_cast<U>(x); });
  }
};

/// One body of a contact, made by sphere(), plane() or spherical_cup(), then perhaps `.rigid()` or `.fixed()`.
template <class T>
struct ContactBody {
  T curvature;          ///< [1/m]
  T radius;             ///< [m], 0 for a wall
  T inverse_mass;       ///< [1/kg]
  T normal_compliance;  ///< (1 - nu^2) / E [1/Pa]
  T shear_compliance;   ///< 2 (2 - nu)(1 + nu) / E [1/Pa]

  /// The same body, undeformable.
  ContactBody rigid() const { return {curvature, radius, inverse_mass, T(0), T(0)}; }
  /// The same body, held in space.
  ContactBody fixed() const { return {curvature, radius, T(0), normal_compliance, shear_compliance}; }
  /// The same surface on a body of this mass [kg]. @throws std::invalid_argument unless mass > 0
  ContactBody with_mass(const T& mass) const {
    require_in(Range::positive(), static_cast<double>(mass), "ContactBody", "mass", "kg");
    return {curvature, radius, T(1) / mass, normal_compliance, shear_compliance};
  }
};

namespace detail {
template <class T>
ContactBody<T> body_of_material(const ElasticMaterial<T>& material, const T& curvature, const T& radius,
                                const T& inverse_mass) {
  checked(material);
  const T one = T(1);
  const T nu = material.poisson;
  return {curvature, radius, inverse_mass, (one - nu) * (one + nu) / material.young,
          T(2) * (T(2) - nu) * (one + nu) / material.young};
}
}  // namespace detail

/// Mass of a sphere [kg].
template <class T>
T sphere_mass(const T& radius, const T& density) {
  return T(4) / T(3) * pi<T>() * radius * radius * radius * density;
}

/// A sphere of this material. @throws std::invalid_argument unless the radius [m] is positive and finite
template <class T>
ContactBody<T> sphere(const ElasticMaterial<T>& material, const NonDeduced<T>& radius) {
  require_in(Range::positive(), static_cast<double>(radius), "sphere", "radius", "m");
  return detail::body_of_material<T>(material, T(1) / radius, radius, T(1) / sphere_mass<T>(radius, material.density));
}

/// A plane wall, held in space.
template <class T>
ContactBody<T> plane(const ElasticMaterial<T>& material) {
  return detail::body_of_material<T>(material, T(0), T(0), T(0));
}

/// The inside of a spherical wall, held in space. @throws std::invalid_argument unless the radius [m] is positive
template <class T>
ContactBody<T> spherical_cup(const ElasticMaterial<T>& material, const NonDeduced<T>& radius) {
  require_in(Range::positive(), static_cast<double>(radius), "spherical_cup", "radius", "m");
  return detail::body_of_material<T>(material, T(-1) / radius, T(0), T(0));
}

/// Effective properties of two bodies in contact.
/// @throws std::invalid_argument if the two surfaces conform (1/R* <= 0), or both are rigid, or both are fixed
template <class T>
PairProperties<T> pair_properties(const ContactBody<T>& a, const ContactBody<T>& b) {
  const auto inverse_of = [](const T& sum, const char* what, const char* unit) {
    require_in(Range::positive(), static_cast<double>(sum), "pair_properties", what, unit);
    return T(T(1) / sum);
  };
  const T radius = inverse_of(T(a.curvature + b.curvature), "1/R* (the sum of the curvatures)", "1/m");
  const T young = inverse_of(T(a.normal_compliance + b.normal_compliance), "1/E* (one side must deform)", "1/Pa");
  const T shear = inverse_of(T(a.shear_compliance + b.shear_compliance), "1/G* (one side must deform)", "1/Pa");
  const T mass = inverse_of(T(a.inverse_mass + b.inverse_mass), "1/m* (one side must be free)", "1/kg");
  const T length = a.radius + b.radius;
  const bool both_spheres = a.radius > T(0) && b.radius > T(0);
  return {radius, young, shear, mass, both_spheres ? minimum<T>(a.radius, b.radius) : length, length};
}

/// E* and G* of two materials.
template <class T>
struct EffectiveModuli {
  T young;  ///< E* [Pa]
  T shear;  ///< G* [Pa]
};

/// Effective moduli of two materials. @throws std::invalid_argument as checked(ElasticMaterial)
template <class T>
EffectiveModuli<T> effective_moduli(const ElasticMaterial<T>& a, const ElasticMaterial<T>& b) {
  const auto one = detail::body_of_material<T>(a, T(0), T(0), T(0)),
             other = detail::body_of_material<T>(b, T(0), T(0), T(0));
  return {T(1) / (one.normal_compliance + other.normal_compliance),
          T(1) / (one.shear_compliance + other.shear_compliance)};
}

/// Effective mass of two free bodies [kg]. Beside a body held in space it is the mass of the other.
template <class T>
CONTACTLAWS_HD T effective_mass(const T& mass1, const T& mass2) noexcept {
  return mass1 * mass2 / (mass1 + mass2);
}

/// Two spheres, where a host has their radii [m] and effective mass [kg]. Not checked.
template <class T>
CONTACTLAWS_HD PairProperties<T> sphere_sphere_pair(const EffectiveModuli<T>& moduli, const NonDeduced<T>& radius1,
                                                    const NonDeduced<T>& radius2, const NonDeduced<T>& mass) noexcept {
  const T length = radius1 + radius2;
  return {radius1 * radius2 / length, moduli.young, moduli.shear, mass, minimum<T>(radius1, radius2), length};
}

/// A plane wall and a sphere of this radius [m] and mass [kg]. Not checked.
template <class T>
CONTACTLAWS_HD PairProperties<T> plane_sphere_pair(const EffectiveModuli<T>& moduli, const NonDeduced<T>& radius,
                                                   const NonDeduced<T>& mass) noexcept {
  return {radius, moduli.young, moduli.shear, mass, radius, radius};
}

}  // namespace contactlaws

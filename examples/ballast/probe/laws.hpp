// SPDX-License-Identifier: MIT
// The three contact laws of the probe, with the parameters of Tolomeo & McDowell (2022), Table 1 and section 2.3.
#pragma once

#include <string>

#include "contactlaws/contactlaws.hpp"

namespace probe {

inline const contactlaws::ElasticMaterial<double> granite{60e9, 0.25, 2700.0};  // the density is ours
inline const contactlaws::RoughSurface<double> surface{2.13, 26.1e-6};
constexpr double friction = 0.7;
constexpr double boundary_stiffness = 3e6;  ///< [N/m] of contacts with platens and cylinder

template <class Normal>
using ContactLaw = contactlaws::ContactLaw<Normal, contactlaws::NoDashpots<double>,
                                           contactlaws::ShearForce<double, contactlaws::ConstantRatio<double>>>;
using Hertz = ContactLaw<contactlaws::Hertz<double>>;
using Elastic = ContactLaw<contactlaws::PohrtPopov<double>>;
using ElastoPlastic = ContactLaw<contactlaws::PohrtPopovElastoPlastic<double>>;  // contactlaws::RoughBallast
using Boundary = contactlaws::ContactLaw<contactlaws::LinearSpring<double>>;

/// k_s / k_n: that of Hertz-Mindlin, which depends on Poisson's ratio alone (Eq. 7).
inline double stiffness_ratio() { return 2.0 * (1.0 - granite.poisson) / (2.0 - granite.poisson); }

/// The law of a type; frictionless where `mu` is 0.
template <class Law>
Law make_law(double mu) {
  Law law;
  if constexpr (!std::is_same_v<Law, Hertz>) law.normal = decltype(law.normal)::of(surface);
  law.shear.friction = mu;
  law.shear.ratio = stiffness_ratio();
  return contactlaws::checked(law);
}
inline Boundary boundary_law(double stiffness = boundary_stiffness) {
  Boundary law;
  law.normal.normal_stiffness = stiffness;
  return contactlaws::checked(law);
}

template <class Law>
constexpr const char* law_name() {
  if (std::is_same_v<Law, Hertz>) return "hertz";
  return std::is_same_v<Law, Elastic> ? "elastic" : "elasto_plastic";
}

}  // namespace probe

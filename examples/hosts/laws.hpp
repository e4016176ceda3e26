// SPDX-License-Identifier: MIT
// The laws that the adapters of this folder offer by name: one table for all hosts. A law of your own is one line in it, and,
// where it has a maker, one function make_law().
#pragma once

#include <limits>
#include <string>
#include <type_traits>

#include "contactlaws/contactlaws.hpp"

namespace contactlaws {

/// Hertz and dashpots with a shear law.
template <template <class, class...> class Shear>
using HertzWith = ContactLaw<Hertz<double>, Dashpots<double>, Shear<double>>;

/// Hertz, dashpots and partial slip.
using PartialSlip = ContactLaw<Hertz<double>, Dashpots<double>, MindlinDeresiewicz<double>>;

/// Calls visit(name, parameters) for each law. Parameters: those of a maker, or a law, which is its own parameters.
template <class Visit>
void visit_laws(const Visit& visit) {
  visit("smooth_hertz", SmoothHertz<double>());
  visit("dry_hill", DryHill<double>());
  visit("dry_hill/rescaled", HertzWith<ShearForceRescaled>());
  visit("dry_hill/displacement", HertzWith<ShearDisplacement>());
  visit("dry_hill/displacement_rescaled", HertzWith<ShearDisplacementRescaled>());
  visit("dry_hill/partial_slip", PartialSlip());
  visit("hill", Hill<double>());
  visit("wet_grains", WetGrainsProperties<double>());
  visit("cohesive_powder", CohesivePowderProperties<double>());
  visit("rough_ballast", RoughBallastProperties<double>());
  visit("plastic_grains", PlasticGrainsProperties<double>());
  visit("linear_friction", LinearFrictionProperties<double>());
  visit("linear_spring_dashpot", LinearSpringDashpotProperties<double>());
}

/// The law of these parameters. @throws std::invalid_argument naming the one that is out of its range
template <class... Slots>
ContactLaw<Slots...> make_law(const ContactLaw<Slots...>& law) {
  return checked(law);
}
inline WetGrains<double> make_law(const WetGrainsProperties<double>& p) { return wet_grains(p); }
inline CohesivePowder<double> make_law(const CohesivePowderProperties<double>& p) { return cohesive_powder(p); }
inline RoughBallast<double> make_law(const RoughBallastProperties<double>& p) { return rough_ballast(p); }
inline PlasticGrains<double> make_law(const PlasticGrainsProperties<double>& p) { return plastic_grains(p); }
inline LinearFriction<double> make_law(const LinearFrictionProperties<double>& p) { return linear_friction(p); }
inline LinearSpringDashpot<double> make_law(const LinearSpringDashpotProperties<double>& p) {
  return linear_spring_dashpot(p);
}
template <class Parameters>
using LawOf = decltype(make_law(Parameters()));

/// Whether a law has a liquid bridge; whether its history counts the volume of the liquid.
template <class Law>
inline constexpr bool has_bridge = decltype(Law::bridge)::acts;
template <class Law, class = void>
inline constexpr bool holds_liquid = false;
template <class Law>
inline constexpr bool holds_liquid<Law, std::void_t<decltype(Law::State::returned_volume)>> = true;

/// Takes what ruptured bridges returned, less what new ones took, out of a history [m^3].
template <class State>
double take_returned(State& state) {
  const double volume = state.returned_volume;
  state.returned_volume = 0.0;
  return volume;
}

/// Whether a law reads the moduli of the bodies; one of linear springs has its own stiffness.
template <class Parameters>
inline constexpr bool reads_moduli = true;
template <>
inline constexpr bool reads_moduli<LinearFrictionProperties<double>> = false;
template <>
inline constexpr bool reads_moduli<LinearSpringDashpotProperties<double>> = false;

/// A material of which nothing is given yet.
inline ElasticMaterial<double> no_material() {
  constexpr double missing = std::numeric_limits<double>::quiet_NaN();
  return {missing, missing, 1.0};
}
/// The moduli of two materials. @throws std::invalid_argument if a value is missing or out of its range
inline EffectiveModuli<double> given_moduli(const ElasticMaterial<double>& a, const ElasticMaterial<double>& b) {
  for (const auto& material : {a, b})
    visit_parameters(material, [](const char*, const auto& p, double value) {
      if (value != value) reject(std::string(p.name) + " is missing, must lie in " + to_string(p.range) + ' ' + p.unit);
    });
  return effective_moduli(a, b);
}

/// The parameter of laws with dashpots that stands for their damping constant; none of other laws.
template <class Parameters>
inline constexpr const char* restitution_name =
    std::decay_t<decltype(LawOf<Parameters>::damping)>::acts ? "restitution" : "";

/// Where `name` is that parameter: sets the damping constant for a restitution of impacts at which nothing pulls. Returns whether it is.
template <class Parameters>
bool set_restitution(Parameters& parameters, const std::string& name, double value) {
  if constexpr (*restitution_name<Parameters> != 0) {
    if (name != restitution_name<Parameters>) return false;
    set_parameter(parameters, "damping_constant", damping_constant<LawOf<Parameters>>(value));
    return true;
  }
  return false;
}

/// Sets a parameter by name, `restitution` among them; `others`, which the host sets itself, are listed beside an unknown name.
/// @throws std::invalid_argument listing the names
template <class Parameters>
void set_law_parameter(Parameters& parameters, const std::string& name, double value, std::string others) {
  if (set_restitution(parameters, name, value)) return;
  if (const std::string own = restitution_name<Parameters>; !own.empty()) others = own + ", " + others;
  set_parameter(parameters, name, value, others);
}

}  // namespace contactlaws

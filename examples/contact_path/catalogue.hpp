// SPDX-License-Identifier: MIT
// What a LAW.toml may say: the laws of each slot by name, and their keys. One table serves the reader (law_file.hpp) and
// the help (list.hpp). Names, units, ranges and defaults of numbers come from the laws' own tables, parameters().
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ballast/pohrt_popov_incremental.hpp"
#include "contactlaws/laws.hpp"

namespace contact_path {

enum class Presence {
  required,
  optional,
  either  ///< exactly one of the keys so marked
};

struct NumberKey {
  std::string name;
  std::string unit;
  contactlaws::Range range;
  Presence presence;
  std::string says;

  NumberKey renamed(const std::string& other) const { return {other, unit, range, presence, says}; }
};

/// One of a few words; the first where the key is left out.
struct WordKey {
  std::string name;
  std::vector<std::string> words;
  std::string says;
};

/// true or false; false where the key is left out.
struct FlagKey {
  std::string name;
  std::string says;
};

/// A law that a slot may hold, or another group of keys.
struct Choice {
  std::string name;
  std::string says;
  std::vector<std::string> of_pair;  ///< what it must be told of the pair
  std::vector<NumberKey> numbers;
  std::vector<WordKey> words;
  std::vector<FlagKey> flags;
};

namespace detail {

/// The number called `name` in the table of `Owner`.
template <class Owner>
NumberKey number(const std::string& name, Presence presence, const std::string& says = "") {
  for (const auto& p : Owner::parameters()) {
    if (name != p.name) continue;
    std::ostringstream remark;
    remark << says;
    if (presence == Presence::optional && says.empty()) remark << "default " << Owner{}.*(p.member);
    return {p.name, p.unit, p.range, presence, remark.str()};
  }
  throw std::logic_error("no parameter " + name);
}

inline std::vector<NumberKey> rough_surface() {
  using Surface = contactlaws::RoughSurface<double>;
  return {number<Surface>("fractal_dimension", Presence::required),
          number<Surface>("roughness", Presence::required, "root mean square height")};
}

inline std::vector<NumberKey> rough_surface_and_seed() {
  std::vector<NumberKey> numbers = rough_surface();
  numbers.push_back(number<contactlaws::PohrtPopovIncremental<double>>("seed_force", Presence::required,
                                                                       "what a closing contact starts from"));
  return numbers;
}

inline Choice shear_history(const std::string& name, const std::string& says) {
  using Shear = contactlaws::ShearForce<double, contactlaws::ConstantRatio<double>>;
  const std::string condition = name == "constant_ratio" ? "" : "not with normal hertz, where k is Mindlin's 8 G* a; ";
  return {name,
          says,
          {},
          {number<Shear>("friction", Presence::required),
           number<Shear>("ratio", Presence::optional,
                         condition + "k / (dF_n/do), default: as Mindlin's to Hertz's, 4 G*/E* of the pair")},
          {{"carry", {"project_restore", "project", "rotate"}, "how the shear vector follows the contact plane"}},
          {}};
}

}  // namespace detail

inline const std::vector<Choice>& normal_choices() {
  using namespace contactlaws;
  using detail::number;
  static const std::vector<Choice> choices{
      {"linear",
       "F = k o, with k given, or k = E pi r^2/L from an effective modulus",
       {},
       {number<LinearSpring<double>>("normal_stiffness", Presence::either).renamed("stiffness"),
        number<LinearModulus<double>>("modulus", Presence::either, "asks for the pair's min_radius and length")},
       {},
       {}},
      {"hertz", "F = 4/3 E* sqrt(R*) o^(3/2)", {"radius", "young"}, {}, {}, {}},
      {"pohrt_popov", "rough surfaces, elastic", {"radius", "young"}, detail::rough_surface(), {}, {}},
      {"pohrt_popov_elasto_plastic",
       "rough surfaces that flatten: unloading and reloading along Hertz's curve, in closed form",
       {"radius", "young"},
       detail::rough_surface(),
       {{"recontact", {"same_spot", "fresh_surface"}, "what is remembered once the bodies have been apart"}},
       {}},
      {"pohrt_popov_incremental",
       "the same by increments F := F + k(F) do",
       {"radius", "young"},
       detail::rough_surface_and_seed(),
       {{"unloads", {"plastically", "elastically"}, "whether surfaces flatten"}},
       {}}};
  return choices;
}

inline const std::vector<Choice>& damping_choices() {
  using namespace contactlaws;
  using detail::number;
  static const std::vector<Choice> choices{
      {"none", "", {}, {}, {}, {}},
      {"dashpots",
       "c = damping_constant sqrt(m* k), normal and shear",
       {"mass"},
       {number<Dashpots<double>>("damping_constant", Presence::either),
        {"restitution", "1", Range::left_open(0.0, 1.0), Presence::either,
         "coefficient of restitution instead; for normal hertz and linear"}},
       {{"tension", {"allowed", "clipped"}, "whether spring and dashpot together may pull"}},
       {}}};
  return choices;
}

inline const std::vector<Choice>& shear_choices() {
  static const std::vector<Choice> choices{
      {"none", "frictionless", {}, {}, {}, {}},
      detail::shear_history("force", "the history is the shear force, kept as the overlap changes"),
      detail::shear_history("force_rescaled", "the same, times k/k_before where k falls"),
      detail::shear_history("displacement", "the history is the shear displacement d; force = -k d"),
      detail::shear_history("displacement_rescaled", "the same, times k/k_before where k falls"),
      detail::shear_history("constant_ratio", "as force, but k is in a constant ratio to the normal law's tangent")};
  return choices;
}

inline const std::vector<Choice>& bridge_choices() {
  using Bridge = contactlaws::SuctionBridge<double>;
  using detail::number;
  static const std::vector<Choice> choices{
      {"none", "dry", {}, {}, {}, {}},
      {"suction",
       "F = psi pi R_o^2 exp(-gap / (decay_length R_o)), until the gap is rupture_gap R_o",
       {"min_radius"},
       {number<Bridge>("suction", Presence::required, "psi"), number<Bridge>("decay_length", Presence::optional),
        number<Bridge>("rupture_gap", Presence::optional)},
       {},
       {{"wet", "whether the contact is wet before the first step"}}}};
  return choices;
}

/// [pair], where it states effective values.
inline const Choice& effective_pair() {
  const auto key = [](const char* name, const char* unit, const char* says) {
    return NumberKey{name, unit, contactlaws::Range::positive(), Presence::optional, says};
  };
  static const Choice choice{
      "pair",
      "effective values: those that the law asks for",
      {},
      {key("radius", "m", "1/R* = 1/R1 + 1/R2"), key("young", "Pa", "1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2"),
       key("shear", "Pa", "1/G* = 2(2-nu1)(1+nu1)/E1 + 2(2-nu2)(1+nu2)/E2"), key("mass", "kg", "1/m* = 1/m1 + 1/m2"),
       key("min_radius", "m", "R_o, of the smaller body"), key("length", "m", "L = R1 + R2; a wall adds nothing")},
      {},
      {}};
  return choice;
}

/// [pair.body1] and [pair.body2].
inline const Choice& body() {
  using Material = contactlaws::ElasticMaterial<double>;
  using contactlaws::Range;
  using detail::number;
  static const Choice choice{
      "body",
      "a sphere, or a wall",
      {},
      {{"radius", "m", Range::positive(), Presence::optional, "unless plane"},
       number<Material>("young", Presence::optional, "unless rigid"),
       number<Material>("poisson", Presence::optional, "unless rigid"),
       number<Material>("density", Presence::optional, "this or mass, unless fixed or plane"),
       {"mass", "kg", Range::positive(), Presence::optional, ""}},
      {},
      {{"plane", "a flat wall, held in space"}, {"fixed", "held in space"}, {"rigid", "does not deform"}}};
  return choice;
}

}  // namespace contact_path

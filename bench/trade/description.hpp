// SPDX-License-Identifier: MIT
// From a LAW.toml to a composition and its numbers, and what may be simplified about it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "../../examples/contact_path/build_law.hpp"
#include "../../examples/contact_path/law_file.hpp"
#include "composition.hpp"

namespace trade {

using contact_path::LawDescription;

/// @throws contact_path::InputError for what this program does not measure
inline Composition composition_of(const LawDescription& law) {
  Composition c;
  const std::string& normal = law.normal.law;
  const auto only = [&](const char* key, const char* measured) {
    if (law.normal.words.count(key) > 0 && law.normal.word(key) != measured)
      contact_path::fail(law.normal.place, "[normal] " + std::string(key) + " = \"" + law.normal.word(key) +
                                               "\" is not measured here, only the default, \"" + measured + '"');
  };
  only("recontact", "same_spot");
  only("unloads", "plastically");
  if (normal == "linear") c.normal = NormalForm::linear;
  if (normal == "hertz") c.normal = NormalForm::hertz;
  if (normal == "pohrt_popov") c.normal = NormalForm::elastic;
  if (normal == "pohrt_popov_elasto_plastic") c.normal = NormalForm::plastic;
  if (normal == "pohrt_popov_incremental") c.normal = NormalForm::incremental;
  if (law.damping.law != "none")
    c.damping = law.damping.word("tension") == "clipped" ? Damping::clipped : Damping::allowed;
  if (law.shear.law != "none") {
    c.history = History::force;
    for (const History h : {History::force_rescaled, History::displacement, History::displacement_rescaled})
      if (law.shear.law == name(h)) c.history = h;
    for (const Carrying k : {Carrying::project, Carrying::project_restore, Carrying::rotate})
      if (law.shear.word("carry") == name(k)) c.carrying = k;
  }
  c.bridge = law.bridge.law != "none";
  return c;
}

/// @throws contact_path::InputError if the bodies do not make a pair
inline Parameters parameters_of(const LawDescription& law) {
  namespace build = contact_path::detail;
  using namespace contactlaws;
  const auto slots = contact_path::build_law<double>(law);  // checks what it builds
  Parameters p{slots.pair};
  if (law.normal.has("modulus"))
    p.normal_stiffness = LinearModulus<double>{law.normal.number<double>("modulus")}.normal_stiffness(p.pair);
  if (law.normal.has("stiffness")) p.normal_stiffness = law.normal.number<double>("stiffness");
  if (law.normal.has("roughness"))
    p.surface = PohrtPopov<double>::of(build::filled<double>(RoughSurface<double>{}, law.normal));
  if (law.normal.has("seed_force")) p.seed_force = law.normal.number<double>("seed_force");
  std::visit(
      [&p](const auto& damping) {
        if constexpr (std::decay_t<decltype(damping)>::acts) p.damping_constant = damping.damping_constant;
      },
      slots.damping);
  if (law.shear.law != "none") {
    p.friction = law.shear.number<double>("friction");
    if (!law.is_mindlin()) {
      p.ratio = law.shear.has("ratio") ? law.shear.number<double>("ratio") : mindlin_ratio<double>(p.pair);
      p.pair.effective_shear =
          p.ratio * p.pair.effective_young / 4.0;  // the same stiffness as Mindlin's, for a Hertz contact
    }
  }
  p.bridge = build::filled<double>(SuctionBridge<double>{}, law.bridge);
  p.starts_wet = slots.starts_wet;
  return p;
}

/// Normal forms that may stand in for `form`, itself first.
inline std::vector<NormalForm> stand_ins(NormalForm form) {
  using N = NormalForm;
  switch (form) {
    case N::linear:
      return {N::linear};
    case N::hertz:
      return {N::hertz};
    case N::elastic:
      return {N::elastic, N::hertz};
    case N::plastic:
      return {N::plastic, N::elastic, N::hertz, N::incremental};
    case N::incremental:
      return {N::incremental, N::plastic, N::elastic, N::hertz};
  }
  return {form};
}

/// Every composition that may stand in for `full` where geometry is given in double: slots left out, other histories and
/// carryings, other normal forms, the law in float. `full` comes first.
inline std::vector<Composition> simplifications(const Composition& full) {
  std::vector<Composition> all;
  const auto or_none = [](auto x, auto none) {
    return x == none ? std::vector<decltype(x)>{none} : std::vector<decltype(x)>{x, none};
  };
  std::vector<History> histories{full.history};
  std::vector<Carrying> carryings{full.carrying};
  if (full.history != History::none) {
    for (const History h : {History::force, History::force_rescaled, History::displacement,
                            History::displacement_rescaled, History::none})
      if (h != full.history) histories.push_back(h);
    for (const Carrying k : {Carrying::project_restore, Carrying::project, Carrying::rotate})
      if (k != full.carrying) carryings.push_back(k);
  }
  for (const NormalForm normal : stand_ins(full.normal))
    for (const Damping damping : or_none(full.damping, Damping::none))
      for (const History history : histories)
        for (const Carrying carrying : carryings)
          for (const bool bridge : or_none(full.bridge, false))
            for (const Precision precision : {Precision::in_double, Precision::law_in_float})
              if (history != History::none || carrying == carryings.front())
                all.push_back({normal, damping, history, carrying, bridge, precision, Path::scalar});
  return all;
}

}  // namespace trade

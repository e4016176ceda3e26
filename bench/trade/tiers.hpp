// SPDX-License-Identifier: MIT
// The tiers of a law: what may be chosen about it, one choice changed at a time from how it is offered by default.
#pragma once

#include <string>
#include <vector>

#include "description.hpp"

namespace trade {

/// How far rounding may take a tier's force from the same composition's in 200 bits, as a share of the largest force of each
/// contact's path. Overlaps are differences of positions 0.1 m from the origin: what these are rounded by, an overlap of
/// 2e-6 m or more is wrong by, and a law adds little. A law in float, told overlaps in double, rounds its shear by 6e-8 in
/// each of 240 steps.
inline double rounding_bound(Precision precision) {
  switch (precision) {
    case Precision::in_double:
      return 1e-11;
    case Precision::law_in_float:
      return 2e-5;
    case Precision::in_float:
      return 5e-2;
  }
  return 0.0;
}

struct Tier {
  std::string axis;  ///< what is chosen
  std::string name;  ///< how
  Composition composition;
  std::size_t multiple = 1;  ///< steps at once

  /// Whether nothing but rounding tells it from the default.
  bool only_rounds() const { return axis == "default" || axis == "precision" || axis == "batch"; }
};

inline std::string short_name(NormalForm form) {
  switch (form) {
    case NormalForm::linear:
      return "linear";
    case NormalForm::hertz:
      return "smooth";
    case NormalForm::elastic:
      return "elastic";
    case NormalForm::plastic:
      return "loading history";
    case NormalForm::incremental:
      return "incremental";
  }
  return "";
}

inline std::vector<Tier> tiers_of(const Composition& ours) {
  std::vector<Tier> tiers{{"default", "default", ours}};
  const auto add = [&](const char* axis, const std::string& name, auto change, std::size_t multiple = 1) {
    Composition changed = ours;
    change(changed);
    tiers.push_back({axis, name, changed, multiple});
  };
  if (ours.history != History::none) {
    for (const Carrying k : {Carrying::project, Carrying::project_restore, Carrying::rotate})
      if (k != ours.carrying) add("carrying", name(k), [k](Composition& c) { c.carrying = k; });
    for (const History h :
         {History::force, History::force_rescaled, History::displacement, History::displacement_rescaled})
      if (h != ours.history) add("history", name(h), [h](Composition& c) { c.history = h; });
  }
  for (const NormalForm form : stand_ins(ours.normal))
    if (form != ours.normal) add("normal", short_name(form), [form](Composition& c) { c.normal = form; });
  add("precision", "law in float", [](Composition& c) { c.precision = Precision::law_in_float; });
  add("precision", "all in float", [](Composition& c) { c.precision = Precision::in_float; });
  add("batch", "batch", [](Composition& c) { c.path = Path::batch; });
  add("batch", "batch in float", [](Composition& c) {
    c.path = Path::batch;
    c.precision = Precision::in_float;
  });
  for (const std::size_t multiple : {2U, 5U, 10U})
    add(
        "step", std::to_string(multiple) + " dt", [](Composition&) {}, multiple);
  if (ours.damping != Damping::none) add("slot", "no dashpots", [](Composition& c) { c.damping = Damping::none; });
  if (ours.history != History::none) add("slot", "no shear", [](Composition& c) { c.history = History::none; });
  if (ours.bridge) add("slot", "no bridge", [](Composition& c) { c.bridge = false; });
  return tiers;
}

}  // namespace trade

// SPDX-License-Identifier: MIT
// The tiers of a law: what may be chosen about it, one choice changed at a time from how it is offered by default.
#pragma once

#include <string>
#include <vector>

#include "composition.hpp"

namespace trade {

struct Tier {
  std::string axis;  ///< what is chosen
  std::string name;  ///< how
  Composition composition;
  std::size_t multiple = 1;  ///< steps at once
};

inline std::vector<Tier> tiers_of(const Composition& ours) {
  std::vector<Tier> tiers{{"default", "default", ours}};
  const auto add = [&](const char* axis, const std::string& name, auto change, std::size_t multiple = 1) {
    Composition changed = ours;
    change(changed);
    tiers.push_back({axis, name, changed, multiple});
  };
  if (ours.history != History::none) {
    for (const Carrying k : {Carrying::project, Carrying::rotate})
      add("carrying", name(k), [k](Composition& c) { c.carrying = k; });
    for (const History h : {History::force_rescaled, History::displacement, History::displacement_rescaled})
      add("history", name(h), [h](Composition& c) { c.history = h; });
  }
  if (ours.is_rough()) {
    add("power", "fast power", [](Composition& c) { c.normal = NormalForm::plastic_fast; });
    add("normal", "incremental", [](Composition& c) { c.normal = NormalForm::incremental; });
    add("normal", "elastic", [](Composition& c) { c.normal = NormalForm::elastic; });
    add("normal", "smooth", [](Composition& c) { c.normal = NormalForm::hertz; });
  }
  add("precision", "law in float", [](Composition& c) { c.precision = Precision::law_in_float; });
  add("precision", "all in float", [](Composition& c) { c.precision = Precision::in_float; });
  add("batch", "batch", [](Composition& c) { c.path = Path::batch; });
  if (ours.is_rough()) {
    add("batch", "batch, fast power", [](Composition& c) {
      c.path = Path::batch;
      c.normal = NormalForm::plastic_fast;
    });
  }
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

// SPDX-License-Identifier: MIT
// A law, and how it is computed; and what may be simplified about it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "contact_path/law_spec.hpp"

namespace trade {

using common::fail;
using contact_path::Chosen;
using contact_path::KeyTable;
using contact_path::LawSpec;

enum class Precision {
  in_double,
  law_in_float,  ///< geometry in double, the law in float
  in_float       ///< positions, geometry and law in float
};
enum class Loop { scalar, batch };

struct Composition {
  LawSpec law;
  Precision precision = Precision::in_double;
  Loop loop = Loop::scalar;
};

inline const char* name(Precision x) {
  return x == Precision::in_double ? "double" : x == Precision::law_in_float ? "law in float" : "float";
}

/// In one line, slot by slot.
inline std::string describe(const Composition& c) {
  const LawSpec& law = c.law;
  std::string text = law.normal.law;
  if (law.damping.acts()) text += law.damping.word("tension") == "clipped" ? " + clipped dashpots" : " + dashpots";
  if (law.shear.acts()) text += " + shear " + law.shear.law + '/' + law.shear.word("rotation");
  if (law.bridge.acts()) text += " + " + law.bridge.law;
  return text + ", " + name(c.precision);
}

/// @throws InputError for what would need more compositions than this program compiles (runs.hpp)
inline void check_measured(const LawSpec& law) {
  for (const KeyTable& keys : contact_path::slot_tables()[0].laws)
    for (const contact_path::WordKey& key : keys.words)
      if (keys.name == law.normal.law && law.normal.word(key.name) != key.words.front())
        law.normal.refuse(key.name, "= \"" + law.normal.word(key.name) +
                                        "\" is not measured here, only the default, \"" + key.words.front() + '"');
  const auto none = [](const Chosen& chosen, const char* key) {
    if (chosen.has(key)) chosen.refuse(key, "is given, but not measured here");
  };
  none(law.damping, "shear_damping_constant");
  none(law.shear, "static_friction");
  if (law.shear.acts() && law.shear.word("stiffness") == "elastic_ratio")
    law.shear.refuse("stiffness", "= \"elastic_ratio\" is not measured here, only mindlin and constant_ratio");
  if (law.rolling.acts()) law.rolling.refuse("law", "is " + law.rolling.law + ", but rolling is not measured here");
}

/// The same law with another normal law, which takes the numbers that it needs. Mindlin's stiffness becomes the same ratio
/// to the tangent where the other law has no contact radius.
inline LawSpec with_normal(LawSpec law, const KeyTable& keys) {
  law.normal.law = keys.name;
  for (const contact_path::WordKey& key : keys.words) law.normal.words[key.name] = key.words.front();
  if (law.shear.acts() && law.shear.word("stiffness") == "mindlin") law.shear.words["stiffness"] = "default";
  check(law);
  return law;
}

/// The normal laws that may replace the law's own: those before it in normal_laws() whose numbers and properties of the pair
/// it has.
inline std::vector<LawSpec> other_normals(const LawSpec& law) {
  std::vector<LawSpec> others;
  const std::vector<KeyTable> all = contact_path::slot_tables()[0].laws;
  const auto own =
      std::find_if(all.begin(), all.end(), [&law](const KeyTable& keys) { return keys.name == law.normal.law; });
  for (auto other = own; other != all.begin();) {
    --other;
    const bool has_numbers =
        std::all_of(other->numbers.begin(), other->numbers.end(), [&law](const contact_path::NumberKey& key) {
          return key.presence == contact_path::Presence::optional || law.normal.has(key.name);
        });
    const bool reads_as_much = std::all_of(other->reads.begin(), other->reads.end(), [&own](const std::string& name) {
      return std::find(own->reads.begin(), own->reads.end(), name) != own->reads.end();
    });
    if (has_numbers && reads_as_much) others.push_back(with_normal(law, *other));
  }
  return others;
}

/// The other shear histories of a law with shear, and the other ways to rotate them.
inline std::vector<LawSpec> other_histories(const LawSpec& law) {
  std::vector<LawSpec> others;
  for (const KeyTable& history : keys_of(contact_path::shear_laws())) {
    if (!law.shear.acts() || history.name == "none" || history.name == law.shear.law) continue;
    if (history.name == "partial_slip") continue;  // the fullest: the others are simplifications of it
    others.push_back(law);
    others.back().shear.law = history.name;
  }
  return others;
}
inline std::vector<LawSpec> other_rotations(const LawSpec& law) {
  std::vector<LawSpec> others;
  for (const char* rotation : {"project", "project_restore", "rotate"}) {
    if (!law.shear.acts() || law.shear.word("rotation") == rotation) continue;
    others.push_back(law);
    others.back().shear.words["rotation"] = rotation;
  }
  return others;
}
/// The law without one of its slots: bridge, damping or shear.
inline LawSpec without(LawSpec law, Chosen LawSpec::*slot) {
  law.*slot = {(law.*slot).place, (law.*slot).title, "none", {}, {}, {}};
  return law;
}

/// Every composition that may replace `law` where geometry is given in double. The law itself comes first.
inline std::vector<Composition> simplifications(const LawSpec& law) {
  std::vector<LawSpec> laws{law};
  const auto extend = [&laws](const auto& others_of) {
    const std::vector<LawSpec> before = laws;
    for (const LawSpec& one : before)
      for (const LawSpec& other : others_of(one)) laws.push_back(other);
  };
  const auto or_none = [&extend](Chosen LawSpec::*slot) {
    extend([slot](const LawSpec& one) {
      return (one.*slot).acts() ? std::vector<LawSpec>{without(one, slot)} : std::vector<LawSpec>{};
    });
  };
  extend(other_normals);
  extend(other_histories);
  extend(other_rotations);
  or_none(&LawSpec::damping);
  or_none(&LawSpec::bridge);
  // Without shear, histories and rotations are all the same law: once for each of the other slots.
  const std::size_t with_shear = laws.size();
  for (std::size_t i = 0; i < with_shear; ++i)
    if (law.shear.acts() && laws[i].shear.law == law.shear.law && laws[i].shear.words == law.shear.words)
      laws.push_back(without(laws[i], &LawSpec::shear));
  std::vector<Composition> all;
  for (const LawSpec& one : laws)
    for (const Precision precision : {Precision::in_double, Precision::law_in_float}) all.push_back({one, precision});
  return all;
}

}  // namespace trade

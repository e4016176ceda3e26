// SPDX-License-Identifier: MIT
// The variants of a law: what may be chosen about it, one choice changed at a time.
#pragma once

#include <string>
#include <vector>

#include "composition.hpp"

namespace trade {

/// Bound of the difference that rounding makes between a variant's force and the same composition's in 200 bits, as a share
/// of the largest force of each contact's path. Overlaps are differences of positions 0.1 m from the origin: the rounding of
/// these is the error of an overlap of 2e-6 m or more, and a law adds little. A law in float that receives overlaps in double
/// rounds its shear by 6e-8 in each of 240 steps.
inline double rounding_bound(Precision precision) {
  return precision == Precision::in_double ? 1e-11 : precision == Precision::law_in_float ? 2e-5 : 5e-2;
}

struct Variant {
  std::string axis;  ///< what is chosen
  std::string name;  ///< how
  Composition composition;
  std::size_t multiple = 1;  ///< steps at once

  /// Whether it differs from the default by rounding only.
  bool only_rounds() const { return axis == "default" || axis == "precision" || axis == "batch"; }
};

inline std::vector<Variant> variants_of(const LawSpec& law) {
  std::vector<Variant> variants{{"default", "default", {law}}};
  for (const LawSpec& other : other_rotations(law))
    variants.push_back({"rotation", other.shear.word("rotation"), {other}});
  for (const LawSpec& other : other_histories(law)) variants.push_back({"history", other.shear.law, {other}});
  for (const LawSpec& other : other_normals(law)) variants.push_back({"normal", other.normal.law, {other}});
  variants.push_back({"precision", "law in float", {law, Precision::law_in_float}});
  variants.push_back({"precision", "all in float", {law, Precision::in_float}});
  variants.push_back({"batch", "batch", {law, Precision::in_double, Loop::batch}});
  variants.push_back({"batch", "batch in float", {law, Precision::in_float, Loop::batch}});
  for (const std::size_t multiple : {2U, 5U, 10U})
    variants.push_back({"step", std::to_string(multiple) + " dt", {law}, multiple});
  if (law.damping.acts()) variants.push_back({"slot", "no dashpots", {without(law, &LawSpec::damping)}});
  if (law.shear.acts()) variants.push_back({"slot", "no shear", {without(law, &LawSpec::shear)}});
  if (law.bridge.acts()) variants.push_back({"slot", "no bridge", {without(law, &LawSpec::bridge)}});
  return variants;
}

}  // namespace trade

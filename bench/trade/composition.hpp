// SPDX-License-Identifier: MIT
// A composition: what a user may choose for a contact law, and what this program may simplify.
#pragma once

#include <string>
#include <vector>

#include "contactlaws/laws.hpp"

namespace trade {

enum class NormalForm { linear, hertz, elastic, plastic, incremental };
enum class Damping { none, allowed, clipped };
enum class History { none, force, force_rescaled, displacement, displacement_rescaled };
enum class Carrying { project, project_restore, rotate };
enum class Precision {
  in_double,
  law_in_float,  ///< geometry in double, the law in float
  in_float       ///< positions, geometry and law in float
};
enum class Path { scalar, batch };

struct Composition {
  NormalForm normal = NormalForm::hertz;
  Damping damping = Damping::none;
  History history = History::none;
  Carrying carrying = Carrying::project_restore;
  bool bridge = false;
  Precision precision = Precision::in_double;
  Path path = Path::scalar;

  bool is_rough() const { return normal != NormalForm::linear && normal != NormalForm::hertz; }
};

inline const char* name(NormalForm x) {
  switch (x) {
    case NormalForm::linear:
      return "linear";
    case NormalForm::hertz:
      return "hertz";
    case NormalForm::elastic:
      return "pohrt_popov";
    case NormalForm::plastic:
      return "pohrt_popov_elasto_plastic";
    case NormalForm::incremental:
      return "pohrt_popov_incremental";
  }
  return "";
}
inline const char* name(History x) {
  switch (x) {
    case History::none:
      return "none";
    case History::force:
      return "force";
    case History::force_rescaled:
      return "force_rescaled";
    case History::displacement:
      return "displacement";
    case History::displacement_rescaled:
      return "displacement_rescaled";
  }
  return "";
}
inline const char* name(Carrying x) {
  return x == Carrying::project ? "project" : x == Carrying::rotate ? "rotate" : "project_restore";
}
inline const char* name(Precision x) {
  switch (x) {
    case Precision::in_double:
      return "double";
    case Precision::law_in_float:
      return "law in float";
    case Precision::in_float:
      return "float";
  }
  return "";
}

/// In one line, slot by slot.
inline std::string describe(const Composition& c) {
  std::string text = name(c.normal);
  if (c.damping != Damping::none) text += c.damping == Damping::clipped ? " + clipped dashpots" : " + dashpots";
  if (c.history != History::none) text += std::string(" + shear ") + name(c.history) + '/' + name(c.carrying);
  if (c.bridge) text += " + suction";
  return text + ", " + name(c.precision);
}

/// Numbers of a law, for whichever of its slots a composition has.
struct Parameters {
  contactlaws::PairProperties<double> pair;
  double normal_stiffness = 0.0;                 ///< of the linear law, for this pair [N/m]
  contactlaws::PohrtPopov<double> surface = {};  ///< of the rough laws
  double seed_force = 1e-6;                      ///< of the incremental form [N]
  double damping_constant = 0.0;                 ///< [1]
  double friction = 0.0;                         ///< [1]
  double ratio = 1.0;                            ///< shear stiffness over normal tangent [1]
  contactlaws::SuctionBridge<double> bridge = {};
  bool starts_wet = false;
};

}  // namespace trade

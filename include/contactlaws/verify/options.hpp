// SPDX-License-Identifier: MIT
// Sizes from which the paths are made, and what the law claims. A property that is not claimed is not checked.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include "contactlaws/core/validate.hpp"

namespace contactlaws::verify {

/// What a law claims beyond what every law must satisfy. Left out: reported as "not claimed".
struct Claims {
  std::optional<double> friction;         ///< mu: shear is at most mu times the friction load, and reaches it [1]
  std::optional<double> static_friction;  ///< mu of the first slip, where it is larger than the kinetic `friction` [1]
  std::optional<double> restitution;      ///< of a head-on impact, at any speed [1]
  std::optional<double> range;            ///< gap beyond which nothing acts and shear is reset, 0 without adhesion [m]
  double adhesion = 0.0;                  ///< pull of the surfaces, which friction multiplies beside the force [N]
  bool no_tension = false;                ///< the normal force never pulls
  bool continuous_at_touch = false;       ///< a contact at rest starts without a jump
  bool continuous_in_motion = false;      ///< so does one that closes or slides: its dashpots start from zero
  bool passive = false;                   ///< no closed loop of overlap, slip and rolling yields energy
  bool passive_impacts = true;            ///< no impact of two spheres yields energy; true of every law of a solid
  bool no_ratcheting = false;             ///< repeated closed cycles end at the same force
  bool follows_twist = false;             ///< the shear turns with the pair's common spin about the normal
  bool couple_turns = false;              ///< a rolling couple turns with the pair, as every shear force must
};

struct Options {
  double radius1 = 0.0;           ///< [m]
  double radius2 = 0.0;           ///< [m]
  double mass1 = 0.0;             ///< [kg]
  double mass2 = 0.0;             ///< [kg]
  double overlap = 0.0;           ///< the largest usual one [m]; speeds and time steps follow from the force there
  Claims claims;                  ///< what the law promises
  int paths = 100;                ///< random paths for each property
  std::uint64_t seed = 20190501;  ///< of the random paths
  double epsilon = std::numeric_limits<double>::epsilon();  ///< of the numbers the law computes in; float's is 2^-23
  std::string folder;  ///< an existing one, for the reduced paths of failures; empty: they are not written

  static constexpr const char* name = "verify::Options";
};

/// The same options. @throws std::invalid_argument naming the first that is out of range, its value and the range
inline const Options& checked_options(const Options& o) {
  const auto require = [](const Range& range, double value, const char* what, const char* unit) {
    require_in(range, value, Options::name, what, unit);
  };
  require(Range::positive(), o.radius1, "radius1", "m");
  require(Range::positive(), o.radius2, "radius2", "m");
  require(Range::positive(), o.mass1, "mass1", "kg");
  require(Range::positive(), o.mass2, "mass2", "kg");
  require({0.0, minimum<double>(o.radius1, o.radius2), false, false}, o.overlap, "overlap", "m");
  require({1.0, Range::unbounded, true, true}, o.paths, "paths", "1");
  require({0.0, 1e-3, false, true}, o.epsilon, "epsilon", "1");
  const Claims& c = o.claims;
  const double friction = c.friction.value_or(0.0);
  require(Range::not_negative(), friction, "claims.friction", "1");
  require({friction, Range::unbounded, true, true}, c.static_friction.value_or(friction), "claims.static_friction",
          "1");
  require(Range::closed(0.0, 1.0), c.restitution.value_or(0.0), "claims.restitution", "1");
  require(Range::not_negative(), c.range.value_or(0.0), "claims.range", "m");
  require(Range::not_negative(), c.adhesion, "claims.adhesion", "N");
  if (c.static_friction && !c.friction)
    reject("verify::Options: claims.static_friction needs claims.friction, the kinetic coefficient");
  if (!o.folder.empty() && !std::filesystem::is_directory(o.folder))
    reject("verify::Options: folder is '" + o.folder + "', must be an existing folder");
  return o;
}

}  // namespace contactlaws::verify

// SPDX-License-Identifier: MIT
// What a check is told: sizes to make paths of, and what the law promises. What it does not promise is not asked of it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "contactlaws/core/validate.hpp"

namespace contactlaws::verify {

/// What a law promises beyond what every law must keep. Left out: reported as "not claimed".
struct Claims {
  std::optional<double> friction;     ///< mu: shear is at most mu times the pressing force, and reaches it [1]
  std::optional<double> restitution;  ///< of a head-on impact, at any speed [1]
  std::optional<double> range;        ///< gap beyond which nothing acts and shear is forgotten, 0 without a bridge [m]
  bool no_tension = false;            ///< the normal force never pulls
  bool continuous_at_touch = false;   ///< a contact at rest starts without a jump
  bool continuous_in_motion = false;  ///< and one that closes or slides, too: its dashpots start from nothing
  bool passive = false;               ///< no closed loop of overlap and slip yields energy
  bool passive_impacts = false;       ///< no impact of two spheres does, under any angle
  bool no_ratcheting = false;         ///< repeated closed cycles leave the force where it was
  bool follows_twist = false;         ///< the shear turns with the pair's common spin about the normal
};

struct Options {
  double radius1 = 0.0;  ///< [m]
  double radius2 = 0.0;  ///< [m]
  double mass1 = 0.0;    ///< [kg]
  double mass2 = 0.0;    ///< [kg]
  double overlap = 0.0;  ///< the largest that is usual [m]; speeds and steps follow from the force that it takes
  Claims claims;
  int paths = 100;                                          ///< random paths that each property is tried on
  std::uint64_t seed = 20190501;                            ///< of the random paths
  double epsilon = std::numeric_limits<double>::epsilon();  ///< of the numbers the law computes in; float's is 2^-23
  std::string folder;  ///< that exists: where the reduced paths are written; empty: nowhere

  static constexpr const char* name = "verify::Options";
};

/// The same options. @throws std::invalid_argument naming what is out of range
inline const Options& checked_options(const Options& options) {
  const auto require = [](double value, const char* what, const char* unit) {
    require_in(Range::positive(), value, Options::name, what, unit);
  };
  require(options.radius1, "radius1", "m");
  require(options.radius2, "radius2", "m");
  require(options.mass1, "mass1", "kg");
  require(options.mass2, "mass2", "kg");
  require(options.overlap, "overlap", "m");
  require(options.paths, "paths", "1");
  require(options.epsilon, "epsilon", "1");
  return options;
}

}  // namespace contactlaws::verify

// SPDX-License-Identifier: MIT
// Which features of a law a recorded motion uses, in sentences.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "composition.hpp"
#include "contact_path/any_law.hpp"
#include "reference.hpp"

namespace trade {

struct Use {
  double largest_force = 0.0;      ///< [N]
  double nearest_gap = 1e300;      ///< of contacts that do not touch [m]
  double strongest_pull = 0.0;     ///< of a bridge [N]
  double strongest_damping = 0.0;  ///< of a normal dashpot [N]
  double strongest_shear = 0.0;    ///< [N]
  double largest_turn = 0.0;       ///< of a normal from where its contact first touched [rad]
  std::size_t touching = 0;        ///< rows
  std::size_t sliding = 0;         ///< rows
  bool unloads = false;            ///< whether a touching contact ever separates
};

inline Use use_of(const Trajectories& trajectories, const Reference& reference) {
  Use use;
  std::vector<Vec3<double>> first(trajectories.contacts(), Vec3<double>::Zero());
  std::vector<double> deepest(trajectories.contacts(), 0.0);
  for (std::size_t step = 0; step < trajectories.steps(); ++step) {
    for (std::size_t c = 0; c < trajectories.contacts_at(step); ++c) {
      const std::size_t row = trajectories.offset[step] + c;
      const ContactKinematics<double>& motion = trajectories.in_double[row];
      const ReferenceRow& right = reference.rows[row];
      const Vec3<double> force = right.force.cast<double>();
      use.largest_force = std::max(use.largest_force, force.norm());
      use.strongest_pull = std::max(use.strongest_pull, right.bridge_force);
      if (!(motion.overlap > 0.0)) {
        use.nearest_gap = std::min(use.nearest_gap, -motion.overlap);
        first[c].setZero();
        continue;
      }
      ++use.touching;
      if (right.sliding) ++use.sliding;
      if (motion.overlap < deepest[c]) use.unloads = true;
      deepest[c] = std::max(deepest[c], motion.overlap);
      use.strongest_damping = std::max(use.strongest_damping, std::abs(right.normal_force - right.normal_elastic));
      use.strongest_shear = std::max(use.strongest_shear, (force - motion.normal * force.dot(motion.normal)).norm());
      if (first[c].isZero(0.0)) first[c] = motion.normal;
      use.largest_turn =
          std::max(use.largest_turn, std::atan2(first[c].cross(motion.normal).norm(), first[c].dot(motion.normal)));
    }
  }
  return use;
}

namespace detail {
inline std::string number(double x, const char* format = "%.3g") {
  char text[40];
  std::snprintf(text, sizeof text, format, x);
  return text;
}
inline std::string share(double part, double whole) {
  return number(whole > 0.0 ? 100.0 * part / whole : 0.0) + " % of the largest force";
}
}  // namespace detail

struct Findings {
  std::vector<std::string> unused;
  std::vector<std::string> used;
};

/// What is at most `tolerance` of the largest force counts as unused.
inline Findings findings(const Use& use, const LawSpec& law, double tolerance) {
  using detail::number;
  using detail::share;
  Findings found;
  const double little = tolerance * use.largest_force;
  const auto sort = [&found](bool used, const std::string& sentence) {
    (used ? found.used : found.unused).push_back(sentence);
  };
  const auto pair = contact_path::build_pair<double>(law);
  if (law.bridge.acts()) {
    const double range = contact_path::build_law<double>(law, pair)->interaction_range(pair);
    const std::string in_mm = number(range * 1e3) + " mm";
    const bool near = use.touching > 0 || use.nearest_gap < range;
    if (!law.bridge.is("wet")) {
      sort(false, "bridge: no contact is wet ([bridge] wet = true would make all wet)");
    } else if (!near) {
      sort(false, "bridge: no contact came within the bridge's range (" + in_mm + ")");
    } else {
      sort(use.strongest_pull > little, "bridge: no pull above " + number(use.strongest_pull) + " N, " +
                                            share(use.strongest_pull, use.largest_force));
    }
  }
  if (law.shear.acts()) {
    if (use.sliding == 0) {
      sort(false, "friction limit: no contact slid");
    } else {
      sort(true, "friction limit: contacts slid in " + number(100.0 * double(use.sliding) / double(use.touching)) +
                     " % of the rows that touch");
    }
    sort(use.strongest_shear > little, "shear: no shear force above " + number(use.strongest_shear) + " N, " +
                                           share(use.strongest_shear, use.largest_force));
    sort(use.largest_turn > 0.0 && use.strongest_shear > little,
         "rotation: no contact turned by more than " + number(use.largest_turn * 180.0 / 3.14159265358979323846) +
             " degrees while it touched");
  }
  if (law.damping.acts())
    sort(use.strongest_damping > little, "dashpots: no damping above " + number(use.strongest_damping) + " N, " +
                                             share(use.strongest_damping, use.largest_force));
  const bool has_history = with_law(contact_path::normal_laws(), contact_path::Given<double>{law.normal, pair, law},
                                    [](const auto& normal) { return !normal.state_values().empty(); });
  if (has_history)
    sort(use.unloads, use.unloads ? "loading history: contacts unloaded" : "loading history: no contact unloaded");
  return found;
}

}  // namespace trade

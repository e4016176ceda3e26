// SPDX-License-Identifier: MIT
// The reference: a law on the same motion, in numbers of 200 bits.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "contact_path/law_spec.hpp"
#include "trajectories.hpp"

namespace trade {

/// The result of one step of one contact, rounded.
struct ReferenceRow {
  Vec3<long double> force;  ///< on body 2 [N]
  double normal_elastic;    ///< force of the normal law, compression > 0 [N]
  double normal_force;      ///< normal law and dashpot [N]
  double bridge_force;      ///< the bridge's pull [N]
  bool sliding;
};

struct Reference {
  std::vector<ReferenceRow> rows;
  std::vector<double> dissipated;    ///< per contact, at the end of its motion [J]
  std::vector<double> energy_scale;  ///< per contact, the largest work done on it at any time [J]
};

/// Calls progress(share of the rows that is done). @throws InputError if the bodies do not make a pair
Reference solve(
    const contact_path::LawSpec& law, const Trajectories& trajectories,
    const std::function<void(double)>& progress = [](double) {});

}  // namespace trade

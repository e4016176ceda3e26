// SPDX-License-Identifier: MIT
// What is right: the fullest model of a law, on the same motion, in numbers of 200 bits.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "../../examples/contact_path/law_description.hpp"
#include "scene.hpp"

namespace trade {

/// One row of the answer, rounded at last.
struct Truth {
  Vec3<long double> force;  ///< on body 2 [N]
  double normal_elastic;    ///< normal spring's part, compression > 0 [N]
  double normal_force;      ///< normal spring and dashpot [N]
  double bridge_force;      ///< the bridge's pull [N]
  bool sliding;
};

struct Reference {
  std::vector<Truth> rows;
  std::vector<double> dissipated;    ///< per contact, at the end of its motion [J]
  std::vector<double> energy_scale;  ///< per contact, the largest work done on it at any time [J]
};

/// `progress` is told the share of the rows that is done. @throws contact_path::InputError if the law does not hold together
Reference solve(
    const contact_path::LawDescription& law, const Scene& scene,
    const std::function<void(double)>& progress = [](double) {});

}  // namespace trade

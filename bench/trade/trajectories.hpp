// SPDX-License-Identifier: MIT
// The imposed motion of many contacts, through which every composition of a law is driven.
//
// Rows are ordered by step, as a DEM code computes them: all contacts of the first step, then all of the second. Contacts may
// end early. They are sorted by length, the longest first, so that row = offset[step] + contact.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contactlaws/kinematics.hpp"
#include "contactlaws/scalars/multiprecision.hpp"

namespace trade {

using contactlaws::Binary200;
using contactlaws::ContactKinematics;
using contactlaws::Vec3;

struct Trajectories {
  std::string name;
  std::vector<std::size_t> offset{0};                ///< first row of each step, and one past the last row
  std::vector<ContactKinematics<double>> in_double;  ///< one per row
  std::vector<ContactKinematics<float>> in_float;    ///< from bodies kept in float; empty where bodies are unknown
  std::vector<ContactKinematics<Binary200>> exact;   ///< from the same bodies as in_double, or from its numbers
  std::size_t cycle_start = 0;  ///< from this step to the end the motion is a closed cycle; 0: it has none
  std::size_t multiple = 1;     ///< steps of the full motion in one step here

  std::size_t steps() const { return offset.size() - 1; }
  std::size_t contacts() const { return steps() > 0 ? offset[1] : 0; }
  std::size_t contacts_at(std::size_t step) const { return offset[step + 1] - offset[step]; }
  std::size_t rows() const { return offset.back(); }
};

}  // namespace trade

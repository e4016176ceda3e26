// SPDX-License-Identifier: MIT
// Derivatives: any kernel on Eigen::AutoDiffScalar<Vector>, with the vector's size fixed at compile time.
#pragma once

#include <unsupported/Eigen/AutoDiff>

#include "contactlaws/scalar.hpp"

namespace contactlaws {
template <class Derivatives>
struct ScalarTraits<Eigen::AutoDiffScalar<Derivatives>> {
  using Number = Eigen::AutoDiffScalar<Derivatives>;
  using Mask = bool;
  using Lane = typename Derivatives::Scalar;

  static Number select(bool condition, const Number& yes, const Number& no) noexcept { return condition ? yes : no; }
  static bool any(bool condition) noexcept { return condition; }
};
}  // namespace contactlaws

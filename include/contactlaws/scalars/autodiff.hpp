// SPDX-License-Identifier: MIT
// Derivatives: any kernel on Eigen::AutoDiffScalar<Vector>, with the vector's size fixed at compile time.
#pragma once

#include <Eigen/Core>
#include <unsupported/Eigen/AutoDiff>

#include "contactlaws/core/scalar.hpp"
#include "contactlaws/core/sixth_root.hpp"

namespace Eigen {
/// base^exponent, both of them with derivatives (Eigen offers a constant exponent alone).
template <class Derivatives>
AutoDiffScalar<Derivatives> pow(const AutoDiffScalar<Derivatives>& base, const AutoDiffScalar<Derivatives>& exponent) {
  using std::log;
  using std::pow;
  const auto value = pow(base.value(), exponent.value());
  return {value, value * (exponent.derivatives() * log(base.value()) +
                          base.derivatives() * (exponent.value() / base.value()))};
}
}  // namespace Eigen

namespace contactlaws {
template <class Derivatives>
struct ScalarTraits<Eigen::AutoDiffScalar<Derivatives>> {
  using Number = Eigen::AutoDiffScalar<Derivatives>;
  using Mask = bool;
  using Lane = typename Derivatives::Scalar;
  static constexpr std::size_t lanes = 1;

  static Number select(bool condition, const Number& yes, const Number& no) noexcept { return condition ? yes : no; }
  static bool any(bool condition) noexcept { return condition; }
};

template <class Derivatives>
struct SixthRootOf<Eigen::AutoDiffScalar<Derivatives>> {
  using Number = Eigen::AutoDiffScalar<Derivatives>;
  using Value = typename Derivatives::Scalar;

  /// At 0 the derivatives of the roots are infinite; a constant 0 has none.
  static SixthRoot<Number> of(const Number& x) noexcept {
    const SixthRoot<Value> root = sixth_root<Value>(x.value());
    const auto with = [&x](const Value& value, const Value& exponent) {
      const Derivatives slopes = x.derivatives() * (exponent * value / x.value());
      return Number(value, (x.derivatives().array() == Value(0)).select(Value(0), slopes));
    };
    return {with(root.sixth, Value(1) / Value(6)), with(root.third, Value(1) / Value(3))};
  }
};
}  // namespace contactlaws

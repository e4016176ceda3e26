// SPDX-License-Identifier: MIT
// Limits the length of a vector, keeping its direction: friction, rolling resistance.
#pragma once

#include "contactlaws/core/scalar.hpp"

namespace contactlaws::detail {

/// Whether |v| <= limit, decided by squares. False also where the square of the limit overflows or underflows.
template <class T>
CONTACTLAWS_HD Mask<T> surely_within(const Vec3<T>& v, const T& limit) noexcept {
  const T square = limit * limit;
  return square_is_exact<T>(square) && dot<T>(v, v) <= square;
}

/// The factor that scales a vector longer than `limit` to the length `limited`.
template <class T>
struct LengthLimit {
  T factor;  ///< 1 where the vector is not longer
  Mask<T> exceeded;
  T excess;  ///< how much shorter the vector becomes, 0 where it is not longer
};
template <class T>
CONTACTLAWS_HD LengthLimit<T> length_limit(const Vec3<T>& v, const T& limit, const T& limited) noexcept {
  const T length = norm<T>(v);
  const Mask<T> within = length <= limit;  // not where one is NaN
  const T divisor = select<T>(length > T(0), length, T(1));
  return {select<T>(within, T(1), T(limited / divisor)), negate<T>(within),
          select<T>(within, T(0), T(length - limited))};
}

}  // namespace contactlaws::detail

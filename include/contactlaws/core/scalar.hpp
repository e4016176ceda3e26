// SPDX-License-Identifier: MIT
// What a scalar must offer, so that one kernel text serves one contact or a pack of contacts, at any precision:
//
//   + - * /   < <= > >=   && || ! of what these yield   sqrt abs, and exp pow sin cos where a law uses them,
//   found by argument-dependent lookup or, for the built-in types, in std (so kernels write `using std::sqrt; sqrt(x)`).
//
// A type whose comparisons yield a bool needs nothing more. Packs specialise ScalarTraits (scalars/xsimd.hpp).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "contactlaws/core/config.hpp"
#include "contactlaws/core/vector.hpp"

namespace contactlaws {

/// T, but not deduced from the argument: sphere(granite, 5) takes an integer radius.
template <class T>
struct NonDeducedType {
  using type = T;
};
/// T, from which a template argument is not deduced.
template <class T>
using NonDeduced = typename NonDeducedType<T>::type;

/// The operations that differ between a number and a pack of numbers.
template <class T>
struct ScalarTraits {
  using Mask = bool;  ///< what a comparison of two T yields
  using Lane = T;     ///< one number of a pack
  static constexpr std::size_t lanes = 1;

  CONTACTLAWS_HD static T select(bool condition, const T& yes, const T& no) noexcept { return condition ? yes : no; }
  CONTACTLAWS_HD static bool any(bool condition) noexcept { return condition; }
  CONTACTLAWS_HD static T load(const T* values) noexcept { return *values; }
  CONTACTLAWS_HD static void store(T* values, const T& x) noexcept { *values = x; }
};

/// What a comparison of two T yields.
template <class T>
using Mask = typename ScalarTraits<T>::Mask;

/// A number as a T: rounded to the precision of T, in every lane of a pack.
template <class T, class U>
CONTACTLAWS_HD T scalar_cast(const U& x) noexcept {
  return T(static_cast<typename ScalarTraits<T>::Lane>(x));
}

/// Lane by lane: `yes` where `condition` holds, `no` elsewhere. Both are evaluated, so both must be harmless.
template <class T>
CONTACTLAWS_HD T select(const Mask<T>& condition, const T& yes, const T& no) noexcept {
  return ScalarTraits<T>::select(condition, yes, no);
}

/// Whether `condition` holds in at least one lane: what a shortcut may branch on.
template <class T>
CONTACTLAWS_HD bool any(const Mask<T>& condition) noexcept {
  return ScalarTraits<T>::any(condition);
}

/// Whether `condition` holds in every lane.
template <class T>
CONTACTLAWS_HD bool all(const Mask<T>& condition) noexcept {
  if constexpr (std::is_same_v<Mask<T>, bool>) {
    return condition;
  } else {
    return ScalarTraits<T>::all(condition);
  }
}

/// Lane by lane: whether `condition` does not hold.
template <class T>
CONTACTLAWS_HD Mask<T> negate(const Mask<T>& condition) noexcept {
  if constexpr (std::is_same_v<Mask<T>, bool>) {
    return !condition;
  } else {
    return ScalarTraits<T>::negate(condition);
  }
}

/// max(x, 0). A NaN stays a NaN, and -0 stays -0.
template <class T>
CONTACTLAWS_HD T positive_part(const T& x) noexcept {
  return select<T>(x < T(0), T(0), x);
}

/// min(a, b) and max(a, b), named in full: Eigen's own min and max would be found by argument-dependent lookup.
template <class T>
CONTACTLAWS_HD T minimum(const T& a, const T& b) noexcept {
  return select<T>(b < a, b, a);
}
/// max(a, b), see minimum().
template <class T>
CONTACTLAWS_HD T maximum(const T& a, const T& b) noexcept {
  return select<T>(a < b, b, a);
}

/// Two square roots for the price of one where the hardware has pairs.
template <class T>
CONTACTLAWS_HD std::array<T, 2> sqrt_pair(const T& a, const T& b) noexcept {
#if !defined(CONTACTLAWS_NO_EIGEN)
  if constexpr (std::is_floating_point_v<T>) {
    const Eigen::Array<T, 2, 1> roots = Eigen::Array<T, 2, 1>(a, b).sqrt();
    return {roots[0], roots[1]};
  }
#endif
  using std::sqrt;
  return {sqrt(a), sqrt(b)};
}

/// a . b, summed from x to z for every T. Eigen's order depends on the type; a fixed one gives packs the scalar's bits.
template <class T>
CONTACTLAWS_HD T dot(const Vec3<T>& a, const Vec3<T>& b) noexcept {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

/// sqrt(x), and 0 where x <= 0: there, unlike a square root, it has a derivative.
template <class T>
CONTACTLAWS_HD T sqrt_of_positive(const T& x) noexcept {
  using std::sqrt;
  const Mask<T> none = x <= T(0);  // not where it is NaN
  return select<T>(none, T(0), T(sqrt(select<T>(none, T(1), x))));
}

/// sqrt(a b) of a > 0, b >= 0, also where their product would underflow.
template <class T>
CONTACTLAWS_HD T sqrt_of_product(const T& a, const T& b) noexcept {
  using std::sqrt;
  const T product = a * b;
  const T root = sqrt(product);
  const Mask<T> lost = product < T(std::numeric_limits<typename ScalarTraits<T>::Lane>::min()) && b > T(0);
  if (!any<T>(lost)) return root;
  return select<T>(lost, T(sqrt(a)) * T(sqrt(b)), root);
}

/// The remainder a - q b of the rounded quotient q = a/b, exact where nothing underflows: the product q b is the exact sum
/// of the products of halves (Veltkamp 1968, Dekker 1971). With -ffast-math compilers simplify it to zero.
template <class T>
CONTACTLAWS_HD T quotient_error(const T& a, const T& b, const T& q) noexcept {
  using Lane = typename ScalarTraits<T>::Lane;
  constexpr int half = (std::numeric_limits<Lane>::digits + 1) / 2;
  if constexpr (half > 32) {
    return a - q * b;  // types beyond 64 bits: splitting is not exact; the plain remainder is accurate enough
  } else {
    const T splitter = T(Lane((1ULL << half) + 1));
    const T b_scaled = splitter * b, q_scaled = splitter * q;
    const T b_high = b_scaled - (b_scaled - b), q_high = q_scaled - (q_scaled - q);
    const T b_low = b - b_high, q_low = q - q_high;
    return ((a - q_high * b_high) - q_high * b_low - q_low * b_high) - q_low * b_low;
  }
}

/// Whether a sum of squares is accurate: it neither overflows nor comes near underflow.
template <class T>
CONTACTLAWS_HD Mask<T> square_is_exact(const T& square) noexcept {
  using Lane = typename ScalarTraits<T>::Lane;
  using Limits = std::numeric_limits<Lane>;
  return square >= T(Lane(Limits::min() / Limits::epsilon())) && square <= T(Limits::max());
}

/// |v| for every magnitude of T: scaled by the largest component where the squares would overflow or underflow.
template <class T>
CONTACTLAWS_HD T norm(const Vec3<T>& v) noexcept {
  using std::abs;
  using std::sqrt;
  const T square = dot<T>(v, v);
  const Mask<T> exact = square_is_exact<T>(square);
  if (all<T>(exact)) return sqrt(square);
  const T x = abs(v.x()), y = abs(v.y()), z = abs(v.z());
  const T largest = maximum<T>(maximum<T>(x, y), z);
  if (all<T>(exact || largest <= T(0))) return sqrt(square);  // packs often have a zero, of an open contact
  const T divisor = select<T>(largest > T(0), largest, T(1));
  const Vec3<T> scaled(v.x() / divisor, v.y() / divisor, v.z() / divisor);
  const T scaled_square = dot<T>(scaled, scaled);
  return select<T>(exact, sqrt(square), largest * sqrt(scaled_square));
}

/// pi to every digit of T.
template <class T>
CONTACTLAWS_HD T pi() noexcept {
  if constexpr (std::numeric_limits<typename ScalarTraits<T>::Lane>::digits <=
                std::numeric_limits<long double>::digits) {
    return scalar_cast<T>(3.14159265358979323846264338327950288L);
  } else {
    using std::acos;
    return acos(T(-1));
  }
}

}  // namespace contactlaws

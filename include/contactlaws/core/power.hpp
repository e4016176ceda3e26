// SPDX-License-Identifier: MIT
// Powers of a fraction, (a/b)^y with 0 < a <= b and 0 <= y <= 3:
//
//   one number  pow(x, y) (1 + y r/a)   x = a/b, r = a - x b is the rounding error of x       <= 2 ULP
//   a pack      2^n Q(f)                y log2 x = n + f                                      <= (3 + 4 |y log x|) eps
//
// A pack's power has no table, call or branch, so that its values stay in registers:
//
//   x = m 2^e,  m in [sqrt(1/2), sqrt(2))       log2 x = e + log2 m,   log2 m = s P(s^2),  s = (m - 1)/(m + 1)
//
// P and Q interpolate at Chebyshev's points, to 4e-16 (double) and 3e-9 (float) of their values (tests/reference/power.py).
// Below the smallest normal number a pack's power is that one. Errors: tests/core/test_power.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

/// The binary digits of a pack. A specialisation makes powers of packs stay in registers (scalars/xsimd.hpp).
template <class T>
struct BinaryDigits {
  static constexpr bool known = false;
};

namespace detail {

/// c_0 + c_1 x + c_2 x^2 + ..., neighbours first (Estrin): a chain as short as the logarithm of the count.
template <class T, std::size_t count>
CONTACTLAWS_HD T polynomial(const std::array<T, count>& c, const T& x) noexcept {
  if constexpr (count == 1) {
    return c[0];
  } else {
    std::array<T, (count + 1) / 2> pairs;
    for (std::size_t i = 0; i < count / 2; ++i) pairs[i] = c[2 * i] + c[2 * i + 1] * x;
    if constexpr (count % 2 == 1) pairs[count / 2] = c[count - 1];
    return polynomial(pairs, T(x * x));
  }
}

/// P and Q, with as many terms as the precision needs.
template <class Lane>
struct PowerCoefficients;
template <>
struct PowerCoefficients<double> {
  template <class T>
  CONTACTLAWS_HD static std::array<T, 7> logarithm() noexcept {
    return {T(2.885390081777927),   T(0.9617966939243345), T(0.5770780172463286), T(0.4121984020482752),
            T(0.32061638813224547), T(0.2614442493522915), T(0.2429160853987535)};
  }
  template <class T>
  CONTACTLAWS_HD static std::array<T, 11> exponential() noexcept {
    return {T(1.0),
            T(0.69314718055995),
            T(0.24022650695910097),
            T(0.05550410866444772),
            T(0.009618129107606888),
            T(0.0013333558230164974),
            T(0.0001540353044173605),
            T(1.5252657260200837e-05),
            T(1.321544258792169e-06),
            T(1.0208690299958306e-07),
            T(7.072585949269223e-09)};
  }
};
template <>
struct PowerCoefficients<float> {
  template <class T>
  CONTACTLAWS_HD static std::array<T, 4> logarithm() noexcept {
    return {T(2.8853900798033365F), T(0.96179883880211F), T(0.5767151860190234F), T(0.43171769745887384F)};
  }
  template <class T>
  CONTACTLAWS_HD static std::array<T, 7> exponential() noexcept {
    return {T(1.0F),
            T(0.6931472067028326F),
            T(0.24022650922288757F),
            T(0.05550327226670302F),
            T(0.009618056678524637F),
            T(0.0013400428177615838F),
            T(0.0001546144469856913F)};
  }
};

/// x^y of x in (0, 1] and y in [0, 3], of a pack.
template <class T>
CONTACTLAWS_HD T power_in_registers(const T& x, const T& y) noexcept {
  using Digits = BinaryDigits<T>;
  using Bits = typename Digits::Bits;
  using Lane = typename ScalarTraits<T>::Lane;
  using Limits = std::numeric_limits<Lane>;
  constexpr int mantissa = Limits::digits - 1;
  const T bias = T(Lane(Limits::max_exponent - 1));
  const T whole = T(Lane(1ULL << mantissa)) + bias;  // a number whose last digits are a biased exponent
  const Bits one = Digits::bits(T(1));

  // Raised from sqrt(1/2) to 1, the mantissa carries into the exponent where m would reach sqrt(2).
  const Bits exponent = (Digits::bits(x) + (one - Digits::bits(T(Lane(0.70710678118654752))))) >> mantissa;
  const T e = Digits::number(exponent + Digits::bits(T(whole - bias))) - whole;
  const T m = Digits::number(Digits::bits(x) - (exponent << mantissa) + one);
  const T s = (m - T(1)) / (m + T(1));
  const T log2_m = s * polynomial(PowerCoefficients<Lane>::template logarithm<T>(), T(s * s));

  const T z = maximum<T>(y * (e + log2_m), T(Lane(Limits::min_exponent - 1)));
  const T n = Digits::nearest(z);
  const T two_to_n = Digits::number(Digits::bits(T(n + whole)) << mantissa);
  return two_to_n * polynomial(PowerCoefficients<Lane>::template exponential<T>(), T(z - n));
}

}  // namespace detail

/// (a/b)^y of 0 < a <= b and 0 <= y <= 3.
template <class T>
CONTACTLAWS_HD T power_of_quotient(const T& a, const T& b, const T& y) noexcept {
  using std::pow;
  if constexpr (BinaryDigits<T>::known) {
    return detail::power_in_registers<T>(T(a / b), y);
  } else {
    const T x = a / b;
    const T lost = y * T(quotient_error<T>(a, b, x) / a);
    const T of_rounded = pow(x, y);
    return of_rounded + of_rounded * lost;
  }
}

}  // namespace contactlaws

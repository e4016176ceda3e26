// SPDX-License-Identifier: MIT
// The cube root of x >= 0, of the same operations for one number and for a pack, so that both have equal bits:
//
//   i_0  from the bits of x: those of x^(-1/3) are close to a constant less a third of them                10 % in i^3
//   e = 1 - x i^3       i = i_0 (1 + e/3 + 2/9 e^2 + 14/81 e^3)                                            5e-5 in i^3
//   c = x i^2           x^(1/3) = c (1 - e)^(-2/3) = c (1 + 2/3 e + 5/9 e^2 + 40/81 e^3)                   rounding alone
//
// No table, call, branch or division. Error: <= 2 ULP (tests/core/test_cube_root.cpp). Domain: normal numbers and 0. Types
// beyond 64 bits take the cbrt() of their namespace, and std::cbrt has the digits of a long double.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "contactlaws/core/power.hpp"

namespace contactlaws {

namespace detail {

/// The binary digits of one double or float, as BinaryDigits has them of a pack.
template <class T>
struct NumberDigits {
  using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

  CONTACTLAWS_HD static Bits bits(const T& x) noexcept {
    Bits to;
    std::memcpy(&to, &x, sizeof(T));
    return to;
  }
  CONTACTLAWS_HD static T number(const Bits& bits) noexcept {
    T to;
    std::memcpy(&to, &bits, sizeof(T));
    return to;
  }
};

template <class T, class Digits>
CONTACTLAWS_HD T cube_root_of_bits(const T& x) noexcept {
  using Bits = typename Digits::Bits;
  constexpr bool wide = sizeof(typename ScalarTraits<T>::Lane) == 8;
  const Bits bits = Digits::bits(x);
  Bits third = (bits >> 2) + (bits >> 4);  // 1/4 + 1/16 + 1/64 + ... = 1/3
  third = third + (third >> 4);
  third = third + (third >> 8);
  if constexpr (wide) third = third + (third >> 16);
  const Bits constant = [] {
    if constexpr (wide) {
      return Bits(std::uint64_t(0x553EF0FF289DD796));
    } else {
      return Bits(std::uint32_t(0x54A21D2A));
    }
  }();
  const T rough = Digits::number(constant - third);
  const T e_rough = T(1) - ((x * rough) * rough) * rough;
  const T i = rough + rough * (e_rough * (T(T(1) / T(3)) + e_rough * (T(T(2) / T(9)) + e_rough * T(T(14) / T(81)))));
  const T c = x * i * i;
  const T e = T(1) - c * i;
  return c + c * (e * (T(T(2) / T(3)) + e * (T(T(5) / T(9)) + e * T(T(40) / T(81)))));
}

}  // namespace detail

/// Types with derivatives specialise it (scalars/autodiff.hpp).
template <class T>
struct CubeRoot {
  CONTACTLAWS_HD static T of(const T& x) noexcept {
    using std::cbrt;
    if constexpr (BinaryDigits<T>::known) {
      return detail::cube_root_of_bits<T, BinaryDigits<T>>(x);
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, float>) {
      return detail::cube_root_of_bits<T, detail::NumberDigits<T>>(x);
    } else {
      return cbrt(x);
    }
  }
};

template <class T>
CONTACTLAWS_HD T cube_root(const T& x) noexcept {
  return CubeRoot<T>::of(x);
}

}  // namespace contactlaws

// SPDX-License-Identifier: MIT
// The sixth and the third root of x >= 0, of the same operations for one number and for a pack, so that both have equal bits:
//
//   x = y 2^(6n), y in [1/8, 8)                 the roots are those of y, times 2^n and 4^n
//   i_0  from the bits of y: those of y^(-1/6) are close to a constant less a sixth of them                18 % in i^6
//   e = 1 - y i^6       i = i_0 (1 + e/6 + 7/72 e^2 + 91/1296 e^3 + 1729/31104 e^4)                        5e-5 in i^6
//   y^(1/6) = y i^5 (1 - e)^(-5/6)        y^(1/3) = y i^4 (1 - e)^(-2/3), each to the third power of e      rounding alone
//
// No table, call, branch, division or square root. Error: <= 2 and 3 ULP (tests/core/test_sixth_root.cpp). Domain: normal numbers
// and 0. Types beyond 64 bits take cbrt() and sqrt().
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "contactlaws/core/power.hpp"

namespace contactlaws {

template <class T>
struct SixthRoot {
  T sixth;  ///< x^(1/6)
  T third;  ///< x^(1/3)
};

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

/// What depends on the format of a number.
template <class Lane>
struct SixthRootConstants;
template <>
struct SixthRootConstants<double> {
  using Word = std::uint64_t;
  static constexpr int mantissa = 52;
  static constexpr Word start = 0x4A9702BB00000000;
  static constexpr Word reduced_exponent = 1020, scale_exponent = 853;  // 1023 - 3, 1023 - 1020/6
};
template <>
struct SixthRootConstants<float> {
  using Word = std::uint32_t;
  static constexpr int mantissa = 23;
  static constexpr Word start = 0x4A0D44F3;
  static constexpr Word reduced_exponent = 126, scale_exponent = 106;  // 127 - 1, 127 - 126/6
};

template <class T, class Digits>
CONTACTLAWS_HD SixthRoot<T> sixth_root_of_bits(const T& x) noexcept {
  using Bits = typename Digits::Bits;
  using Constants = SixthRootConstants<typename ScalarTraits<T>::Lane>;
  const Bits all = Digits::bits(x);
  const Bits exponent = all >> Constants::mantissa;
  Bits product =
      exponent + (exponent << 2);  // 5, 85 and 21845 times the exponent: floor((e + 1) 21845 / 2^17) = floor(e/6)
  product = product + (product << 4);
  product = product + (product << 8);
  const Bits n = (product + Bits(typename Constants::Word(21845))) >> 17;
  const Bits reduced = all - (((n + n + n) << 1) << Constants::mantissa) +
                       Bits(typename Constants::Word(Constants::reduced_exponent << Constants::mantissa));
  Bits third = (reduced >> 2) + (reduced >> 4);  // 1/4 + 1/16 + 1/64 + ... = 1/3
  third = third + (third >> 4);
  third = third + (third >> 8);
  const T y = Digits::number(reduced);
  const T rough = Digits::number(Bits(typename Constants::Word(Constants::start)) - (third >> 1));
  const T square = rough * rough;
  const T e_rough = T(1) - (y * square) * (square * square);
  const T series = T(T(7) / T(72)) + e_rough * (T(T(91) / T(1296)) + e_rough * T(T(1729) / T(31104)));
  const T i = rough + rough * (e_rough * (T(T(1) / T(6)) + e_rough * series));
  const T third_root = y * ((i * i) * (i * i)), sixth_root = third_root * i;
  const T e = T(1) - sixth_root * i;
  const T scale =
      Digits::number((n + Bits(typename Constants::Word(Constants::scale_exponent))) << Constants::mantissa);
  const T to_sixth = e * (T(T(5) / T(6)) + e * (T(T(55) / T(72)) + e * T(T(935) / T(1296))));
  const T to_third = e * (T(T(2) / T(3)) + e * (T(T(5) / T(9)) + e * T(T(40) / T(81))));
  const Mask<T> positive = x > T(0);  // a zero has no leading digit; a NaN stays one
  return {select<T>(positive, T((sixth_root + sixth_root * to_sixth) * scale), x),
          select<T>(positive, T((third_root + third_root * to_third) * (scale * scale)), x)};
}

}  // namespace detail

/// Types with derivatives specialise it (scalars/autodiff.hpp).
template <class T>
struct SixthRootOf {
  CONTACTLAWS_HD static SixthRoot<T> of(const T& x) noexcept {
    using std::cbrt;
    using std::sqrt;
    if constexpr (BinaryDigits<T>::known) {
      return detail::sixth_root_of_bits<T, BinaryDigits<T>>(x);
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, float>) {
      return detail::sixth_root_of_bits<T, detail::NumberDigits<T>>(x);
    } else {
      const T third = cbrt(x);
      return {sqrt(third), third};
    }
  }
};

template <class T>
CONTACTLAWS_HD SixthRoot<T> sixth_root(const T& x) noexcept {
  return SixthRootOf<T>::of(x);
}

}  // namespace contactlaws

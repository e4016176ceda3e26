// SPDX-License-Identifier: MIT
// Numbers in input files. They are kept as text, so that each precision rounds the decimal number itself, once.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>
#include <type_traits>

#include "contactlaws/core/validate.hpp"
#include "input_error.hpp"

namespace common {

/// Whether the whole text is a decimal number, such as -1, 0.5 or 2.9e10. "nan", "inf" and hexadecimal numbers are not.
inline bool is_decimal(const std::string& text) {
  if (text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos) return false;
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return end == text.c_str() + text.size();
}

/// A decimal number rounded to T: zero if it is too small for T, infinity if it is too large.
template <class T>
T rounded(const std::string& decimal) {
  if constexpr (std::is_same_v<T, float>) {
    return std::strtof(decimal.c_str(), nullptr);
  } else if constexpr (std::is_same_v<T, double>) {
    return std::strtod(decimal.c_str(), nullptr);
  } else if constexpr (std::is_same_v<T, long double>) {
    return std::strtold(decimal.c_str(), nullptr);
  } else {
    // Outside long double's range, converting the text in high precision would need powers of ten of a huge exponent.
    const long double roughly = std::strtold(decimal.c_str(), nullptr);
    if (roughly == 0 || !std::isfinite(roughly)) return T(roughly);
    return T(decimal);
  }
}

/// The value of `what`, which stands as `text` at `place`. @throws InputError unless it is a number in the range, finite in T
template <class T>
T number_in(const contactlaws::Range& range, const std::string& text, const Place& place, const std::string& what,
            const std::string& unit) {
  using std::isfinite;
  const std::string in_unit = unit == "1" ? "" : ' ' + unit;
  if (!is_decimal(text))
    fail(place, what + " is " + in_quotes(text) + ", must be a number in " + contactlaws::to_string(range) + in_unit);
  if (!range.contains(rounded<double>(text)))
    fail(place, what + " is " + text.substr(0, 40) + in_unit + ", must lie in " + contactlaws::to_string(range));
  const T value = rounded<T>(text);
  if (!isfinite(value)) fail(place, what + " is " + text.substr(0, 40) + in_unit + ", too large for this precision");
  return value;
}

}  // namespace common

// SPDX-License-Identifier: MIT
// A parameter told as data: its name, unit, place and range. One table in each law serves the check of the values
// (validate.hpp), programs that read laws from a file, and their help.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

/// An interval of allowed values; always finite: infinity and NaN are out of every range.
struct Range {
  double low = 0.0;
  double high = 0.0;
  bool low_included = false;
  bool high_included = false;

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  static constexpr Range positive() { return {0.0, infinity, false, false}; }
  static constexpr Range not_negative() { return {0.0, infinity, true, false}; }
  static constexpr Range closed(double low, double high) { return {low, high, true, true}; }
  static constexpr Range left_open(double low, double high) { return {low, high, false, true}; }

  constexpr bool contains(double x) const {
    return (low_included ? x >= low : x > low) && (high_included ? x <= high : x < high);
  }
};

/// One parameter of `Owner`: where it lives and what it may be.
template <class Owner, class T>
struct Parameter {
  const char* name = "";
  const char* unit = "1";  ///< SI, "1" for a pure number
  T Owner::*member = nullptr;
  Range range = {};
};

/// One value of history, as a host sees it.
struct StateValue {
  const char* name = "";
  const char* unit = "1";
  int exchange_sign =
      1;  ///< -1: a vector's component, which changes sign when the two bodies are swapped; +1: a scalar
};

/// Two tables as one.
template <class Entry, std::size_t M, std::size_t N>
constexpr std::array<Entry, M + N> concatenate(const std::array<Entry, M>& first, const std::array<Entry, N>& second) {
  std::array<Entry, M + N> all{};
  for (std::size_t i = 0; i < M; ++i) all[i] = first[i];
  for (std::size_t i = 0; i < N; ++i) all[M + i] = second[i];
  return all;
}

/// The same slot of a law on another scalar, each parameter as `convert` makes it.
template <class U, class Slot, class Convert>
CONTACTLAWS_HD typename Slot::template Rebind<U> slot_cast(const Slot& slot, const Convert& convert) {
  typename Slot::template Rebind<U> result;
  const auto from = Slot::parameters();
  const auto to = Slot::template Rebind<U>::parameters();
  for (std::size_t i = 0; i < from.size(); ++i) result.*(to[i].member) = convert(slot.*(from[i].member));
  return result;
}

/// The same slot of a law with its parameters as numbers (or packs) of type U.
template <class U, class Slot>
CONTACTLAWS_HD typename Slot::template Rebind<U> slot_cast(const Slot& slot) {
  return slot_cast<U>(slot, [](const auto& x) { return scalar_cast<U>(x); });
}

}  // namespace contactlaws

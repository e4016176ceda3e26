// SPDX-License-Identifier: MIT
// A parameter described as data: name, unit, member and range. Each law has one table of them; it serves the check of the
// values (validate.hpp), programs that read laws from a file, and their help.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

#include "contactlaws/core/scalar.hpp"

namespace contactlaws {

/// An interval of allowed values. Infinity and NaN lie outside every range.
struct Range {
  double low = 0.0;            ///< lower bound
  double high = 0.0;           ///< upper bound
  bool low_included = false;   ///< whether the lower bound itself is allowed
  bool high_included = false;  ///< whether the upper bound itself is allowed

  /// The largest finite number as a bound: every finite number is allowed.
  static constexpr double unbounded = std::numeric_limits<double>::max();

  static constexpr Range any() { return {-unbounded, unbounded, true, true}; }                ///< every finite number
  static constexpr Range positive() { return {0.0, unbounded, false, true}; }                 ///< (0, inf)
  static constexpr Range not_negative() { return {0.0, unbounded, true, true}; }              ///< [0, inf)
  static constexpr Range closed(double low, double high) { return {low, high, true, true}; }  ///< [low, high]
  static constexpr Range left_open(double low, double high) { return {low, high, false, true}; }  ///< (low, high]

  /// Whether a value is allowed.
  constexpr bool contains(double x) const {
    return (low_included ? x >= low : x > low) && (high_included ? x <= high : x < high);
  }
};

/// One parameter of `Owner`: where it lives and what it may be.
template <class Owner, class T>
struct Parameter {
  const char* name = "";
  const char* unit = "1";      ///< SI, "1" for a pure number
  T Owner::*member = nullptr;  ///< where it lives
  Range range = {};            ///< what it may be
};

/// What a value of history is.
enum class ValueKind {
  scalar,
  vector  ///< a component: three in a row are x, y, z, which turn with the frame
};

/// One value of history, as a host stores it.
struct StateValue {
  const char* name = "";
  const char* unit = "1";
  int exchange_sign = 1;  ///< factor when the two bodies are swapped: -1 for a force or a displacement, else +1
  ValueKind kind = ValueKind::scalar;  ///< scalar, or component of a vector
};

/// Two tables joined.
template <class Entry, std::size_t M, std::size_t N>
constexpr std::array<Entry, M + N> concatenate(const std::array<Entry, M>& first, const std::array<Entry, N>& second) {
  std::array<Entry, M + N> all{};
  for (std::size_t i = 0; i < M; ++i) all[i] = first[i];
  for (std::size_t i = 0; i < N; ++i) all[M + i] = second[i];
  return all;
}

/// A table of a base class as the table of the class that inherits it.
template <class Owner, class T, class Base, std::size_t N>
constexpr std::array<Parameter<Owner, T>, N> inherited(const std::array<Parameter<Base, T>, N>& table) {
  std::array<Parameter<Owner, T>, N> all{};
  for (std::size_t i = 0; i < N; ++i) all[i] = {table[i].name, table[i].unit, table[i].member, table[i].range};
  return all;
}

namespace detail {
/// Whether a slot on a scalar that computes (a Column of a batch does not) has numbers that follow from its parameters.
template <class Slot, class U, class = void>
inline constexpr bool prepares = false;
template <class Slot, class U>
inline constexpr bool prepares<Slot, U, std::void_t<decltype(std::declval<Slot&>().prepare()), decltype(U(0) * U(0))>> =
    true;

template <class Call, std::size_t... i>
CONTACTLAWS_HD void for_each_index([[maybe_unused]] const Call& call, std::index_sequence<i...>) noexcept {
  (call(i), ...);
}
/// call(0) to call(count - 1). GCC unrolls a loop too late: by then it has put what the loop indexes in memory.
template <std::size_t count, class Call>
CONTACTLAWS_HD void for_each_index(const Call& call) noexcept {
  for_each_index(call, std::make_index_sequence<count>());
}

/// Copies `count` values of T from or to a State, which holds nothing else. With memcpy GCC keeps a State of packs in memory.
template <class T, std::size_t count>
CONTACTLAWS_HD void copy_values(void* to, const void* from) noexcept {
  for_each_index<count>([=](std::size_t i)
                            CONTACTLAWS_INLINE_LAMBDA { static_cast<T*>(to)[i] = static_cast<const T*>(from)[i]; });
}

}  // namespace detail

/// The same slot of a law on another scalar, each parameter converted by `convert`. A slot that derives numbers from its
/// parameters does so in prepare().
template <class U, class Slot, class Convert>
CONTACTLAWS_HD typename Slot::template Rebind<U> slot_cast(const Slot& slot, const Convert& convert) {
  typename Slot::template Rebind<U> result;
  const auto from = Slot::parameters();
  const auto to = Slot::template Rebind<U>::parameters();
  for (std::size_t i = 0; i < from.size(); ++i) result.*(to[i].member) = convert(slot.*(from[i].member));
  if constexpr (detail::prepares<typename Slot::template Rebind<U>, U>) result.prepare();
  return result;
}

/// The same slot of a law with its parameters as numbers (or packs) of type U.
template <class U, class Slot>
CONTACTLAWS_HD typename Slot::template Rebind<U> slot_cast(const Slot& slot) {
  return slot_cast<U>(slot, [](const auto& x) { return scalar_cast<U>(x); });
}

}  // namespace contactlaws

// SPDX-License-Identifier: MIT
// Parameters are checked once, where a law or a scene is built: the only file that throws.
// Message: what, its value and unit, the range allowed, e.g.
//   ElasticMaterial: poisson is 0.7, must lie in (-1, 0.5]
// Without exceptions in the build a rejected value ends the program.
#pragma once

#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "contactlaws/core/parameter.hpp"

namespace contactlaws {

/// Throws std::invalid_argument; without exceptions, aborts.
[[noreturn]] inline void reject(const std::string& message) {
#if defined(__cpp_exceptions)
  throw std::invalid_argument(message);
#else
  (void)message;
  std::abort();
#endif
}

/// An interval as text: (0, inf), [0, 1] and so on.
inline std::string to_string(const Range& range) {
  std::ostringstream text;
  text << (range.low_included && range.low != -Range::unbounded ? '[' : '(');
  if (range.low == -Range::unbounded) {
    text << "-inf";
  } else {
    text << range.low;
  }
  text << ", ";
  if (range.high == Range::unbounded) {
    text << "inf)";
  } else {
    text << range.high << (range.high_included ? ']' : ')');
  }
  return text.str();
}

/// The shortest decimal that reads back as the same number: 0.7, not 0.69999999999999996.
inline std::string to_string(double value) {
  for (int digits = 6;; ++digits) {
    std::ostringstream text;
    text.precision(digits);
    text << value;
    if (digits == std::numeric_limits<double>::max_digits10 || std::strtod(text.str().c_str(), nullptr) == value)
      return text.str();
  }
}

/// Rejects `value` unless it lies in `range`. @throws std::invalid_argument naming owner, name, value, unit and range
inline void require_in(const Range& range, double value, const char* owner, const char* name, const char* unit) {
  if (range.contains(value)) return;
  std::ostringstream text;
  text << owner << ": " << name << " is " << to_string(value);
  if (std::string(unit) != "1") text << ' ' << unit;
  text << ", must lie in " << to_string(range);
  reject(text.str());
}

namespace detail {
template <class Owner, class = void>
struct HasSlots : std::false_type {};
template <class Owner>
struct HasSlots<Owner, std::void_t<decltype(std::declval<Owner&>().slots())>> : std::true_type {};
}  // namespace detail

/// Calls visit(name of the owner, parameter, value) for each parameter of `owner`, of a law over all its slots.
/// `Owner` offers `name` and `parameters()` (Dashpots is a short example), or `slots()` that do.
template <class Owner, class Visit>
void visit_parameters(Owner& owner, const Visit& visit) {
  if constexpr (detail::HasSlots<Owner>::value) {
    std::apply([&visit](auto&... slot) { (visit_parameters(slot, visit), ...); }, owner.slots());
  } else {
    for (const auto& p : Owner::parameters()) visit(Owner::name, p, owner.*p.member);
  }
}

/// Rejects `owner` unless each of its parameters lies in its range; returns it otherwise.
/// @throws std::invalid_argument at the first that does not
template <class Owner>
Owner checked(const Owner& owner) {
  visit_parameters(owner, [](const char* name, const auto& p, const auto& value) {
    require_in(p.range, static_cast<double>(value), name, p.name, p.unit);
  });
  return owner;
}

/// Sets the parameter of this name, of a law in whichever slot it is; checked() then checks it.
/// @throws std::invalid_argument listing the names that there are, and `others`, which the caller knows beside them: "young, poisson"
template <class Owner, class T>
void set_parameter(Owner& owner, const std::string& name, const T& value, const std::string& others = {}) {
  bool found = false;
  std::string names;
  visit_parameters(owner, [&](const char*, const auto& p, auto& member) {
    names += (names.empty() ? "" : ", ") + std::string(p.name);
    if (name != p.name) return;
    member = value;
    found = true;
  });
  if (!others.empty()) names += (names.empty() ? "" : ", ") + others;
  if (!found) reject("no parameter '" + name + "'; there " + (names.empty() ? "is none" : "are: " + names));
}

}  // namespace contactlaws

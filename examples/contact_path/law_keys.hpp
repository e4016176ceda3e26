// SPDX-License-Identifier: MIT
// The keys that a table of LAW.toml may contain, and the values that a user gave for them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "common/number.hpp"
#include "contactlaws/damping/restitution.hpp"

namespace contact_path {

using namespace common;

enum class Presence {
  required,
  optional,
  either  ///< exactly one of the keys with this presence
};

struct NumberKey {
  std::string name;
  std::string unit;
  contactlaws::Range range;
  Presence presence;
  std::string doc;
};

/// One of a few words; the first is the default.
struct WordKey {
  std::string name;
  std::vector<std::string> words;
  std::string doc;
};

/// true or false; false is the default.
struct FlagKey {
  std::string name;
  std::string doc;
};

/// A law that a slot may hold, or another group of keys.
struct KeyTable {
  std::string name;
  std::string doc;
  std::vector<std::string> reads;  ///< effective properties of the pair that the law reads
  std::vector<NumberKey> numbers;
  std::vector<WordKey> words;
  std::vector<FlagKey> flags;
  std::optional<contactlaws::Spring>
      spring;  ///< normal laws: converts a coefficient of restitution, where that is known
};

/// The parameters of a slot. One whose default is zero is required.
template <class Slot>
std::vector<NumberKey> number_keys() {
  std::vector<NumberKey> keys;
  for (const auto& p : Slot::parameters()) {
    const double otherwise = Slot{}.*(p.member);
    std::ostringstream doc;
    if (otherwise != 0.0) doc << "default " << otherwise;
    keys.push_back({p.name, p.unit, p.range, otherwise != 0.0 ? Presence::optional : Presence::required, doc.str()});
  }
  return keys;
}

/// The parameter `name` of a slot, with another presence and text.
template <class Slot>
NumberKey number_key(const std::string& name, Presence presence, const std::string& doc = "") {
  for (const auto& p : Slot::parameters())
    if (name == p.name) return {name, p.unit, p.range, presence, doc};
  throw std::logic_error("no parameter " + name);
}

/// A decimal number as it is written in the file. Its range has been checked.
struct Number {
  std::string text;
  Place place;
};

/// A law chosen for a slot, or another group of keys: the values given, and the defaults of words.
struct Chosen {
  Place place;
  std::string title;  ///< in messages, [shear] for example
  std::string law;
  std::map<std::string, Number> numbers;
  std::map<std::string, std::string> words;
  std::set<std::string> flags;

  bool acts() const { return law != "none"; }
  bool has(const std::string& number) const { return numbers.count(number) > 0; }
  bool is(const std::string& flag) const { return flags.count(flag) > 0; }
  const std::string& word(const std::string& key) const { return words.at(key); }
  [[noreturn]] void refuse(const std::string& key, const std::string& why) const {
    fail(has(key) ? numbers.at(key).place : place, title + ' ' + key + ' ' + why);
  }

  /// A number that is there, rounded to T once. @throws InputError if it is too large for T
  template <class T>
  T number(const std::string& key) const {
    using std::isfinite;
    const std::string& text = numbers.at(key).text;
    const T value = rounded<T>(text);
    if (!isfinite(value)) refuse(key, "is " + text + ", too large for this precision");
    return value;
  }
  template <class T>
  T number_or(const std::string& key, const T& otherwise) const {
    return has(key) ? number<T>(key) : otherwise;
  }
  /// A slot with the parameters that were given; the others keep their values.
  template <class T, class Slot>
  Slot filled(Slot slot) const {
    for (const auto& p : Slot::parameters()) slot.*(p.member) = number_or<T>(p.name, slot.*(p.member));
    return slot;
  }
};

}  // namespace contact_path

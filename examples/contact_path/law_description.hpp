// SPDX-License-Identifier: MIT
// What a LAW.toml says, checked but not yet a law: names of laws, and their numbers, words and flags.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "common/number.hpp"

namespace contact_path {

using namespace common;

/// A number of the file. Its range has been checked.
struct Number {
  std::string text;  ///< decimal, as it was written
  Place place;
};

/// A law in its slot, or another group of keys: what was written, and the defaults of the words that were not.
struct Description {
  Place place;
  std::string title;  ///< as messages call it, [shear] say
  std::string law;
  std::map<std::string, Number> numbers;
  std::map<std::string, std::string> words;
  std::set<std::string> flags;

  bool has(const std::string& number) const { return numbers.count(number) > 0; }
  bool is(const std::string& flag) const { return flags.count(flag) > 0; }
  const std::string& word(const std::string& key) const { return words.at(key); }

  /// A number that is there. @throws InputError if it is too large for T
  template <class T>
  T number(const std::string& key) const {
    using std::isfinite;
    const Number& found = numbers.at(key);
    const T value = rounded<T>(found.text);
    if (!isfinite(value)) fail(found.place, title + ' ' + key + " is " + found.text + ", too large for this precision");
    return value;
  }
  template <class T>
  T number_or(const std::string& key, const T& otherwise) const {
    return has(key) ? number<T>(key) : otherwise;
  }
};

struct LawDescription {
  Description normal;
  Description damping;
  Description shear;
  Description bridge;
  Description pair;                 ///< effective values, unless there are bodies
  std::vector<Description> bodies;  ///< none or two

  /// Whether shear takes Mindlin's stiffness, which Hertz's contact radius gives; in a constant ratio to the normal law's otherwise.
  bool is_mindlin() const { return normal.law == "hertz" && shear.law != "constant_ratio" && shear.law != "none"; }
};

}  // namespace contact_path

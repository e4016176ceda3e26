// SPDX-License-Identifier: MIT
// LAW.toml: which law, between which pair of bodies.
//
//   normal = "hertz"             a slot by its law's name ...
//
//   [shear]                      ... or a table with its law and the keys of this
//   law = "force"
//   friction = 0.4
//
//   [pair]                       effective values, or [pair.body1] and [pair.body2]
//   radius = 3e-3
//
// catalogue.hpp has the names and keys. Slots but `normal` may be left out: none.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "catalogue.hpp"
#include "law_description.hpp"

namespace contact_path {

namespace detail {

class LawFile {
 public:
  explicit LawFile(const std::string& file) : file_(file), text_(read_text(file)) {}

  LawDescription read() const {
    const toml::table root = parse();
    for (const auto& [key, node] : root)
      if (!one_of(key.str(), {"normal", "damping", "shear", "bridge", "pair"}))
        fail(at(key.source()),
             "no such key: " + in_quotes(std::string(key.str())) + "; there are normal, damping, shear, bridge, pair");
    LawDescription law{slot(root, "normal", normal_choices()), slot(root, "damping", damping_choices()),
                       slot(root, "shear", shear_choices()),   slot(root, "bridge", bridge_choices()),
                       {{file_}, "[pair]", {}, {}, {}, {}},    {}};
    read_pair(root, law);
    check_composition(law);
    return law;
  }

 private:
  toml::table parse() const {
    try {
      return toml::parse(std::string_view(text_), std::string_view(file_));
    } catch (const toml::parse_error& error) {
      fail(at(error.source()), std::string(error.description()));
    }
  }

  Place at(const toml::source_region& region) const { return {file_, region.begin.line, region.begin.column}; }

  static bool one_of(std::string_view name, const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }

  Description slot(const toml::table& root, const std::string& name, const std::vector<Choice>& choices) const {
    std::vector<std::string> laws;
    for (const Choice& choice : choices) laws.push_back(choice.name);
    const std::string one_of_them = "must be one of " + listed(laws);

    const toml::node* node = root.get(name);
    if (node == nullptr) {
      if (!one_of(choices.front().name, {"none"})) fail({file_}, name + " is missing, " + one_of_them);
      return {{file_}, '[' + name + ']', choices.front().name, {}, {}, {}};
    }
    const toml::table* table = node->as_table();
    const toml::node* law = table != nullptr ? table->get("law") : node;
    if (law == nullptr) fail(at(node->source()), '[' + name + "] law is missing, " + one_of_them);
    const std::string* law_name = law->is_string() ? &law->as_string()->get() : nullptr;
    const auto choice = std::find_if(choices.begin(), choices.end(),
                                     [&](const Choice& c) { return law_name != nullptr && c.name == *law_name; });
    if (choice == choices.end())
      fail(at(law->source()), '[' + name + "] law is " + source_of(*law) + ", " + one_of_them);
    static const toml::table no_keys;
    return group(table != nullptr ? *table : no_keys, at(node->source()), '[' + name + ']', *choice, {"law"});
  }

  void read_pair(const toml::table& root, LawDescription& law) const {
    const toml::node* node = root.get("pair");
    if (node == nullptr) return;
    const toml::table* table = node->as_table();
    if (table == nullptr) fail(at(node->source()), "pair must be a table");
    if (table->get("body1") == nullptr && table->get("body2") == nullptr) {
      law.pair = group(*table, at(node->source()), "[pair]", effective_pair(), {});
      return;
    }
    for (const auto& [key, value] : *table)
      if (!one_of(key.str(), {"body1", "body2"}))
        fail(at(key.source()), "[pair] has bodies, so it cannot have " + in_quotes(std::string(key.str())));
    law.pair.place = at(node->source());
    for (const char* name : {"body1", "body2"}) {
      const toml::node* side = table->get(name);
      if (side == nullptr) fail(at(node->source()), std::string("[pair] ") + name + " is missing");
      if (!side->is_table()) fail(at(side->source()), std::string("[pair] ") + name + " must be a table");
      law.bodies.push_back(
          group(*side->as_table(), at(side->source()), std::string("[pair.") + name + ']', body(), {}));
      check_body(law.bodies.back());
    }
  }

  /// The keys of a group, checked one by one.
  Description group(const toml::table& table, const Place& place, const std::string& title, const Choice& choice,
                    const std::vector<std::string>& known_already) const {
    Description result{place, title, choice.name, {}, {}, {}};
    std::vector<std::string> unread;
    for (const auto& [key, value] : table)
      if (!one_of(key.str(), known_already)) unread.emplace_back(key.str());
    const auto take = [&](const std::string& name) {
      unread.erase(std::remove(unread.begin(), unread.end(), name), unread.end());
      return table.get(name);
    };
    std::vector<std::string> names, either;
    for (const NumberKey& key : choice.numbers) {
      if (const toml::node* node = take(key.name)) result.numbers[key.name] = number(*node, title, key);
      names.push_back(key.name);
      if (key.presence == Presence::either) either.push_back(key.name);
    }
    for (const WordKey& key : choice.words) {
      const toml::node* node = take(key.name);
      result.words[key.name] = node == nullptr ? key.words.front() : word(*node, title, key);
      names.push_back(key.name);
    }
    for (const FlagKey& key : choice.flags) {
      if (const toml::node* node = take(key.name); node != nullptr && flag(*node, title, key))
        result.flags.insert(key.name);
      names.push_back(key.name);
    }
    if (!unread.empty()) {
      const toml::node* node = table.get(unread.front());
      fail(at(node->source()), title + ' ' + choice.name + " has no key " + in_quotes(unread.front()) + "; it has " +
                                   (names.empty() ? "none" : listed(names)));
    }
    for (const NumberKey& key : choice.numbers)
      if (key.presence == Presence::required && !result.has(key.name)) missing(result, key);
    const auto given = std::count_if(either.begin(), either.end(), [&](const auto& name) { return result.has(name); });
    if (!either.empty() && given != 1)
      fail(place, title + ' ' + choice.name + " must have one of " + listed(either) + ", and has " +
                      (given == 0 ? "none" : "more"));
    return result;
  }

  [[noreturn]] static void missing(const Description& group, const NumberKey& key) {
    fail(group.place, group.title + ' ' + key.name + " is missing, must be a number in " +
                          contactlaws::to_string(key.range) + (key.unit == "1" ? "" : ' ' + key.unit));
  }

  Number number(const toml::node& node, const std::string& title, const NumberKey& key) const {
    const Place place = at(node.source());
    const std::string text = node.is_number() ? decimal_of(node) : source_of(node);
    number_in<double>(key.range, text, place, title + ' ' + key.name, key.unit);
    return {text, place};
  }

  std::string word(const toml::node& node, const std::string& title, const WordKey& key) const {
    if (node.is_string() && one_of(node.as_string()->get(), key.words)) return node.as_string()->get();
    fail(at(node.source()),
         title + ' ' + key.name + " is " + source_of(node) + ", must be one of " + listed(key.words));
  }

  bool flag(const toml::node& node, const std::string& title, const FlagKey& key) const {
    if (node.is_boolean()) return node.as_boolean()->get();
    fail(at(node.source()), title + ' ' + key.name + " is " + source_of(node) + ", must be true or false");
  }

  /// The digits as they stand in the file, since a TOML number has been rounded to double; that rounded number where it is
  /// written in another way (hexadecimal, say).
  std::string decimal_of(const toml::node& node) const {
    std::string text = source_of(node);
    text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
    const double value = *node.value<double>();
    if (is_decimal(text) && rounded<double>(text) == value) return text;
    std::ostringstream printed;
    printed.precision(17);
    printed << value;
    return printed.str();
  }

  /// What was written, from the place where the node begins to where it ends or its line does. Columns count characters.
  std::string source_of(const toml::node& node) const {
    const toml::source_region& region = node.source();
    std::size_t begin = 0;
    for (toml::source_index line = 1; line < region.begin.line; ++line) begin = text_.find('\n', begin) + 1;
    const auto skip = [this](std::size_t from, toml::source_index characters) {
      while (from < text_.size() && text_[from] != '\n' && characters > 0) {
        ++from;
        while (from < text_.size() && (static_cast<unsigned char>(text_[from]) & 0xC0U) == 0x80U) ++from;
        --characters;
      }
      return from;
    };
    begin = skip(begin, region.begin.column - 1);
    const bool one_line = region.begin.line == region.end.line;
    const std::size_t end = one_line ? skip(begin, region.end.column - region.begin.column) : text_.find('\n', begin);
    return text_.substr(begin, end - begin);
  }

  /// A body is a sphere or a wall, and has what makes it one.
  static void check_body(const Description& body) {
    const auto must_have = [&](const char* key) {
      if (!body.has(key)) fail(body.place, body.title + ' ' + key + " is missing");
    };
    const auto cannot_have = [&](const char* key, const char* why) {
      if (body.has(key)) fail(body.numbers.at(key).place, body.title + ' ' + key + " is given, but " + why);
    };
    if (body.is("plane")) {
      for (const char* key : {"radius", "density", "mass"}) cannot_have(key, "a plane has none");
    } else {
      must_have("radius");
      if (body.has("mass")) cannot_have("density", "so is mass");
      if (!body.is("fixed") && !body.has("mass")) must_have("density");
    }
    if (body.is("rigid")) return;
    must_have("young");
    must_have("poisson");
  }

  /// What no single slot can see.
  static void check_composition(const LawDescription& law) {
    if (law.damping.has("restitution") && law.normal.law != "hertz" && law.normal.law != "linear")
      fail(law.damping.numbers.at("restitution").place,
           "[damping] restitution is given, but beside " + law.normal.law +
               " it depends on the speed of impact: give damping_constant");
    if (law.is_mindlin() && law.shear.has("ratio"))
      fail(law.shear.numbers.at("ratio").place, "[shear] ratio is given, but beside hertz the law " + law.shear.law +
                                                    " takes Mindlin's stiffness: use law = \"constant_ratio\"");
    if (!law.bodies.empty()) return;

    const auto needs = [&law](const std::string& key, const std::string& why) {
      if (law.pair.has(key)) return;
      for (const NumberKey& number : effective_pair().numbers)
        if (number.name == key)
          fail(law.pair.place, "[pair] " + key + " is missing, must be a number in " +
                                   contactlaws::to_string(number.range) + ' ' + number.unit + ": " + why +
                                   " asks for it");
    };
    const auto needs_all = [&](const Description& slot, const std::vector<Choice>& choices) {
      for (const Choice& choice : choices)
        if (choice.name == slot.law)
          for (const std::string& key : choice.of_pair) needs(key, slot.title + ' ' + slot.law);
    };
    needs_all(law.normal, normal_choices());
    needs_all(law.damping, damping_choices());
    needs_all(law.bridge, bridge_choices());
    if (law.normal.has("modulus")) {
      needs("min_radius", "[normal] modulus");
      needs("length", "[normal] modulus");
    }
    if (law.is_mindlin()) needs("shear", "Mindlin's stiffness");
    if (!law.is_mindlin() && law.shear.law != "none" && !law.shear.has("ratio")) {
      needs("young", "[shear] without a ratio");
      needs("shear", "[shear] without a ratio");
    }
  }

  std::string file_;
  std::string text_;
};

}  // namespace detail

/// @throws InputError naming file, line, key, value and range
inline LawDescription read_law(const std::string& file) { return detail::LawFile(file).read(); }

}  // namespace contact_path

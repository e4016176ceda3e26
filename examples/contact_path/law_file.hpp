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
//   effective_radius = 3e-3
//
// law_spec.hpp has the names and keys. Every slot but `normal` may be left out.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "law_spec.hpp"

namespace contact_path {

namespace detail {

class LawFile {
 public:
  LawFile(std::string file, std::string text) : file_(std::move(file)), text_(std::move(text)) {}

  LawSpec read() const {
    const toml::table root = parse();
    std::vector<std::string> known;
    for (const SlotTable& s : slot_tables()) known.push_back(s.name);
    known.push_back("pair");
    for (const auto& [key, node] : root)
      if (!one_of(key.str(), known))
        fail(at(key.source()), "no such key: " + in_quotes(std::string(key.str())) + "; there are " + listed(known));
    LawSpec law;
    for (const SlotTable& s : slot_tables()) law.*s.chosen = slot(root, s.name, s.laws);
    law.pair.place = {file_};
    law.pair.title = "[pair]";
    read_pair(root, law);
    check(law);
    if (law.shear.acts()) note_angle(law.shear);
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

  Chosen slot(const toml::table& root, const std::string& name, const std::vector<KeyTable>& laws) const {
    std::vector<std::string> names;
    for (const KeyTable& keys : laws) names.push_back(keys.name);
    const std::string one_of_them = "must be one of " + listed(names);

    const toml::node* node = root.get(name);
    if (node == nullptr) {
      if (names.front() != "none") fail({file_}, name + " is missing, " + one_of_them);
      return {{file_}, '[' + name + ']', "none", {}, {}, {}};
    }
    const toml::table* table = node->as_table();
    const toml::node* law = table != nullptr ? table->get("law") : node;
    if (law == nullptr) fail(at(node->source()), '[' + name + "] law is missing, " + one_of_them);
    const std::string* law_name = law->is_string() ? &law->as_string()->get() : nullptr;
    const auto keys = std::find_if(laws.begin(), laws.end(),
                                   [&](const KeyTable& k) { return law_name != nullptr && k.name == *law_name; });
    if (keys == laws.end()) fail(at(law->source()), '[' + name + "] law is " + source_of(*law) + ", " + one_of_them);
    static const toml::table no_keys;
    return group(table != nullptr ? *table : no_keys, at(node->source()), '[' + name + ']', *keys, {"law"});
  }

  void read_pair(const toml::table& root, LawSpec& law) const {
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

  /// The keys of a table, checked one by one.
  Chosen group(const toml::table& table, const Place& place, const std::string& title, const KeyTable& keys,
               const std::vector<std::string>& known_already) const {
    Chosen result{place, title, keys.name, {}, {}, {}};
    std::vector<std::string> unread;
    for (const auto& [key, value] : table)
      if (!one_of(key.str(), known_already)) unread.emplace_back(key.str());
    const auto take = [&](const std::string& name) {
      unread.erase(std::remove(unread.begin(), unread.end(), name), unread.end());
      return table.get(name);
    };
    std::vector<std::string> names, either;
    for (const NumberKey& key : keys.numbers) {
      if (const toml::node* node = take(key.name)) result.numbers[key.name] = number(*node, title, key);
      names.push_back(key.name);
      if (key.presence == Presence::either) either.push_back(key.name);
    }
    for (const WordKey& key : keys.words) {
      const toml::node* node = take(key.name);
      result.words[key.name] = node == nullptr ? key.words.front() : word(*node, title, key);
      names.push_back(key.name);
    }
    for (const FlagKey& key : keys.flags) {
      if (const toml::node* node = take(key.name); node != nullptr && flag(*node, title, key))
        result.flags.insert(key.name);
      names.push_back(key.name);
    }
    if (!unread.empty()) {
      const bool angle = unread.front().find("angle") != std::string::npos && one_of("friction", names);
      fail(at(table.get(unread.front())->source()),
           title + ' ' + keys.name + " has no key " + in_quotes(unread.front()) + "; it has " +
               (names.empty() ? "none" : listed(names)) +
               (angle ? "; friction is a coefficient, the tangent of the angle" : ""));
    }
    for (const NumberKey& key : keys.numbers)
      if (key.presence == Presence::required && !result.has(key.name)) missing(result, key);
    const auto given = std::count_if(either.begin(), either.end(), [&](const auto& name) { return result.has(name); });
    if (!either.empty() && given != 1)
      fail(place, title + ' ' + keys.name + " must have one of " + listed(either) + ", and has " +
                      (given == 0 ? "none" : "more"));
    return result;
  }

  [[noreturn]] static void missing(const Chosen& group, const NumberKey& key) {
    group.refuse(key.name, "is missing, must be a number in " + contactlaws::to_string(key.range) +
                               (key.unit == "1" ? "" : ' ' + key.unit));
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

  static void note_angle(const Chosen& shear) {
    const Number& friction = shear.numbers.at("friction");
    const double value = shear.number<double>("friction");
    if (value > 10.0 && value < 90.0)
      note(friction.place, "[shear] friction is " + friction.text + ": a coefficient, the tangent of an angle");
  }

  /// A body is a sphere or a wall, and has what makes it one.
  static void check_body(const Chosen& body) {
    const auto must_have = [&](const char* key) {
      if (!body.has(key)) body.refuse(key, "is missing");
    };
    const auto cannot_have = [&](const char* key, const std::string& why) {
      if (body.has(key)) body.refuse(key, "is given, but " + why);
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

  std::string file_;
  std::string text_;
};

}  // namespace detail

/// The law in a text; messages call it `file`. @throws InputError naming file, line, key, value and range
inline LawSpec parse_law(const std::string& text, const std::string& file) {
  return detail::LawFile(file, text).read();
}
/// @throws InputError naming file, line, key, value and range
inline LawSpec read_law(const std::string& file) { return parse_law(read_text(file), file); }

}  // namespace contact_path

// SPDX-License-Identifier: MIT
// contact_path --list: the keys of LAW.toml and the columns of both CSV files, from the tables that read them.
#pragma once

#include <iomanip>
#include <ostream>
#include <string>

#include "law_spec.hpp"
#include "path_file.hpp"

namespace contact_path {

namespace detail {

inline void list_key(std::ostream& out, const std::string& name, const std::string& unit, const std::string& range,
                     const std::string& says) {
  out << "      " << std::left << std::setw(23) << name << std::setw(7) << unit << std::setw(14) << range << "  "
      << says << '\n';
}

inline std::string with_presence(const NumberKey& key) {
  const std::string presence = key.presence == Presence::required ? "required"
                               : key.presence == Presence::either ? "either this or another"
                                                                  : "";
  return presence + (presence.empty() || key.doc.empty() ? "" : "; ") + key.doc;
}

inline void list_keys(std::ostream& out, const KeyTable& keys) {
  out << "   " << std::left << std::setw(28) << keys.name << ' ' << keys.doc << '\n';
  for (const NumberKey& key : keys.numbers)
    list_key(out, key.name, key.unit, contactlaws::to_string(key.range), with_presence(key));
  for (const WordKey& key : keys.words) {
    std::string words;
    for (const std::string& word : key.words) words += (words.empty() ? "\"" : " | \"") + word + '"';
    out << "      " << std::setw(23) << key.name << words << " (the first is the default): " << key.doc << '\n';
  }
  for (const FlagKey& key : keys.flags)
    out << "      " << std::setw(23) << key.name << "true | false (the default): " << key.doc << '\n';
  if (!keys.reads.empty()) out << "      reads the pair's " << listed(keys.reads) << '\n';
}

inline void list_slot(std::ostream& out, const std::string& name, const std::vector<KeyTable>& laws) {
  out << '[' << name << "] law =\n";
  for (const KeyTable& keys : laws) list_keys(out, keys);
  out << '\n';
}

}  // namespace detail

inline void list_all(std::ostream& out) {
  out << "LAW.toml: a slot is a table such as [normal] with law = \"hertz\" and the law's keys, or just normal = "
         "\"hertz\".\n"
         "Slots but normal may be left out. Numbers are in SI units.\n\n";
  for (const SlotTable& slot : slot_tables()) detail::list_slot(out, slot.name, slot.laws);
  out << "[pair]\n";
  detail::list_keys(out, effective_pair());
  out << "\n[pair.body1] and [pair.body2], instead\n";
  detail::list_keys(out, body());
  out << "\nPATH.csv: a header that names these columns, then a row a step\n";
  for (const Column& column : path_columns())
    detail::list_key(out, column.name, column.unit, contactlaws::to_string(column.range),
                     (column.required ? "" : "may be left out; ") + column.says);
  out << "\nOUT.csv: a row a step, in 17 significant digits\n";
  const auto column = [&out](const char* name, const char* unit, const char* says) {
    detail::list_key(out, name, unit, "", says);
  };
  column("step", "1", "from 1");
  column("fx, fy, fz", "N", "force on body 2; body 1 gets the opposite");
  column("mx, my, mz", "N m", "couple on body 2 from rolling, without arm x force; body 1 gets the opposite");
  column("fn_elastic", "N", "force of the normal law alone, compression > 0");
  column("fn_total", "N", "along the normal: spring, dashpot and bridge");
  column("slip", "0 | 1", "whether friction limited the shear force");
  column("active", "0 | 1", "whether the contact touches or is bridged");
  column("stored_energy", "J", "in springs and bridge, after the step");
  column("dissipated_energy", "J",
         "work done on the contact since the start of the first step, less the energy that it stored");
  column("...", "", "the values of the law's state after the step, by name");
}

}  // namespace contact_path

// SPDX-License-Identifier: MIT
// RECORDING.csv: how the contacts of a run moved, a row per contact and step, the rows of each contact in the order of time.
// The columns are `contact`, its number, and those of a motion (contact_path/path_file.hpp). Contacts may come and go; each
// starts without history.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "contact_path/path_file.hpp"
#include "trajectories.hpp"

namespace trade {

/// @throws InputError naming file, line and column
inline Trajectories read_recording(const std::string& file) {
  using contactlaws::Range;
  constexpr double largest_number = 9007199254740992.0;  // 2^53: up to there a double holds every integer
  std::vector<common::Column> columns = contact_path::motion_columns();
  columns.insert(columns.begin(), {"contact", "1", Range::closed(0.0, largest_number), true, "its number: an integer"});
  common::CsvFile csv(file, columns);
  std::map<double, std::size_t> index_of;
  std::vector<std::vector<ContactKinematics<double>>> contacts;
  while (csv.next()) {
    const double number = csv.number<double>(0);
    if (number != std::floor(number)) common::fail(csv.place(), "column contact is no integer");
    const std::size_t index = index_of.emplace(number, contacts.size()).first->second;
    if (index == contacts.size()) contacts.emplace_back();
    contacts[index].push_back(contact_path::read_motion<double>(csv, 1));
  }
  if (contacts.empty()) common::fail(csv.place(), "has a header but no rows");

  std::stable_sort(contacts.begin(), contacts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  Trajectories trajectories;
  trajectories.name = file;
  for (std::size_t step = 0; step < contacts.front().size(); ++step) {
    for (const auto& contact : contacts) {
      if (step >= contact.size()) break;
      trajectories.in_double.push_back(contact[step]);
      trajectories.exact.push_back(contact[step].cast<Binary200>());
    }
    trajectories.offset.push_back(trajectories.in_double.size());
  }
  return trajectories;
}

}  // namespace trade

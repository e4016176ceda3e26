// SPDX-License-Identifier: MIT
// RECORDING.csv: how the contacts of a run moved, a row a contact and step, each contact's rows in the order of time. The
// columns are those of a path (contact_path/path_file.hpp, make_wet excepted) and `contact`, its number. Contacts may come
// and go; each starts virgin.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "../../examples/contact_path/path_file.hpp"
#include "scene.hpp"

namespace trade {

/// @throws contact_path::InputError naming file, line and column
inline Scene read_recording(const std::string& file) {
  using contactlaws::Range;
  constexpr double largest_number = 9007199254740992.0;  // 2^53: up to there a double holds every integer
  std::vector<contact_path::Column> columns{
      {"contact", "1", Range::closed(0.0, largest_number), true, "its number: an integer"}};
  for (const contact_path::Column& column : contact_path::path_columns())
    if (column.name != "make_wet") columns.push_back(column);

  contact_path::CsvFile csv(file, columns);
  const auto vector = [&csv](std::size_t first) {
    return Vec3<double>(csv.number<double>(first), csv.number<double>(first + 1), csv.number<double>(first + 2));
  };
  std::map<double, std::size_t> index_of;
  std::vector<std::vector<ContactKinematics<double>>> contacts;
  while (csv.next()) {
    const double number = csv.number<double>(0);
    if (number != std::floor(number)) contact_path::fail(csv.place(), "column contact is no integer");
    const Vec3<double> direction = vector(3);
    const double length = contactlaws::norm<double>(direction);
    if (!(length > 0.0) || !std::isfinite(length))
      contact_path::fail(csv.place(), "the normal (nx, ny, nz) is " + std::string(length > 0.0 ? "too long" : "zero") +
                                          ", must have a direction");
    const std::size_t index = index_of.emplace(number, contacts.size()).first->second;
    if (index == contacts.size()) contacts.emplace_back();
    contacts[index].push_back({direction / length, csv.number<double>(2), vector(6), csv.number<double>(1),
                               csv.number_if_any<double>(9).value_or(0.0)});
  }
  if (contacts.empty()) contact_path::fail(csv.place(), "has a header but no rows");

  std::stable_sort(contacts.begin(), contacts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  Scene scene;
  scene.name = file;
  for (std::size_t step = 0; step < contacts.front().size(); ++step) {
    for (const auto& contact : contacts) {
      if (step >= contact.size()) break;
      scene.in_double.push_back(contact[step]);
      scene.exact.push_back(contact[step].cast<Binary200>());
    }
    scene.offset.push_back(scene.in_double.size());
  }
  return scene;
}

}  // namespace trade

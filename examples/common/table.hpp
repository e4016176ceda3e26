// SPDX-License-Identifier: MIT
// A table of numbers, filled row by row and written as CSV.
#pragma once

#include <initializer_list>
#include <ostream>
#include <string>
#include <vector>

namespace common {

class Table {
 public:
  explicit Table(std::initializer_list<std::string> columns) : columns_(columns) {}

  /// A number for each column, in their order.
  void add(std::initializer_list<double> row) { rows_.emplace_back(row); }
  const std::vector<std::vector<double>>& rows() const { return rows_; }

  void write_csv(std::ostream& out) const {
    write_line(out, columns_);
    for (const std::vector<double>& row : rows_) write_line(out, row);
  }

 private:
  template <class Cells>
  static void write_line(std::ostream& out, const Cells& cells) {
    const char* separator = "";
    for (const auto& cell : cells) {
      out << separator << cell;
      separator = ",";
    }
    out << '\n';
  }

  std::vector<std::string> columns_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace common

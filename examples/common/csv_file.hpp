// SPDX-License-Identifier: MIT
// Reading CSV: a header that names the columns, in any order, then a row of as many numbers a line. Empty lines and lines that
// begin with # are skipped. Messages name file, line and column.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "number.hpp"

namespace common {

struct Column {
  std::string name;
  std::string unit;
  contactlaws::Range range;
  bool required;
  std::string says;
};

/// A file and its current row; next() goes to the next row.
class CsvFile {
 public:
  /// @throws InputError if the file cannot be read, or its header misses a required column, or names an unknown one or one twice
  CsvFile(const std::string& file, std::vector<Column> columns)
      : file_(file), text_(read_text(file)), columns_(std::move(columns)), cell_of_(columns_.size()) {
    if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0)
      position_ = 3;  // byte order mark, which some programs write before UTF-8
    read_header();
  }

  /// Goes to the next row. False if there is none. @throws InputError if it has too many or too few cells
  bool next() {
    if (!next_line()) return false;
    if (cells_.size() != header_size_)
      fail({file_, line_},
           std::to_string(cells_.size()) + " cells, but the header names " + std::to_string(header_size_) + " columns");
    return true;
  }

  /// The number in the column of that index (in the list given at the start). @throws InputError unless it is in its range
  template <class T>
  T number(std::size_t index) const {
    const Column& column = columns_[index];
    const Cell& cell = cells_[*cell_of_[index]];
    return number_in<T>(column.range, cell.text, {file_, line_, cell.column}, "column " + column.name, column.unit);
  }
  /// The same, or nothing if the file has no such column or the cell is empty.
  template <class T>
  std::optional<T> number_if_any(std::size_t index) const {
    if (!cell_of_[index] || cells_[*cell_of_[index]].text.empty()) return {};
    return number<T>(index);
  }

  Place place() const { return {file_, line_}; }

 private:
  struct Cell {
    std::string text;
    std::size_t column;  ///< position of its first character in the line, from 1
  };

  void read_header() {
    if (!next_line()) fail({file_}, "is empty; its first line must name the columns " + listed(names(true)));
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const std::string& name = cells_[i].text;
      const Place place{file_, line_, cells_[i].column};
      const auto column =
          std::find_if(columns_.begin(), columns_.end(), [&](const Column& c) { return c.name == name; });
      if (column == columns_.end()) {
        fail(place, (is_decimal(name) ? "the header is missing: found a number, " : "no such column: ") +
                        in_quotes(name) + "; there are " + listed(names(false)) + ", with commas between them");
      }
      std::optional<std::size_t>& cell = cell_of_[static_cast<std::size_t>(column - columns_.begin())];
      if (cell) fail(place, "column " + name + " is named twice");
      cell = i;
    }
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (columns_[i].required && !cell_of_[i]) fail({file_, line_}, "column " + columns_[i].name + " is missing");
    header_size_ = cells_.size();
  }

  std::vector<std::string> names(bool only_required) const {
    std::vector<std::string> all;
    for (const Column& column : columns_)
      if (column.required || !only_required) all.push_back(column.name);
    return all;
  }

  /// Reads the cells of the next line that is not skipped. False at the end of the file.
  bool next_line() {
    while (position_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', position_), text_.size());
      const std::string line = text_.substr(position_, end - position_);
      position_ = end + 1;
      ++line_;
      const std::size_t first = line.find_first_not_of(blanks);
      if (first == std::string::npos || line[first] == '#') continue;
      split(line);
      return true;
    }
    return false;
  }

  void split(const std::string& line) {
    cells_.clear();
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(',', begin), line.size());
      const std::size_t first = std::min(line.find_first_not_of(blanks, begin), end);
      std::size_t last = end;
      while (last > first && std::string(blanks).find(line[last - 1]) != std::string::npos) --last;
      cells_.push_back({line.substr(first, last - first), first + 1});
      begin = end + 1;
    }
  }

  static constexpr const char* blanks = " \t\r";

  std::string file_;
  std::string text_;
  std::vector<Column> columns_;
  std::vector<std::optional<std::size_t>> cell_of_;  ///< index of each column's cell in a row
  std::size_t header_size_ = 0;
  std::size_t position_ = 0;
  std::size_t line_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace common

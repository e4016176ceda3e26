// SPDX-License-Identifier: MIT
// Numbers that a program computes, beside what a document prints and what a closed form gives: printed as a table, written as
// JSON and CSV.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace common {

/// What a number must be, independent of the program that computes it.
struct Expected {
  double value;
  const char* unit;
  const char* source;  ///< equation of the document, or the closed form
};

struct CheckedNumber {
  std::string id;
  std::optional<double> published;  ///< as the document prints it; none where it prints none
  Expected expected;
  double computed;   ///< by the program
  double tolerance;  ///< on the relative error

  double relative_error() const { return std::abs(computed - expected.value) / std::abs(expected.value); }
  bool pass() const { return relative_error() <= tolerance; }  // false for a NaN
};

using CheckedNumbers = std::vector<CheckedNumber>;

inline std::string with_unit(const std::string& id, const std::string& unit) {
  return unit == "1" ? id : id + " [" + unit + "]";
}

inline void print(const char* title, const CheckedNumbers& numbers) {
  std::printf("\n%-48s %12s %19s %19s  %5s\n", title, "published", "expected", "computed", "error");
  for (const CheckedNumber& number : numbers) {
    char published[32] = "-";
    if (number.published) std::snprintf(published, sizeof published, "%.10g", *number.published);
    const std::string name = with_unit(number.id, number.expected.unit);
    std::printf("%-48s %12s %19.12g %19.12g  %5.0e %s\n", name.c_str(), published, number.expected.value,
                number.computed, number.relative_error(), number.pass() ? "" : "FAILS");
  }
}

inline void write_json(std::ostream& out, const CheckedNumbers& numbers) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const CheckedNumber& number : numbers) {
    list.push_back({{"id", number.id},
                    {"published", number.published ? nlohmann::ordered_json(*number.published) : nullptr},
                    {"expected", number.expected.value},
                    {"source", number.expected.source},
                    {"computed", number.computed},
                    {"relative_error", number.relative_error()},
                    {"tolerance", number.tolerance},
                    {"pass", number.pass()}});
  }
  out << list.dump(1) << '\n';
}

/// The same with units, for a spreadsheet.
inline void write_csv(std::ostream& out, const CheckedNumbers& numbers) {
  out << "id,unit,source,published,expected,computed,relative_error,tolerance,pass\n";
  for (const CheckedNumber& number : numbers) {
    out << number.id << ',' << number.expected.unit << ",\"" << number.expected.source << "\",";
    if (number.published) out << *number.published;
    out << ',' << number.expected.value << ',' << number.computed << ',' << number.relative_error() << ','
        << number.tolerance << ',' << (number.pass() ? "yes" : "no") << '\n';
  }
}

/// A number that a program measures on a random sample, with the band where it must lie.
struct BandedNumber {
  std::string id;
  const char* unit;
  std::optional<double> published;                        ///< as the document prints it; none where it prints none
  double low = -std::numeric_limits<double>::infinity();  ///< at least
  double high = std::numeric_limits<double>::infinity();  ///< at most; without either bound it is shown, not judged
  double computed = std::numeric_limits<double>::quiet_NaN();

  bool pass() const { return low <= computed && computed <= high; }  // false for a NaN
};

using BandedNumbers = std::vector<BandedNumber>;

namespace detail {
inline nlohmann::ordered_json finite_or_null(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
}
}  // namespace detail

inline void print(const char* title, const BandedNumbers& numbers) {
  std::printf("\n%-52s %10s %10s %10s %12s\n", title, "published", "at least", "at most", "computed");
  const auto text = [](double value) {
    char digits[32] = "-";
    if (std::isfinite(value)) std::snprintf(digits, sizeof digits, "%.4g", value);
    return std::string(digits);
  };
  for (const BandedNumber& number : numbers) {
    const std::string name = with_unit(number.id, number.unit);
    std::printf("%-52s %10s %10s %10s %12.5g %s\n", name.c_str(),
                text(number.published.value_or(std::numeric_limits<double>::infinity())).c_str(),
                text(number.low).c_str(), text(number.high).c_str(), number.computed, number.pass() ? "" : "FAILS");
  }
}

inline void write_json(std::ostream& out, const BandedNumbers& numbers) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BandedNumber& number : numbers) {
    list.push_back({{"id", number.id},
                    {"unit", number.unit},
                    {"published", number.published ? nlohmann::ordered_json(*number.published) : nullptr},
                    {"low", detail::finite_or_null(number.low)},
                    {"high", detail::finite_or_null(number.high)},
                    {"computed", number.computed},
                    {"pass", number.pass()}});
  }
  out << list.dump(1) << '\n';
}

inline void write_csv(std::ostream& out, const BandedNumbers& numbers) {
  out << "id,unit,published,low,high,computed,pass\n";
  for (const BandedNumber& number : numbers) {
    out << number.id << ',' << number.unit << ',';
    if (number.published) out << *number.published;
    out << ',';
    if (std::isfinite(number.low)) out << number.low;
    out << ',';
    if (std::isfinite(number.high)) out << number.high;
    out << ',' << number.computed << ',' << (number.pass() ? "yes" : "no") << '\n';
  }
}

/// Prints whether all numbers pass. Returns the exit status: 0 if they do, 1 if not.
template <class Numbers>
int verdict(const Numbers& numbers) {
  const bool all_pass = std::all_of(numbers.begin(), numbers.end(), [](const auto& n) { return n.pass(); });
  std::printf("\n%s\n", all_pass ? "All numbers are right." : "Some numbers are WRONG.");
  return all_pass ? 0 : 1;
}

}  // namespace common

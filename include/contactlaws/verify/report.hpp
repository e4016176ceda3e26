// SPDX-License-Identifier: MIT
// One result for each property, as data and as a table.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <ostream>
#include <string>
#include <vector>

#include "contactlaws/verify/path.hpp"

namespace contactlaws::verify {

/// What a check says.
enum class Verdict {
  pass,
  fail,
  not_claimed,  ///< the law does not claim the property (Claims)
  not_offered   ///< the law does not return what the property compares (force_update.hpp)
};

/// The error of a law, and the largest one allowed.
struct Finding {
  double error = 0.0;    ///< the largest so far
  double allowed = 0.0;  ///< the largest that passes

  /// Keeps the larger error; a NaN is kept whatever follows. Whether the new one was kept.
  bool add(double other) {
    using std::isnan;
    if (other <= error || isnan(error)) return false;
    error = other;
    return true;
  }
  /// Whether the error is too large.
  bool failed() const { return !(error <= allowed); }  // a NaN fails
};

struct Result {
  std::string property;             ///< its name
  Verdict verdict = Verdict::pass;  ///< of the check
  Finding worst{};                  ///< of all paths
  std::string measure{};            ///< what the error is relative to
  Path path{};         ///< of a failure: reduced to the steps that still show at least a tenth of the worst error
  std::string file{};  ///< where the path was written, if it was
};

struct Report {
  std::uint64_t seed = 0;         ///< of the random paths
  std::vector<Result> results{};  ///< one a property

  /// Whether no property failed.
  bool passed() const {
    return std::none_of(results.begin(), results.end(), [](const Result& r) { return r.verdict == Verdict::fail; });
  }
  /// The result of that property, or null.
  const Result* find(const std::string& property) const {
    const auto it =
        std::find_if(results.begin(), results.end(), [&](const Result& r) { return r.property == property; });
    return it == results.end() ? nullptr : &*it;
  }
};

/// A line a property.
inline std::ostream& operator<<(std::ostream& out, const Report& report) {
  const auto digits = out.precision(2);
  for (const Result& r : report.results) {
    out << "  " << std::left << std::setw(24) << r.property;
    if (r.verdict == Verdict::not_claimed || r.verdict == Verdict::not_offered) {
      out << (r.verdict == Verdict::not_claimed ? "-     not claimed" : "-     not offered") << '\n';
      continue;
    }
    out << (r.verdict == Verdict::pass ? "pass  " : "FAIL  ") << std::setw(8) << r.worst.error << " (allowed "
        << r.worst.allowed << ") " << r.measure;
    if (r.verdict == Verdict::fail) {
      out << "; in " << r.path.size() << (r.path.size() == 1 ? " step" : " steps");
      if (!r.file.empty()) out << ": " << r.file;
    }
    out << '\n';
  }
  const auto count = [&report](Verdict verdict) {
    return std::count_if(report.results.begin(), report.results.end(),
                         [verdict](const Result& r) { return r.verdict == verdict; });
  };
  out << "  " << count(Verdict::pass) << " pass, " << count(Verdict::fail) << " fail, " << count(Verdict::not_claimed)
      << " not claimed, " << count(Verdict::not_offered) << " not offered; seed " << report.seed << '\n';
  out.precision(digits);
  return out;
}

}  // namespace contactlaws::verify

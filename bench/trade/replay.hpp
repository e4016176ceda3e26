// SPDX-License-Identifier: MIT
// The cheapest composition whose forces stay within the tolerance on a recorded motion.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "common/output_file.hpp"
#include "common/progress.hpp"
#include "contact_path/law_file.hpp"
#include "features.hpp"
#include "measure.hpp"
#include "recording_file.hpp"

namespace trade {

/// @throws InputError also for a law that is not measured here
inline LawSpec read_measured_law(const std::string& file) {
  LawSpec law = contact_path::read_law(file);
  check_measured(law);
  return law;
}

struct Candidate {
  Composition composition;
  Errors errors;
  std::size_t bytes;
  double ns;             ///< NaN until it is timed
  bool closely = false;  ///< timed with all repetitions, not quickly
};

class Replay {
 public:
  Replay(const std::string& recording, const std::string& law_file, double tolerance, int repetitions)
      : law_(read_measured_law(law_file)),
        motion_(read_recording(recording)),
        tolerance_(tolerance),
        repetitions_(repetitions) {}

  /// 0, or 1 if no composition is within the tolerance. Writes replay.csv into `directory`, if one is named.
  int run(std::ostream& out, const std::string& directory) {
    {
      common::Progress progress("replay");
      reference_ = solve(law_, motion_, [&progress](double done) { progress.at(0.4 * done); });
      compare_all([&progress](double done) { progress.at(0.4 + 0.2 * done); });
      choose([&progress](double done) { progress.at(0.6 + 0.4 * done); });
    }
    print(out);
    if (!directory.empty()) write_table(directory);
    return cheapest_ != nullptr ? 0 : 1;
  }

 private:
  const LawSpec law_;
  const Trajectories motion_;
  const double tolerance_;
  const int repetitions_;
  Reference reference_;
  std::vector<Candidate> candidates_;  // the full law in double first
  const Candidate* cheapest_ = nullptr;

  Candidate candidate(const Composition& c) const {
    const auto run = make_run(c, motion_);
    if (!run) fail(law_.normal.place, "this build of trade leaves out " + describe(c));
    return {c, compare(*run, motion_, reference_, motion_), run->state_bytes(),
            std::numeric_limits<double>::quiet_NaN()};
  }
  void time_quickly(Candidate& c) const { c.ns = nanoseconds(*make_run(c.composition, motion_), motion_, 3, 2e-4); }
  void time_closely(Candidate& c) const {
    c.ns = nanoseconds(*make_run(c.composition, motion_), motion_, repetitions_, 2e-3);
    c.closely = true;
  }
  bool within(const Candidate& c) const { return c.errors.largest <= tolerance_; }  // false for a NaN

  template <class Progress>
  void compare_all(const Progress& progress) {
    const std::vector<Composition> all = simplifications(law_);
    for (const Composition& c : all) {
      candidates_.push_back(candidate(c));
      progress(double(candidates_.size()) / double(all.size()));
    }
  }

  /// Times all that are within the tolerance quickly, then the fastest closely.
  template <class Progress>
  void choose(const Progress& progress) {
    std::vector<Candidate*> accurate;
    for (Candidate& c : candidates_)
      if (within(c)) accurate.push_back(&c);
    const double parts = double(accurate.size() + 1);
    for (std::size_t i = 0; i < accurate.size(); ++i) {
      time_quickly(*accurate[i]);
      progress(0.5 * double(i) / parts);
    }
    std::sort(accurate.begin(), accurate.end(), [](const Candidate* a, const Candidate* b) { return a->ns < b->ns; });
    constexpr std::size_t finalists = 8;
    if (accurate.size() > finalists) accurate.resize(finalists);
    for (Candidate* c : accurate) time_closely(*c);
    if (!candidates_.front().closely) time_closely(candidates_.front());
    progress(1.0);
    if (accurate.empty()) return;

    // Times within 3 % count as equal: fewest bytes first, then the smallest error.
    constexpr double same = 1.03;
    const auto by_time = [](const Candidate* a, const Candidate* b) { return a->ns < b->ns; };
    const double fastest = (*std::min_element(accurate.begin(), accurate.end(), by_time))->ns;
    for (const Candidate* c : accurate) {
      if (c->ns > same * fastest) continue;
      const auto rank = [](const Candidate& x) { return std::pair(x.bytes, x.errors.largest); };
      if (cheapest_ == nullptr || rank(*c) < rank(*cheapest_)) cheapest_ = c;
    }
  }

  /// Every composition that was tried. @throws InputError naming the file that cannot be written
  void write_table(const std::string& directory) const {
    std::filesystem::create_directories(directory);
    common::OutputFile csv(directory + "/replay.csv");
    csv.stream() << "composition,ns,timed,state_bytes,largest_error,rms_error,energy_error,within_tolerance,chosen\n";
    csv.stream().precision(6);
    for (const Candidate& c : candidates_) {
      csv.stream() << '"' << describe(c.composition) << "\",";
      if (!std::isnan(c.ns)) csv.stream() << c.ns;
      csv.stream() << ','
                   << (std::isnan(c.ns) ? "no"
                       : c.closely      ? "closely"
                                        : "quickly")
                   << ',' << c.bytes << ',' << c.errors.largest << ',' << c.errors.rms << ',' << c.errors.energy << ','
                   << (within(c) ? "yes" : "no") << ',' << (&c == cheapest_ ? "yes" : "no") << '\n';
    }
    csv.complete();
  }

  static std::string line(const char* what, const Candidate& c) {
    char text[64];
    std::snprintf(text, sizeof text, "%-9s %6.1f ns %4zu bytes   error %8.1e   ", what, c.ns, c.bytes,
                  c.errors.largest);
    return text + describe(c.composition) + '\n';
  }

  void print(std::ostream& out) {
    using detail::number;
    const Use use = use_of(motion_, reference_);
    const Candidate& full = candidates_.front();
    if (use.touching == 0)
      common::note({motion_.name}, "no contact touches in any row: overlap is > 0 in contact, < 0 across a gap");
    out << motion_.name << ": " << motion_.contacts() << " contacts, " << motion_.rows() << " rows, largest force "
        << number(use.largest_force) << " N\n\n"
        << line("fullest", full);
    if (cheapest_ != nullptr) {
      const Candidate& best = *cheapest_;
      const double ns = full.ns - best.ns;
      out << line("cheapest", best) << "saves " << number(std::max(ns, 0.0), "%.1f") << " ns ("
          << number(std::max(100.0 * ns / full.ns, 0.0), "%.0f") << " %) and "
          << (full.bytes > best.bytes ? full.bytes - best.bytes : 0)
          << " bytes a contact and step, within a tolerance of " << number(tolerance_) << '\n';
    } else {
      out << "No composition is within " << number(tolerance_) << " of these forces: rounding alone is more.\n";
    }

    out << "\nerror of one change alone:\n";
    const auto changed = [&](const std::string& what, const Composition& composition) {
      const Candidate c = candidate(composition);
      char text[96];
      std::snprintf(text, sizeof text, "  %-28s %8.1e   %s\n", what.c_str(), c.errors.largest,
                    within(c) ? "within the tolerance" : "too large");
      out << text;
    };
    if (law_.bridge.acts()) changed("no bridge", {without(law_, &LawSpec::bridge)});
    if (law_.damping.acts()) changed("no dashpots", {without(law_, &LawSpec::damping)});
    if (law_.shear.acts()) changed("no shear", {without(law_, &LawSpec::shear)});
    for (const LawSpec& other : other_rotations(law_)) changed("rotation: " + other.shear.word("rotation"), {other});
    for (const LawSpec& other : other_normals(law_)) changed("normal: " + other.normal.law, {other});
    changed("law in float", {law_, Precision::law_in_float});

    const Findings found = findings(use, law_, tolerance_);
    const auto list = [&out](const char* title, const std::vector<std::string>& sentences) {
      if (sentences.empty()) return;
      out << '\n' << title << '\n';
      for (const std::string& sentence : sentences) out << "  " << sentence << '\n';
    };
    list("never used:", found.unused);
    list("used:", found.used);
  }
};

/// @throws InputError naming file, line and column
inline int replay(const std::string& recording, const std::string& law, double tolerance, int repetitions,
                  std::ostream& out, const std::string& directory) {
  return Replay(recording, law, tolerance, repetitions).run(out, directory);
}

}  // namespace trade

// SPDX-License-Identifier: MIT
// Model only what a scene requires: the cheapest composition that keeps a recorded scene's forces.
#pragma once

#include <cstdio>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "../../examples/dem/progress.hpp"
#include "description.hpp"
#include "features.hpp"
#include "measure.hpp"
#include "recording_file.hpp"

namespace trade {

struct Candidate {
  Composition composition;
  Errors errors;
  std::size_t bytes;
  double ns;  ///< NaN until it is timed
};

class Replay {
 public:
  Replay(const std::string& recording, const std::string& law_file, double tolerance, int repetitions)
      : law_(contact_path::read_law(law_file)),
        full_(composition_of(law_)),
        parameters_(parameters_of(law_)),
        scene_(read_recording(recording)),
        tolerance_(tolerance),
        repetitions_(repetitions) {}

  /// 0, or 1 if nothing keeps the tolerance.
  int run(std::ostream& out) {
    {
      dem::Progress progress("replay");
      reference_ = solve(law_, scene_, [&progress](double done) { progress.at(0.4 * done); });
      judge([&progress](double done) { progress.at(0.4 + 0.2 * done); });
      choose([&progress](double done) { progress.at(0.6 + 0.4 * done); });
    }
    tell(out);
    return cheapest_ ? 0 : 1;
  }

 private:
  const LawDescription law_;
  const Composition full_;
  const Parameters parameters_;
  const Scene scene_;
  const double tolerance_;
  const int repetitions_;
  Reference reference_;
  std::vector<Candidate> candidates_;  // the full composition first
  std::optional<Candidate> cheapest_;

  Candidate candidate(const Composition& c) const {
    const auto run = make_run(c, parameters_, scene_);
    return {c, compare(*run, scene_, reference_, scene_), run->state_bytes(), std::numeric_limits<double>::quiet_NaN()};
  }
  void time(Candidate& c, int repetitions, double least) const {
    c.ns = nanoseconds(*make_run(c.composition, parameters_, scene_), scene_, repetitions, least);
  }
  bool keeps(const Candidate& c) const { return c.errors.largest <= tolerance_; }  // false for a NaN

  template <class Progress>
  void judge(const Progress& progress) {
    const std::vector<Composition> all = simplifications(full_);
    for (const Composition& c : all) {
      candidates_.push_back(candidate(c));
      progress(double(candidates_.size()) / double(all.size()));
    }
  }

  /// A glance at all that keep the tolerance, then a close look at the best.
  template <class Progress>
  void choose(const Progress& progress) {
    std::vector<Candidate> kept;
    for (const Candidate& c : candidates_)
      if (keeps(c)) kept.push_back(c);
    const double parts = double(kept.size() + 1);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      time(kept[i], 3, 2e-4);
      progress(0.5 * double(i) / parts);
    }
    std::sort(kept.begin(), kept.end(), [](const Candidate& a, const Candidate& b) { return a.ns < b.ns; });
    constexpr std::size_t closely = 8;
    if (kept.size() > closely) kept.resize(closely);
    for (Candidate& c : kept) {
      time(c, repetitions_, 2e-3);
      // What differs by less than clocks tell goes by its bytes, then by its error.
      constexpr double same = 0.03;
      const auto better = [](const Candidate& a, const Candidate& b) {
        if (std::abs(a.ns - b.ns) > same * b.ns) return a.ns < b.ns;
        if (a.bytes != b.bytes) return a.bytes < b.bytes;
        return a.errors.largest < b.errors.largest;
      };
      if (!cheapest_ || better(c, *cheapest_)) cheapest_ = c;
    }
    time(candidates_.front(), repetitions_, 2e-3);
    progress(1.0);
  }

  static std::string line(const char* what, const Candidate& c) {
    char text[64];
    std::snprintf(text, sizeof text, "%-9s %6.1f ns %4zu bytes   error %8.1e   ", what, c.ns, c.bytes,
                  c.errors.largest);
    return text + describe(c.composition) + '\n';
  }

  void tell(std::ostream& out) {
    using detail::number;
    const Use use = use_of(scene_, reference_);
    Candidate& full = candidates_.front();
    out << scene_.name << ": " << scene_.contacts() << " contacts, " << scene_.rows() << " rows, largest force "
        << number(use.largest_force) << " N\n\n"
        << line("fullest", full);
    if (cheapest_) {
      const Candidate& best = *cheapest_;
      const double ns = full.ns - best.ns;
      out << line("cheapest", best) << "saves " << number(std::max(ns, 0.0), "%.1f") << " ns ("
          << number(std::max(100.0 * ns / full.ns, 0.0), "%.0f") << " %) and "
          << (full.bytes > best.bytes ? full.bytes - best.bytes : 0)
          << " bytes a contact and step, within a tolerance of " << number(tolerance_) << '\n';
    } else {
      out << "No composition keeps these forces within " << number(tolerance_) << ": rounding alone is more.\n";
    }

    out << "\nleft out alone:\n";
    const auto without = [&](const char* what, auto change) {
      Composition less = full_;
      change(less);
      const Candidate c = candidate(less);
      char text[64];
      std::snprintf(text, sizeof text, "  %-24s error %8.1e   %s\n", what, c.errors.largest,
                    keeps(c) ? "kept" : "too much");
      out << text;
    };
    if (full_.bridge) without("no bridge", [](Composition& c) { c.bridge = false; });
    if (full_.damping != Damping::none) without("no dashpots", [](Composition& c) { c.damping = Damping::none; });
    if (full_.history != History::none) {
      without("no shear", [](Composition& c) { c.history = History::none; });
      for (const Carrying k : {Carrying::project, Carrying::project_restore})
        if (full_.carrying != k && !(full_.carrying == Carrying::project)) {
          const std::string what = std::string("carrying: ") + name(k);
          without(what.c_str(), [k](Composition& c) { c.carrying = k; });
        }
    }
    if (full_.is_rough()) without("smooth", [](Composition& c) { c.normal = NormalForm::hertz; });
    without("law in float", [](Composition& c) { c.precision = Precision::law_in_float; });

    const Findings found = findings(use, full_, parameters_, tolerance_);
    const auto list = [&out](const char* title, const std::vector<std::string>& sentences) {
      if (sentences.empty()) return;
      out << '\n' << title << '\n';
      for (const std::string& sentence : sentences) out << "  " << sentence << '\n';
    };
    list("never used:", found.unused);
    list("used:", found.used);
  }
};

/// @throws contact_path::InputError naming file, line and column
inline int replay(const std::string& recording, const std::string& law, double tolerance, int repetitions,
                  std::ostream& out) {
  return Replay(recording, law, tolerance, repetitions).run(out);
}

}  // namespace trade

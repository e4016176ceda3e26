// SPDX-License-Identifier: MIT
// Model only what a scene requires: the cheapest composition that keeps a recorded scene's forces.
#pragma once

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "../../examples/common/output_file.hpp"
#include "../../examples/common/progress.hpp"
#include "description.hpp"
#include "features.hpp"
#include "measure.hpp"
#include "recording_file.hpp"

namespace trade {

struct Candidate {
  Composition composition;
  Errors errors;
  std::size_t bytes;
  double ns;             ///< NaN until it is timed
  bool closely = false;  ///< timed with all repetitions, not at a glance
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

  /// 0, or 1 if nothing keeps the tolerance. Into `directory`, if one is named: replay.csv.
  int run(std::ostream& out, const std::string& directory) {
    {
      common::Progress progress("replay");
      reference_ = solve(law_, scene_, [&progress](double done) { progress.at(0.4 * done); });
      judge([&progress](double done) { progress.at(0.4 + 0.2 * done); });
      choose([&progress](double done) { progress.at(0.6 + 0.4 * done); });
    }
    tell(out);
    if (!directory.empty()) write_table(directory);
    return cheapest_ != nullptr ? 0 : 1;
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
  const Candidate* cheapest_ = nullptr;

  Candidate candidate(const Composition& c) const {
    const auto run = make_run(c, parameters_, scene_);
    if (!run) contact_path::fail(law_.normal.place, "this build of trade leaves out " + describe(c));
    return {c, compare(*run, scene_, reference_, scene_), run->state_bytes(), std::numeric_limits<double>::quiet_NaN()};
  }
  void glance(Candidate& c) const {
    c.ns = nanoseconds(*make_run(c.composition, parameters_, scene_), scene_, 3, 2e-4);
  }
  void look_closely(Candidate& c) const {
    c.ns = nanoseconds(*make_run(c.composition, parameters_, scene_), scene_, repetitions_, 2e-3);
    c.closely = true;
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

  /// A glance at all that keep the tolerance, then a close look at the fastest.
  template <class Progress>
  void choose(const Progress& progress) {
    std::vector<Candidate*> kept;
    for (Candidate& c : candidates_)
      if (keeps(c)) kept.push_back(&c);
    const double parts = double(kept.size() + 1);
    for (std::size_t i = 0; i < kept.size(); ++i) {
      glance(*kept[i]);
      progress(0.5 * double(i) / parts);
    }
    std::sort(kept.begin(), kept.end(), [](const Candidate* a, const Candidate* b) { return a->ns < b->ns; });
    constexpr std::size_t finalists = 8;
    if (kept.size() > finalists) kept.resize(finalists);
    for (Candidate* c : kept) look_closely(*c);
    if (!candidates_.front().closely) look_closely(candidates_.front());
    progress(1.0);
    if (kept.empty()) return;

    // What differs by less than clocks tell goes by its bytes, then by its error.
    constexpr double same = 1.03;
    const auto by_time = [](const Candidate* a, const Candidate* b) { return a->ns < b->ns; };
    const double fastest = (*std::min_element(kept.begin(), kept.end(), by_time))->ns;
    for (const Candidate* c : kept) {
      if (c->ns > same * fastest) continue;
      const auto rank = [](const Candidate& x) { return std::pair(x.bytes, x.errors.largest); };
      if (cheapest_ == nullptr || rank(*c) < rank(*cheapest_)) cheapest_ = c;
    }
  }

  /// Every composition that was tried. @throws contact_path::InputError naming the file that cannot be written
  void write_table(const std::string& directory) const {
    std::filesystem::create_directories(directory);
    common::OutputFile csv(directory + "/replay.csv");
    csv.stream() << "composition,ns,timed,state_bytes,largest_error,rms_error,energy_error,kept,chosen\n";
    csv.stream().precision(6);
    for (const Candidate& c : candidates_) {
      csv.stream() << '"' << describe(c.composition) << "\",";
      if (!std::isnan(c.ns)) csv.stream() << c.ns;
      csv.stream() << ','
                   << (std::isnan(c.ns) ? "no"
                       : c.closely      ? "closely"
                                        : "at a glance")
                   << ',' << c.bytes << ',' << c.errors.largest << ',' << c.errors.rms << ',' << c.errors.energy << ','
                   << (keeps(c) ? "yes" : "no") << ',' << (&c == cheapest_ ? "yes" : "no") << '\n';
    }
    csv.complete();
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
    const Candidate& full = candidates_.front();
    out << scene_.name << ": " << scene_.contacts() << " contacts, " << scene_.rows() << " rows, largest force "
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
                  std::ostream& out, const std::string& directory) {
  return Replay(recording, law, tolerance, repetitions).run(out, directory);
}

}  // namespace trade

// SPDX-License-Identifier: MIT
// The contact of railway ballast, with the parameters of Tolomeo & McDowell (2022), Table 1: the curves of their Figures 1
// and 2, and the error and the cost of their increments beside the closed form.
//
//   contact_curves [FOLDER]      writes ballast.json, ballast.csv and the curves (default: build/results)
//
// Exit status: 0 if every number is right, 1 if one is not, 2 on a fault, 130 after Ctrl-C. After a fault or Ctrl-C the files
// of an earlier run are unchanged.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/machine.hpp"
#include "common/output_file.hpp"
#include "common/program.hpp"
#include "common/progress.hpp"
#include "common/report.hpp"
#include "common/table.hpp"
#include "contactlaws/contactlaws.hpp"
#include "expected.hpp"
#include "pohrt_popov_incremental.hpp"

namespace {

using namespace contactlaws;
using common::Table;
namespace expected = ballast::expected;

using Elastic = PohrtPopov<double>;
using Plastic = PohrtPopovElastoPlastic<double>;
using Increments = PohrtPopovIncremental<double>;

// Table 1; R* = 2.36 mm is that of two equal spheres. The density has no influence here.
const RoughSurface<double> surface{2.13, 26.1e-6};
const ElasticMaterial<double> granite{60e9, 0.25, 2700.0};
const PairProperties<double> pair = pair_properties(sphere(granite, 4.72e-3), sphere(granite, 4.72e-3));

template <class Law>
NormalResponse<double> virgin(const Law& law, double overlap) {
  typename Law::State state;
  return law.respond(state, pair, overlap);
}

common::CheckedNumbers checked_numbers() {
  const Elastic law = Elastic::of(surface);
  const Plastic plastic = Plastic::of(surface);
  const HertzResponse<double> transition = hertz_response(pair, law.transition_indentation());
  Plastic::State after_20um;
  plastic.respond(after_20um, pair, 20e-6);

  common::CheckedNumbers numbers;
  // Tolerance: a few roundings of 1e-16 each, and a rounded exponent.
  const auto add = [&numbers](const char* id, std::optional<double> published, const common::Expected& exact,
                              double computed) {
    numbers.push_back({std::string("contact_curves.") + id, published, exact, computed, 1e-12});
  };
  add("full_contact_area", 6.68e-7, expected::full_contact_area, surface.full_contact_area(pair.effective_radius));
  add("transition_force", 1775.0, expected::transition_force, transition.force);
  add("transition_stiffness", {}, expected::transition_stiffness, transition.stiffness);
  add("transition_overlap", {}, expected::transition_overlap, law.transition_overlap);
  add("virgin_force_1um", {}, expected::virgin_force_1um, virgin(law, 1e-6).force);
  add("virgin_force_5um", {}, expected::virgin_force_5um, virgin(law, 5e-6).force);
  add("virgin_force_10um", {}, expected::virgin_force_10um, virgin(law, 10e-6).force);
  add("virgin_force_20um", {}, expected::virgin_force_20um, virgin(law, 20e-6).force);
  add("virgin_force_30um", {}, expected::virgin_force_30um, virgin(law, 30e-6).force);
  add("plastic_overlap_after_20um", {}, expected::plastic_overlap_after_20um, plastic.plastic_overlap(after_20um));
  add("exponent", {}, expected::exponent, surface.stiffness_exponent());
  add("shear_ratio", {}, expected::shear_ratio, mindlin_ratio(pair));
  return numbers;
}

/// Figure 1: force and stiffness of both laws.
void write_curves(common::OutputFolder& folder) {
  const Elastic rough = Elastic::of(surface);
  Table table({"overlap_m", "hertz_force_N", "hertz_stiffness_N_per_m", "rough_force_N", "rough_stiffness_N_per_m"});
  for (int i = 0; i <= 800; ++i) {
    const double overlap = i * 0.25e-6;
    const HertzResponse<double> hertz = hertz_response(pair, overlap);
    const NormalResponse<double> response = virgin(rough, overlap);
    table.add({overlap, hertz.force, hertz.stiffness, response.force, response.stiffness});
  }
  table.write_csv(folder.file("ballast_curves.csv"));
}

/// Figure 2: loaded to 20 um, unloaded, loaded to 25 um and unloaded again, in steps of 1/50 um.
void write_cycle(common::OutputFolder& folder) {
  const Plastic law = Plastic::of(surface);
  Plastic::State state;
  Table table({"overlap_m", "force_N", "loading"});  // 0 open, 1 virgin, 2 unloading, 3 reloading
  int place = 0;
  for (const int turn : {1000, 700, 1250, 700}) {
    const int direction = turn > place ? 1 : -1;
    for (; place != turn; place += direction) {
      const double overlap = place * 0.02e-6;
      const Loading loading = law.loading(state, overlap, -direction);
      table.add({overlap, law.respond(state, pair, overlap).force, static_cast<double>(loading)});
    }
  }
  table.write_csv(folder.file("ballast_cycle.csv"));
}

/// The force after moving from one overlap to another in equal steps.
template <class Law>
double move(const Law& law, typename Law::State& state, double from, double to, int steps) {
  double force = 0.0;
  for (int i = 1; i <= steps; ++i) force = law.respond(state, pair, from + (to - from) * i / steps).force;
  return force;
}

/// ns per step along a loading to 10 um: the median of 15 runs.
template <class Law>
double cost(const Law& law) {
  constexpr int steps = 20000;
  std::vector<double> runs;
  double sum = 0.0;
  for (int run = 0; run < 15; ++run) {
    typename Law::State state{};
    const auto start = std::chrono::steady_clock::now();
    sum += move(law, state, 0.0, 10e-6, steps);
    runs.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() / steps);
  }
  std::nth_element(runs.begin(), runs.begin() + 7, runs.end());
  return sum >= 0.0 ? runs[7] : 0.0;  // the sum is used, so the compiler keeps the loop
}

/// What a loading to 10 um costs and misses, by the number of steps.
struct StepErrors {
  std::string name;
  double ns_per_step;
  std::vector<std::pair<int, double>> error;  ///< number of steps; relative error of the force
};

template <class Law>
StepErrors step_errors(const std::string& name, const Law& law) {
  StepErrors result{name, cost(law), {}};
  for (int decade = 10; decade <= 1000000; decade *= 10) {
    for (const int steps : {decade, 2 * decade, 5 * decade}) {
      if (steps > 1000000) break;
      common::stop_if_requested();
      typename Law::State state{};
      result.error.emplace_back(steps, move(law, state, 0.0, 10e-6, steps) / expected::virgin_force_10um.value - 1.0);
    }
  }
  return result;
}

/// Error of the force at 10 um, by the number of steps to it, and the cost of a step: the closed form, then the increments.
template <class Done>
std::vector<StepErrors> write_trade(common::OutputFolder& folder, const Done& done) {
  std::vector<StepErrors> all{step_errors("closed form", Plastic::of(surface))};
  Table closed({"relative_error", "ns_per_step"});
  closed.add({all[0].error.front().second, all[0].ns_per_step});
  closed.write_csv(folder.file("ballast_trade_closed.csv"));

  Table increments({"seed_N", "steps", "relative_error", "ns_per_step"});
  for (const double seed : {0.0, 1e-12, 1e-6, 1e-3}) {
    char name[32];
    std::snprintf(name, sizeof name, "seed %g N", seed);
    all.push_back(step_errors(name, Increments::of(surface, seed)));
    for (const auto& [steps, error] : all.back().error)
      increments.add({seed, static_cast<double>(steps), error, all.back().ns_per_step});
    done(static_cast<double>(all.size()) / 5.0);
  }
  increments.write_csv(folder.file("ballast_trade_increments.csv"));
  folder.file("ballast_trade_machine.json") << common::machine().dump(1) << '\n';
  return all;
}

void print(const std::vector<StepErrors>& all) {
  std::printf("\nForce at 10 um: relative error, by the number of steps from 0\n%-18s %9s", "", "ns/step");
  for (int steps = 10; steps <= 1000000; steps *= 10) std::printf(" %9d", steps);
  for (const StepErrors& one : all) {
    std::printf("\n%-18s %9.1f", one.name.c_str(), one.ns_per_step);
    for (std::size_t i = 0; i < one.error.size(); i += 3) std::printf(" %9.1e", one.error[i].second);
  }
  std::printf("\n");
}

/// Peak forces at 20 um [N]: closed form, bodies separated in each cycle; increments, likewise; increments, unloaded to 1 N.
using Peaks = std::array<double, 3>;

/// A million cycles up to 20 um. One pair of bodies separates in each cycle, another is unloaded to 1 N, as in the
/// experiments that the paper cites. Increments take 25 steps up and 25 down; the closed form takes one. Returns the peaks of
/// the first and the last cycle.
template <class Done>
std::pair<Peaks, Peaks> write_ratchet(common::OutputFolder& folder, const Done& done) {
  const Plastic closed = Plastic::of(surface);
  const Increments increments = Increments::of(surface, 1e-12);
  Plastic::State closed_apart, loaded;
  Increments::State apart, held;
  constexpr double peak = 20e-6;
  closed.respond(loaded, pair, peak);
  const double reopening = closed.plastic_overlap(loaded);
  const double share = 1.0 / expected::virgin_force_20um.value;  // 1 N over the peak force
  const double at_1N = reopening + (peak - reopening) * std::cbrt(share * share);

  Table table({"cycle", "closed_apart_N", "increments_apart_N", "increments_held_N"});
  Peaks first{}, last{};
  constexpr long cycles = 1000000;
  long next = 1;
  for (long cycle = 1; cycle <= cycles; ++cycle) {
    common::stop_if_requested();
    constexpr int steps = 25;
    last = {move(closed, closed_apart, 0.0, peak, 1), move(increments, apart, 0.0, peak, steps),
            move(increments, held, cycle == 1 ? 0.0 : at_1N, peak, steps)};
    if (cycle == 1) first = last;
    if (cycle == next || cycle == cycles) {
      table.add({static_cast<double>(cycle), last[0], last[1], last[2]});
      next = std::max(next + 1, next * 11 / 10);
    }
    move(closed, closed_apart, peak, 0.0, 1);
    move(increments, apart, peak, 0.0, steps);
    move(increments, held, peak, at_1N, steps);
    if (cycle % 1000 == 0) done(static_cast<double>(cycle) / cycles);
  }
  table.write_csv(folder.file("ballast_ratchet.csv"));
  return {first, last};
}

void print(const std::pair<Peaks, Peaks>& peaks) {
  std::printf("\nPeak force at 20 um in the first and the millionth cycle [N]\n");
  const char* names[] = {"closed form, separated", "increments, separated", "increments, down to 1 N"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double first = peaks.first[i], last = peaks.second[i];
    std::printf("%-28s %.17g  %.17g  (%+.2g)\n", names[i], first, last, last / first - 1.0);
  }
}

int run(const std::string& directory) {
  const common::InterruptGuard guard;
  common::OutputFolder folder(directory);
  const common::CheckedNumbers numbers = checked_numbers();
  write_json(folder.file("ballast.json"), numbers);
  write_csv(folder.file("ballast.csv"), numbers);
  write_curves(folder);
  write_cycle(folder);
  std::vector<StepErrors> trade;
  std::pair<Peaks, Peaks> peaks;
  {
    common::Progress progress("ballast");
    trade = write_trade(folder, [&progress](double done) { progress.at(0.2 * done); });
    peaks = write_ratchet(folder, [&progress](double done) { progress.at(0.2 + 0.8 * done); });
  }
  folder.complete();
  print("Ballast (Tolomeo & McDowell 2022)", numbers);
  print(trade);
  print(peaks);
  return verdict(numbers);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Computes the contact curves of railway ballast (Tolomeo & McDowell 2022).", "contact_curves");
  std::string directory = "build/results";
  app.add_option("FOLDER", directory, "where to write the results (default: build/results)");
  return common::run_program(app, argc, argv, [&directory] { return run(directory); });
}

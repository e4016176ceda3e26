// SPDX-License-Identifier: MIT
// The contact of railway ballast, by the parameters of Tolomeo & McDowell (2022), Table 1: the curves of their Figures 1
// and 2, and what their increments cost and miss beside the closed form.
//
//   contact_curves [directory]      writes ballast.json, ballast.csv and the curves there (default: build/results)
//
// Ends with 0 if every number is right, 1 if one is not, 2 on a fault.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "../memo/report.hpp"
#include "contactlaws/contactlaws.hpp"
#include "expected.hpp"
#include "pohrt_popov_incremental.hpp"

namespace {

using namespace contactlaws;
namespace expected = ballast::expected;

using Elastic = PohrtPopov<double>;
using Plastic = PohrtPopovElastoPlastic<double>;
using PlasticFast = PohrtPopovElastoPlastic<double, Recontact::same_spot, Power::fast>;
using Increments = PohrtPopovIncremental<double>;

// Table 1; R* = 2.36 mm is that of two equal spheres. The density matters to nothing here.
const RoughSurface<double> surface{2.13, 26.1e-6};
const ElasticMaterial<double> granite{60e9, 0.25, 2700.0};
const PairProperties<double> pair = pair_properties(sphere(granite, 4.72e-3), sphere(granite, 4.72e-3));

template <class Law>
NormalResponse<double> virgin(const Law& law, double overlap) {
  typename Law::State state;
  return law.respond(state, pair, overlap);
}

memo::Rows numbers() {
  const Elastic law = Elastic::of(surface);
  const Plastic plastic = Plastic::of(surface);
  const HertzResponse<double> transition = hertz_response(pair, law.transition_indentation());
  Plastic::State after_20um;
  plastic.respond(after_20um, pair, 20e-6);

  memo::Rows rows;
  // A few roundings of 1e-16 each, and an exponent that is itself rounded.
  const auto add = [&rows](const char* id, const char* unit, std::optional<double> published, double exact,
                           double computed) {
    rows.push_back({std::string("contact_curves.") + id, unit, published, exact, computed, 1e-12});
  };
  add("full_contact_area", "m^2", 6.68e-7, expected::full_contact_area,
      surface.full_contact_area(pair.effective_radius));
  add("transition_force", "N", 1775.0, expected::transition_force, transition.force);
  add("transition_stiffness", "N/m", {}, expected::transition_stiffness, transition.stiffness);
  add("transition_overlap", "m", {}, expected::transition_overlap, law.transition_overlap);
  add("virgin_force_1um", "N", {}, expected::virgin_force_1um, virgin(law, 1e-6).force);
  add("virgin_force_5um", "N", {}, expected::virgin_force_5um, virgin(law, 5e-6).force);
  add("virgin_force_10um", "N", {}, expected::virgin_force_10um, virgin(law, 10e-6).force);
  add("virgin_force_20um", "N", {}, expected::virgin_force_20um, virgin(law, 20e-6).force);
  add("virgin_force_30um", "N", {}, expected::virgin_force_30um, virgin(law, 30e-6).force);
  add("plastic_overlap_after_20um", "m", {}, expected::plastic_overlap_after_20um, plastic.plastic_overlap(after_20um));
  add("exponent", "1", {}, expected::exponent, surface.stiffness_exponent());
  add("shear_ratio", "1", {}, expected::shear_ratio, mindlin_ratio(pair));
  return rows;
}

/// Figure 1: force and stiffness of both laws.
void write_curves(const std::string& directory) {
  const Elastic rough = Elastic::of(surface);
  dem::Table table(
      {"overlap_m", "hertz_force_N", "hertz_stiffness_N_per_m", "rough_force_N", "rough_stiffness_N_per_m"});
  for (int i = 0; i <= 800; ++i) {
    const double overlap = i * 0.25e-6;
    const HertzResponse<double> hertz = hertz_response(pair, overlap);
    const NormalResponse<double> response = virgin(rough, overlap);
    table.add({overlap, hertz.force, hertz.stiffness, response.force, response.stiffness});
  }
  table.write_csv(directory + "/ballast_curves.csv");
}

/// Figure 2: loaded to 20 um, unloaded, loaded to 25 um and unloaded again, in steps of 1/50 um.
void write_cycle(const std::string& directory) {
  const Plastic law = Plastic::of(surface);
  Plastic::State state;
  dem::Table table({"overlap_m", "force_N", "loading"});  // 0 open, 1 virgin, 2 unloading, 3 reloading
  int place = 0;
  for (const int turn : {1000, 700, 1250, 700}) {
    const int direction = turn > place ? 1 : -1;
    for (; place != turn; place += direction) {
      const double overlap = place * 0.02e-6;
      const Loading loading = law.loading(state, overlap, -direction);
      table.add({overlap, law.respond(state, pair, overlap).force, static_cast<double>(loading)});
    }
  }
  table.write_csv(directory + "/ballast_cycle.csv");
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
  return sum >= 0.0 ? runs[7] : 0.0;  // the sum is used: the loop stays
}

/// Error of the force at 10 um, by the number of steps on the way there, and the price of a step.
void write_trade(const std::string& directory) {
  const auto error = [](const auto& law, int steps) {
    typename std::decay_t<decltype(law)>::State state{};
    return move(law, state, 0.0, 10e-6, steps) / expected::virgin_force_10um - 1.0;
  };
  dem::Table increments({"seed_N", "steps", "relative_error", "ns_per_step"});
  std::printf("\nForce at 10 um: relative error by steps from 0\n%-18s %9s", "", "ns/step");
  for (int steps = 10; steps <= 1000000; steps *= 10) std::printf(" %9d", steps);
  const auto row = [&](const std::string& name, const auto& law, double seed, dem::Table* table) {
    const double ns = cost(law);
    std::printf("\n%-18s %9.1f", name.c_str(), ns);
    for (int decade = 10; decade <= 1000000; decade *= 10) {
      for (const int steps : {decade, 2 * decade, 5 * decade}) {
        if (steps > 1000000) break;
        const double e = error(law, steps);
        if (table) table->add({seed, static_cast<double>(steps), e, ns});
        if (steps == decade) std::printf(" %9.1e", e);
      }
    }
    return ns;
  };
  dem::Table closed({"fast", "relative_error", "ns_per_step"});
  const double accurate_ns = row("closed, accurate", Plastic::of(surface), 0.0, nullptr);
  const double fast_ns = row("closed, fast", PlasticFast::of(surface), 0.0, nullptr);
  closed.add({0, error(Plastic::of(surface), 1), accurate_ns});
  closed.add({1, error(PlasticFast::of(surface), 1), fast_ns});
  for (const double seed : {0.0, 1e-12, 1e-6, 1e-3}) {
    char name[32];
    std::snprintf(name, sizeof name, "seed %g N", seed);
    row(name, Increments::of(surface, seed), seed, &increments);
  }
  std::printf("\n");
  increments.write_csv(directory + "/ballast_trade_increments.csv");
  closed.write_csv(directory + "/ballast_trade_closed.csv");
}

/// A million cycles up to 20 um: what the peak force becomes, where each cycle parts the bodies, and where it turns at 1 N
/// as the experiments behind the paper did. Increments take 25 steps up, 25 down; the closed form needs one.
void write_ratchet(const std::string& directory) {
  const Plastic closed = Plastic::of(surface);
  const Increments increments = Increments::of(surface, 1e-12);
  Plastic::State closed_apart, loaded;
  Increments::State apart, held;
  constexpr double peak = 20e-6;
  const double reopening = (closed.respond(loaded, pair, peak), closed.plastic_overlap(loaded));
  const double share = 1.0 / expected::virgin_force_20um;  // of the peak force, is 1 N
  const double at_1N = reopening + (peak - reopening) * std::cbrt(share * share);

  dem::Table table({"cycle", "closed_apart_N", "increments_apart_N", "increments_held_N"});
  std::array<double, 3> first{}, last{};
  long next = 1;
  for (long cycle = 1; cycle <= 1000000; ++cycle) {
    constexpr int steps = 25;
    const bool begins = cycle == 1;
    last = {move(closed, closed_apart, 0.0, peak, 1), move(increments, apart, 0.0, peak, steps),
            move(increments, held, begins ? 0.0 : at_1N, peak, steps)};
    if (begins) first = last;
    if (cycle == next) {
      table.add({static_cast<double>(cycle), last[0], last[1], last[2]});
      next = std::max(next + 1, next * 11 / 10);
    }
    move(closed, closed_apart, peak, 0.0, 1);
    move(increments, apart, peak, 0.0, steps);
    move(increments, held, peak, at_1N, steps);
  }
  table.add({1e6, last[0], last[1], last[2]});
  table.write_csv(directory + "/ballast_ratchet.csv");
  std::printf("\nPeak force at 20 um in the first and the millionth cycle [N]\n");
  const char* names[] = {"closed form, parted", "increments, parted", "increments, turned at 1 N"};
  for (std::size_t i = 0; i < 3; ++i)
    std::printf("%-28s %.17g  %.17g  (%+.2g)\n", names[i], first[i], last[i], last[i] / first[i] - 1.0);
}

int run(const std::string& directory) {
  std::filesystem::create_directories(directory);
  const memo::Rows rows = numbers();
  memo::print("Ballast (Tolomeo & McDowell 2022)", rows);
  memo::write_json(directory + "/ballast.json", rows);
  memo::write_csv(directory + "/ballast.csv", rows);
  write_curves(directory);
  write_cycle(directory);
  write_trade(directory);
  write_ratchet(directory);
  const bool good = memo::all_pass(rows);
  std::printf("\n%s\n", good ? "All numbers are right." : "Some numbers are WRONG.");
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc > 1 ? argv[1] : "build/results");
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "contact_curves: %s\n", fault.what());
    return 2;
  }
}

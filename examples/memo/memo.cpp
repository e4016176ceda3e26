// SPDX-License-Identifier: MIT
// The test problems of Potyondy (2019), Hill Contact Model, version 4, run through the integrator of examples/dem:
//
//   memo [directory]      writes memo.json, memo.csv, eight_laws.json and the curves there (default: build/results)
//
// Ends with 0 if every number is right, 1 if one is not, 2 on a fault, 130 if stopped with Ctrl-C (with what it had by then).
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "assembly.hpp"
#include "crossover.hpp"
#include "force_displacement.hpp"
#include "moisture.hpp"
#include "shear_update.hpp"

namespace {

int run(const std::string& directory) {
  std::filesystem::create_directories(directory);
  memo::Rows rows, laws;
  const std::vector<std::function<void()>> problems{[&] { memo::force_displacement(directory, rows); },
                                                    [&] { memo::crossover(directory, rows); },
                                                    [&] { memo::MoistureProblem().run(directory, rows); },
                                                    [&] { memo::grain_assembly(directory, rows); },
                                                    [&] { memo::appendix_a(directory, rows); },
                                                    [&] { laws = memo::eight_laws(); }};
  const dem::InterruptGuard guard;
  {
    dem::Progress progress("the memo's problems");
    for (std::size_t i = 0; i < problems.size() && !dem::stop_requested(); ++i) {
      const auto rows_before = rows, laws_before = laws;
      problems[i]();
      if (dem::stop_requested()) {  // what a problem yields that was stopped midway is not its result
        rows = rows_before;
        laws = laws_before;
      }
      progress.at(static_cast<double>(i + 1) / static_cast<double>(problems.size()));
    }
  }
  memo::print("Hill memo (Potyondy 2019)", rows);
  memo::print("One path through four shear histories", laws);
  memo::write_json(directory + "/memo.json", rows);
  memo::write_csv(directory + "/memo.csv", rows);
  memo::write_json(directory + "/eight_laws.json", laws);
  memo::write_csv(directory + "/eight_laws.csv", laws);
  if (dem::stop_requested()) {
    std::printf("\nStopped: these are the results so far.\n");
    return 130;
  }
  const bool good = memo::all_pass(rows) && memo::all_pass(laws);
  std::printf("\n%s\n", good ? "All numbers are right." : "Some numbers are WRONG.");
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc > 1 ? argv[1] : "build/results");
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "memo: %s\n", fault.what());
    return 2;
  }
}

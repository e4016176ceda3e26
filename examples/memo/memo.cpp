// SPDX-License-Identifier: MIT
// The test problems of Potyondy (2019), Hill Contact Model, version 4, run through the integrator of examples/dem:
//
//   memo [FOLDER]      writes memo.json, memo.csv, eight_laws.json, eight_laws.csv and the curves (default: build/results)
//
// Exit status: 0 if every number is right, 1 if one is not, 2 on a fault, 130 after Ctrl-C. After a fault or Ctrl-C the files
// of an earlier run are unchanged.
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "assembly.hpp"
#include "common/program.hpp"
#include "crossover.hpp"
#include "force_displacement.hpp"
#include "moisture.hpp"
#include "shear_update.hpp"

namespace {

int run(const std::string& directory) {
  const common::InterruptGuard guard;
  common::OutputFolder folder(directory);
  common::CheckedNumbers numbers, laws;
  const std::vector<std::function<void()>> problems{[&] { memo::force_displacement(folder, numbers); },
                                                    [&] { memo::crossover(folder, numbers); },
                                                    [&] { memo::MoistureProblem().run(folder, numbers); },
                                                    [&] { memo::grain_assembly(folder, numbers); },
                                                    [&] { memo::appendix_a(folder, numbers); },
                                                    [&] { laws = memo::eight_laws(); }};
  {
    common::Progress progress("the memo's problems");
    for (std::size_t i = 0; i < problems.size(); ++i) {
      problems[i]();
      common::stop_if_requested();
      progress.at(static_cast<double>(i + 1) / static_cast<double>(problems.size()));
    }
  }
  write_json(folder.file("memo.json"), numbers);
  write_csv(folder.file("memo.csv"), numbers);
  write_json(folder.file("eight_laws.json"), laws);
  write_csv(folder.file("eight_laws.csv"), laws);
  folder.complete();
  print("Hill memo (Potyondy 2019)", numbers);
  print("One path through four shear histories", laws);
  numbers.insert(numbers.end(), laws.begin(), laws.end());
  return verdict(numbers);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs the test problems of the Hill memo (Potyondy 2019).", "memo");
  std::string directory = "build/results";
  app.add_option("FOLDER", directory, "where to write the results (default: build/results)");
  return common::run_program(app, argc, argv, [&directory] { return run(directory); });
}

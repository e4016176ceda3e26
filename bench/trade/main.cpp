// SPDX-License-Identifier: MIT
// The trade between speed and accuracy:
//
//   trade LAW.toml... [-o DIRECTORY]
//       every variant of each law on every family of motions (families.hpp): writes trade.csv and trade.json
//   trade --replay RECORDING.csv --law LAW.toml [--tolerance 1e-3] [-o DIRECTORY]
//       the cheapest composition whose forces on a recorded motion are within the tolerance, and which features the motion
//       does not use; with -o, all compositions in replay.csv
//
// Exit status: 0; 1 if no composition is within the tolerance, or a variant exceeds its rounding bound (variants.hpp); 2 for a
// fault in the input, which it names, and then nothing is written; 130 after Ctrl-C.
#include <filesystem>
#include <iostream>

#include "bench/machine.hpp"
#include "common/program.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "measurement.hpp"
#include "replay.hpp"

namespace trade {

namespace {

struct Arguments {
  std::vector<std::string> laws;
  std::string directory;
  std::string recording;
  std::string law;
  double tolerance = 1e-3;
  int repetitions = 11;
};

int measure(const Arguments& arguments) {
  const std::string directory = arguments.directory.empty() ? "build/results" : arguments.directory;
  std::vector<std::pair<std::string, LawSpec>> laws;
  for (const std::string& file : arguments.laws) {
    laws.emplace_back(std::filesystem::path(file).stem().string(), read_measured_law(file));
    if (laws.back().second.bodies.empty())
      fail({file}, "[pair] must have bodies here: the families of motion move them");
  }
  common::OutputFolder folder(directory);
  Effort effort;
  effort.repetitions = arguments.repetitions;
  std::vector<Measurement> rows;
  const common::InterruptGuard guard;
  {
    common::Progress progress("trade");
    for (std::size_t i = 0; i < laws.size(); ++i) {
      const auto of_law = [&](double done) { progress.at((double(i) + done) / double(laws.size())); };
      const std::vector<Measurement> more = measure_law(laws[i].first, laws[i].second, effort, of_law);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
  write_table(folder, rows,
              {{"processor", bench::processor()},
               {"compiler", TRADE_COMPILER},
               {"date", bench::today()},
               {"lanes", contactlaws::ScalarTraits<contactlaws::PackOf<double>::type>::lanes}});
  std::cout << "written: " << directory << "/trade.csv and trade.json, " << rows.size() << " rows\n";
  bool all_within = true;
  for (const Measurement& row : rows) {
    if (within_bound(row)) continue;
    all_within = false;
    std::cerr << "trade: " << row.law << ", " << row.motion << ", " << row.variant.name << ": rounding of "
              << row.rounding << " exceeds its bound, " << rounding_bound(row.variant.composition.precision) << '\n';
  }
  return all_within ? 0 : 1;
}

}  // namespace

}  // namespace trade

int main(int argc, char** argv) {
  CLI::App app("What every simplification of a contact law costs in accuracy and saves in time.", "trade");
  trade::Arguments arguments;
  app.add_option("LAW.toml", arguments.laws, "laws to measure");
  app.add_option("-o,--output", arguments.directory,
                 "directory of the tables (default: build/results; a replay's: none)");
  app.add_option("--replay", arguments.recording, "a recording of contacts: which features does it need?");
  app.add_option("--law", arguments.law, "the full law of the recorded contacts");
  app.add_option("--tolerance", arguments.tolerance, "on forces, relative to the largest of a contact (default: 1e-3)")
      ->check([](const std::string& text) {
        const double value = common::is_decimal(text) ? common::rounded<double>(text) : 0.0;
        return value >= 1e-18 && value <= 1e18 ? std::string() : text + " is not a number in [1e-18, 1e18]";
      });
  app.add_option("--repetitions", arguments.repetitions, "timings of which the median is taken (default: 11)")
      ->check(CLI::Range(1, 1000));
  return common::run_program(app, argc, argv, [&] {
    if (arguments.recording.empty() != arguments.law.empty())
      throw CLI::ValidationError("--replay and --law belong together");
    if (!arguments.recording.empty())
      return trade::replay(arguments.recording, arguments.law, arguments.tolerance, arguments.repetitions, std::cout,
                           arguments.directory);
    if (arguments.laws.empty()) throw CLI::ValidationError("nothing to do: name laws, or --replay and --law");
    return trade::measure(arguments);
  });
}

// SPDX-License-Identifier: MIT
// The force of a liquid bridge against the gap, by each rule of contactlaws/bridge/bridge_force.hpp, for figures.py.
//
//   bridge_curves [FOLDER]      writes bridge_curves.csv (default: build/results)
//
// Lengths in R, forces in 2 pi R gamma. Gaps up to the rupture gap of the exact rule.
#include <cmath>
#include <filesystem>
#include <string>

#include "common/output_file.hpp"
#include "common/program.hpp"
#include "common/table.hpp"
#include "contactlaws/contactlaws.hpp"

namespace {

using namespace contactlaws;

struct At {
  double angle, volume, gap;
};

/// The gap of x = 1.
double scale(double volume) { return std::sqrt(2.0 * volume / pi<double>()); }

/// The force of one rule, at gaps beyond its own rupture gap too.
template <class Rule>
double force(const At& at) {
  Rule rule;
  rule.prepare(at.angle);
  return rule.force(std::pow(at.volume, 1.0 / 6.0), at.gap, scale(at.volume));
}

int run(const std::string& directory) {
  common::Table table{"angle_deg", "volume", "gap", "young_laplace", "willett", "rabinovich"};
  for (const double degrees : {0.0, 20.0, 40.0, 60.0})
    for (int k = 0; k <= 16; ++k) {
      const double angle = degrees * pi<double>() / 180.0, volume = std::pow(10.0, -5.0 + k / 4.0);
      YoungLaplace<double> exact;
      exact.prepare(angle);
      const double rupture = scale(volume) * exact.rupture(std::pow(volume, 1.0 / 6.0));
      const int pieces = 80;
      for (int i = 0; i <= pieces; ++i) {
        const double x = static_cast<double>(i) / pieces;  // dense at touch, and at rupture: a square root there
        const At at{angle, volume, rupture * x * x * (3.0 - 2.0 * x)};
        table.add({degrees, volume, at.gap, force<YoungLaplace<double>>(at), force<WillettClosed<double>>(at),
                   force<Rabinovich<double>>(at)});
      }
    }
  std::filesystem::create_directories(directory);
  common::OutputFile file((std::filesystem::path(directory) / "bridge_curves.csv").string());
  table.write_csv(file.stream());
  file.complete();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Computes the force of liquid bridges against the gap.", "bridge_curves");
  std::string directory = "build/results";
  app.add_option("FOLDER", directory, "where to write the results (default: build/results)");
  return common::run_program(app, argc, argv, [&directory] { return run(directory); });
}

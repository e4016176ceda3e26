// SPDX-License-Identifier: MIT
// The report card of a host's own law: the checks of contactlaws/verify, a JSON line each.
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "contactlaws/verify/verify.hpp"

namespace contactlaws {

/// A host's law as a force update. Host offers history_size(), exchange(values), and compute(bodies, dt, values, touching),
/// which takes the history and whether the pair touched, and leaves both after the step.
template <class Host>
struct HostLaw {
  const Host* host;

  struct State {
    std::vector<double> values;
    int touching = 0;
  };
  State start() const { return {std::vector<double>(std::size_t(host->history_size()), 0.0), 0}; }
  verify::Interaction operator()(const verify::Bodies& bodies, double dt, State& state) const {
    return host->compute(bodies, dt, state.values, state.touching);
  }
  std::vector<double> store(const State& state) const {
    std::vector<double> all = state.values;
    all.push_back(state.touching);
    return all;
  }
  State load(const std::vector<double>& all) const { return {{all.begin(), all.end() - 1}, int(all.back())}; }
  State exchanged(State state) const {
    host->exchange(state.values);
    return state;
  }
};

/// Two granite grains of radii 7.5 and 5 mm at overlaps up to 10 um. Claimed: what a user of an elastic law with friction
/// expects, whether the host's documentation states it or not.
inline verify::Options two_grains(double friction) {
  verify::Options options;
  options.radius1 = 7.5e-3;
  options.radius2 = 5e-3;
  options.mass1 = sphere_mass<double>(options.radius1, 2650.0);
  options.mass2 = sphere_mass<double>(options.radius2, 2650.0);
  options.overlap = 1e-5;
  options.claims.friction = friction;
  options.claims.range = 0.0;
  options.claims.no_tension = true;
  options.claims.continuous_at_touch = true;
  options.claims.continuous_in_motion = true;
  options.claims.passive = true;
  options.claims.no_ratcheting = true;
  options.claims.follows_twist = true;
  return options;
}

class ReportCard {
 public:
  ReportCard(const std::string& host, const std::string& law, const std::string& folder)
      : host_(host), law_(law), folder_(folder + '/' + law) {
    for (char& c : folder_)
      if (c == ' ' || c == ',' || c == '=') c = '_';
  }

  void check(const verify::ForceUpdate& update, verify::Options options) {
    std::filesystem::create_directories(folder_);
    options.folder = folder_;
    for (const verify::Result& result : verify::check_all(update, options).results) {
      if (result.verdict == verify::Verdict::not_claimed || result.verdict == verify::Verdict::not_offered) continue;
      print(result.property, result.worst, result.measure, result.path.size(), result.file);
    }
  }
  void add(const std::string& property, double figure, double allowed, const std::string& measure) {
    print(property, {figure, allowed}, measure, 1, "");
  }

 private:
  void print(const std::string& property, const verify::Finding& finding, const std::string& measure, std::size_t steps,
             const std::string& file) {
    const nlohmann::json line = {{"host", host_},
                                 {"law", law_},
                                 {"property", property},
                                 {"pass", !finding.failed()},
                                 {"figure", finding.error},
                                 {"allowed", finding.allowed},
                                 {"measure", measure},
                                 {"steps", steps},
                                 {"path", file}};
    std::cout << line.dump() << std::endl;
  }

  std::string host_, law_, folder_;
};

/// main() of a report card, between MPI_Init and MPI_Finalize: runs run(FOLDER), and says what failed.
inline int run_report_card(int argc, char** argv, const std::function<void(const std::string& folder)>& run) {
  if (argc != 2) {
    std::cerr << argv[0] << ": name the folder for the paths of failures\n";
    return 2;
  }
  try {
    run(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << argv[0] << ": " << error.what() << '\n';
    return 2;
  }
}

}  // namespace contactlaws

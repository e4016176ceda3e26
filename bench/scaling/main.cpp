// SPDX-License-Identifier: MIT
// What a step of examples/dem costs against the number of grains, on one core: a lattice and random packings of grains of one size, and
// of sizes up to 1:5 and 1:10, under the dry hill law.
//
//   dem_scaling [FOLDER] [--most GRAINS]      writes dem_scaling.csv and dem_scaling.json (default: build/results, 1 000 000)
//
// Columns, per listed contact: step_ns, search_ns (one search for neighbours), bytes (of the list of contacts). Per grain: contacts, touching.
// list_steps: steps between two searches where a packing is strained at 0.1/s, as in the specimens; search_share: of all time, then.
// Times are processor time, as other programs may use the core: medians of at least 5 steps, and of 1 to 3 searches.
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "bench/contacts.hpp"
#include "common/machine.hpp"
#include "packing.hpp"

namespace scaling {

namespace {

using Law = contactlaws::DryHill<double>;
using Scene = dem::Simulation<Law>;

struct Row {
  std::string packing;
  std::size_t grains;
  double contacts, touching, step_ns, search_ns, bytes, list_steps, search_share;
};

/// Median time of `work()` [ns]: of `least` to `most` calls, no more once they have taken a second.
template <class Work>
double nanoseconds(int least, int most, const Work& work) {
  std::vector<double> times;
  double sum = 0.0;
  for (int i = 0; i < least || (i < most && sum < 1e9); ++i) {
    const std::clock_t begin = std::clock();
    work();
    times.push_back(static_cast<double>(std::clock() - begin) * (1e9 / CLOCKS_PER_SEC));
    sum += times.back();
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

Scene scene_of(const std::vector<Grain>& grains) {
  Scene scene(bench::granite<Law>());
  scene.log = nullptr;
  for (const Grain& grain : grains) scene.add(dem::Ball{contactlaws::sphere(granite, grain.radius), grain.position});
  return scene;
}

Row measure(const std::string& packing, const std::vector<Grain>& grains, double edge) {
  Scene scene = scene_of(grains);
  Scene smallest = scene_of({{smallest_radius, Vec3::Zero()}});
  const double usual_step = 0.5 * dem::stable_time_step(smallest);
  scene.time_step = 1e-10;  // nothing moves, so that each step does the same
  scene.step();
  const auto count = static_cast<double>(grains.size());
  const auto listed = static_cast<double>(scene.ball_contacts.size());
  double touching = 0.0;
  for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
    touching += scene.ball_contact(c).geometry.overlap > 0.0 ? 1.0 : 0.0;
  // The clock ticks in microseconds: a thousand grains take 30 a step.
  const int steps = std::max(1, static_cast<int>(1e5 / count));
  Row row{packing, grains.size(), listed / count, touching / count, 0, 0, 0, 0, 0};
  row.step_ns = nanoseconds(5, 51,
                            [&] {
                              for (int i = 0; i < steps; ++i) scene.step();
                            }) /
                (listed * steps);
  row.search_ns = nanoseconds(1, 3, [&] { scene.resume(); }) / listed;
  row.bytes = static_cast<double>(scene.ball_contacts.bytes()) / listed;
  // The ends of a specimen move at half the rate times its length, and a list lasts until a grain has moved half its margin.
  row.list_steps = scene.allowed_motion() / (0.1 * edge / 2.0) / usual_step;
  row.search_share = row.search_ns / (row.search_ns + row.step_ns * row.list_steps);
  return row;
}

int run(const std::string& folder, int most) {
  struct Kind {
    std::string name;
    double ratio, solid;
    int steps;
  };
  std::filesystem::create_directories(folder);
  std::string table = "packing,grains,contacts,touching,step_ns,search_ns,bytes,list_steps,search_share\n";
  const auto add = [&table](const Row& row) {
    std::ostringstream line;
    line << std::setprecision(3) << row.packing << ',' << row.grains << ',' << row.contacts << ',' << row.touching
         << ',' << row.step_ns << ',' << row.search_ns << ',' << row.bytes << ',' << row.list_steps << ','
         << row.search_share << '\n';
    std::cout << line.str() << std::flush;
    table += line.str();
  };
  for (const int along : {10, 22, 46, 100})
    if (along * along * along <= most) add(measure("lattice", lattice(along), 2.0 * smallest_radius * along));
  // Solid shares at which each grain touches five to seven others.
  for (const Kind& kind : {Kind{"1:1", 1.0, 0.64, 1500}, {"1:5", 5.0, 0.68, 1500}, {"1:10", 10.0, 0.70, 2000}}) {
    const Cube cube = fill_cube(bench::granite<Law>(), 1000, kind.ratio, kind.solid, kind.steps);
    for (const std::array<int, 3>& along : {std::array<int, 3>{1, 1, 1}, {2, 2, 2}, {5, 5, 4}, {10, 10, 10}})
      if (1000 * along[0] * along[1] * along[2] <= most)
        add(measure(kind.name, repeat(cube, along), cube.edge * along[2]));
  }
  std::ofstream(folder + "/dem_scaling.csv") << table;
  nlohmann::ordered_json machine = common::machine();
  machine["lanes"] = decltype(Scene::ball_contacts)::lanes;
  std::ofstream(folder + "/dem_scaling.json") << machine.dump(1) << '\n';
  return 0;
}

}  // namespace

}  // namespace scaling

int main(int argc, char** argv) {
  CLI::App app("The cost of a step of examples/dem against the number of grains.", "dem_scaling");
  std::string folder = "build/results";
  int most = 1'000'000;
  app.add_option("FOLDER", folder, "where the results go (default: build/results)");
  app.add_option("--most", most, "grains of the largest packing (default: 1000000)")
      ->check(CLI::Range(1000, 1'000'000));
  CLI11_PARSE(app, argc, argv);
  return scaling::run(folder, most);
}

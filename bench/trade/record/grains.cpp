// SPDX-License-Identifier: MIT
// Records the first 0.12 ms of the memo's 27 grains (Potyondy 2019, Figure 17), dry and under the hill law. Gravity is tilted,
// so that they roll and slide.
//
//   record_grains RECORDING.csv
//
// Exit status: 0, 2 on a fault, 130 after Ctrl-C. After a fault or Ctrl-C an earlier recording is unchanged.
#include <string>

#include "common/output_file.hpp"
#include "common/program.hpp"
#include "common/progress.hpp"
#include "contactlaws/laws.hpp"
#include "dem/recording.hpp"
#include "dem/simulation.hpp"

namespace {

int record(const std::string& name) {
  const common::InterruptGuard guard;
  common::OutputFile file(name);
  using dem::Vec3;
  constexpr double radius = 5e-3, edge = 50e-3;
  const contactlaws::ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
  contactlaws::HillProperties<double> properties;
  properties.friction = 0.4;
  properties.suction = 200e3;  // [Pa]
  properties.damping_constant = 0.07;
  dem::Simulation<contactlaws::Hill<double>> scene(hill(properties));
  scene.gravity = {1.0, 0.5, -9.81};  // [m/s^2]
  for (const dem::Wall& wall : dem::box_of_walls(contactlaws::plane(granite), Vec3::Zero(), Vec3::Constant(edge)))
    scene.add(wall);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        scene.add(dem::Ball{contactlaws::sphere(granite, radius),
                            Vec3(edge / 2.0, edge / 2.0, 3.0 * radius) + 1.9999 * radius * Vec3(x, y, z),
                            Vec3(0.1 * y, -0.1 * x, -0.2)});
  scene.time_step = 2e-7;
  dem::Recording recording(20);
  common::Progress progress("record_grains");
  constexpr int steps = 600;
  for (int step = 0; step < steps; ++step) {
    common::stop_if_requested();
    scene.step();
    for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c) {
      const auto motion = scene.ball_contact(c).motion;
      if (-motion.overlap <= scene.ball_law.interaction_range(scene.ball_contacts.pair(c)))
        recording.add(scene.ball_contacts.bodies[c], motion);
    }
    recording.end_step();
    progress.at((step + 1.0) / steps);
  }
  recording.write_csv(file.stream());
  file.complete();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Records how the contacts of 27 falling grains move, for trade --replay.", "record_grains");
  std::string file;
  app.add_option("RECORDING.csv", file, "where to write the recording")->required();
  return common::run_program(app, argc, argv, [&file] { return record(file); });
}

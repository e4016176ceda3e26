// SPDX-License-Identifier: MIT
// Records the first moments of the memo's 27 grains (Potyondy 2019, Figure 17), set down with a tilt so that they roll and
// slide: dry grains under the hill law.
//
//   record_grains RECORDING.csv
#include <cstdio>
#include <exception>

#include "../../../examples/dem/measures.hpp"
#include "../../../examples/dem/recording.hpp"
#include "../../../examples/dem/simulation.hpp"
#include "contactlaws/laws.hpp"

namespace {

void record(const char* file) {
  using dem::Vec3;
  constexpr double radius = 5e-3, edge = 50e-3;
  const contactlaws::ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
  using Law = contactlaws::Hill<double>;
  dem::Simulation<Law> scene(contactlaws::hill<double>({0.4, 200e3, 0.07}));
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
  for (int step = 0; step < 600; ++step) {
    scene.step();
    for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c) {
      const auto motion = scene.ball_contact(c).motion;
      if (-motion.overlap <= scene.ball_law.interaction_range(scene.ball_contacts.pair_at<double>(c)))
        recording.add(scene.ball_contacts.bodies[c], motion);
    }
    recording.end_step();
  }
  recording.write_csv(file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: record_grains RECORDING.csv\n", stderr);
    return 2;
  }
  try {
    record(argv[1]);
    return 0;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "record_grains: %s\n", fault.what());
    return 2;
  }
}

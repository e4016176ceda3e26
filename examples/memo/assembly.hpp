// SPDX-License-Identifier: MIT
// 27 grains in cubic packing fall onto the bottom of a box and come to rest: hill law between grains, linear law at walls
// (Figure 17). The grains stand exactly one above the other and come to rest so, since no force acts sideways.
#pragma once

#include <string>

#include "dem/output.hpp"
#include "dem/settle.hpp"
#include "expected.hpp"
#include "force_displacement.hpp"

namespace memo {

/// Writes NAME.csv and NAME.vtp.
inline void write_grains(OutputFolder& folder, const std::string& name, const dem::Balls& balls) {
  Table grains{"x_m", "y_m", "z_m", "radius_m"};
  for (std::size_t i = 0; i < balls.size(); ++i)
    grains.add({balls.position[i].x(), balls.position[i].y(), balls.position[i].z(), balls.radius[i]});
  grains.write_csv(folder.file(name + ".csv"));
  dem::balls_for_vtk(balls).write(folder.file(name + ".vtp"));
}

inline void grain_assembly(OutputFolder& folder, CheckedNumbers& numbers) {
  constexpr double radius = 5e-3, edge = 50e-3;  // [m]; the memo gives no size for the box
  contactlaws::LinearFriction<double> at_walls = linear_law(friction);
  at_walls.normal.modulus = 29e6;  // [Pa]
  dem::Simulation<contactlaws::Hill<double>, contactlaws::LinearFriction<double>> scene(damped_hill_law(), at_walls);
  scene.gravity = {0.0, 0.0, -9.81};
  scene.local_damping = local_damping;
  for (const dem::Wall& wall : dem::box_of_walls(contactlaws::plane(granite), Vec3::Zero(), Vec3::Constant(edge)))
    scene.add(wall);
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        scene.add(
            dem::Ball{contactlaws::sphere(granite, radius), Vec3::Constant(edge / 2.0) + 2.0 * radius * Vec3(x, y, z)});
  write_grains(folder, "assembly_before", scene.balls);

  const dem::Wall& bottom = scene.walls[4];
  Table history{"time_s", "bottom_wall_force_N"};
  dem::settle(scene, {1e-9, 0.2, 1000000}, [&] {
    if (scene.steps % 10 == 0) history.add({scene.time, bottom.force.norm()});
  });
  history.write_csv(folder.file("assembly_history.csv"));
  write_grains(folder, "assembly_after", scene.balls);
  dem::ball_contacts_for_vtk(scene).write(folder.file("assembly_contacts.vtp"));
  dem::wall_contacts_for_vtk(scene).write(folder.file("assembly_wall_contacts.vtp"));
  numbers.push_back(
      {"grain_assembly.bottom_wall_force", 0.368, expected::assembly_weight, bottom.force.norm(), equilibrium});
}

}  // namespace memo

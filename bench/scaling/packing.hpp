// SPDX-License-Identifier: MIT
// Dense random packings of up to a million grains, made in seconds.
//
// A cube of rigid walls is filled with overlapping grains on a shaken lattice, which push each other apart without friction. A larger packing
// is many such cubes side by side, each the mirror image of its neighbours: a grain that a wall pressed is then pressed by its own image with
// the same force, so what was at rest in one cube is at rest in all of them.
#pragma once

#include <array>
#include <random>

#include "dem/measures.hpp"
#include "dem/spatial_order.hpp"

namespace scaling {

using dem::Vec3;

struct Grain {
  double radius;  ///< [m]
  Vec3 position;  ///< [m]
};

/// A cube of `edge` [m] with a corner at the origin.
struct Cube {
  double edge;
  std::vector<Grain> grains;
};

constexpr double smallest_radius = 2e-3;  // [m]
inline const contactlaws::ElasticMaterial<double> granite{29e9, 0.15, 2650.0};

/// `count` grains, their radii uniform from 1 to `ratio` smallest radii, after `steps` steps. `solid`: their volume over that of the cube.
template <class Law>
Cube fill_cube(const Law& law, int count, double ratio, double solid, int steps) {
  std::mt19937_64 random(20190405);
  // [0, 1); std::uniform_real_distribution differs from library to library
  const auto uniform = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<double> radii;
  double volume = 0.0;
  for (int i = 0; i < count; ++i) {
    radii.push_back(smallest_radius * (1.0 + (ratio - 1.0) * uniform()));
    volume += 4.0 / 3.0 * contactlaws::pi<double>() * std::pow(radii.back(), 3);
  }
  Cube cube{std::cbrt(volume / solid), {}};
  dem::Simulation<Law> scene(law);
  scene.ball_law.shear.friction = scene.wall_law.shear.friction = 0.0;
  scene.local_damping = 0.5;
  scene.log = nullptr;  // grains overlap
  for (const dem::Wall& wall :
       dem::box_of_walls(contactlaws::plane(granite).rigid(), Vec3::Zero(), Vec3::Constant(cube.edge)))
    scene.add(wall);
  const int sites = static_cast<int>(std::ceil(std::cbrt(count) - 1e-9));  // along an edge
  for (int i = 0; i < count; ++i) {
    const Vec3 site(i % sites, i / sites % sites, i / sites / sites), shift(uniform(), uniform(), uniform());
    scene.add(dem::Ball{contactlaws::sphere(granite, radii[static_cast<std::size_t>(i)]),
                        (site + shift) * (cube.edge / sites)});
  }
  for (int step = 0; step < steps; ++step) {
    if (step % 10 == 0) {
      scene.time_step = 0.5 * dem::stable_time_step(scene);
      if (step < 100)  // deep overlaps would throw grains out
        for (std::size_t b = 0; b < scene.balls.size(); ++b)
          scene.balls.velocity[b] = scene.balls.spin[b] = Vec3::Zero();
    }
    scene.step();
  }
  for (std::size_t b = 0; b < scene.balls.size(); ++b)
    cube.grains.push_back({scene.balls.radius[b], scene.balls.position[b]});
  return cube;
}

/// The cube and its mirror images, `along` of them along each axis, in spatial order.
inline std::vector<Grain> repeat(const Cube& cube, const std::array<int, 3>& along) {
  std::vector<Grain> grains;
  for (int z = 0; z < along[2]; ++z)
    for (int y = 0; y < along[1]; ++y)
      for (int x = 0; x < along[0]; ++x)
        for (const Grain& grain : cube.grains) {
          const std::array<int, 3> tile{x, y, z};
          Vec3 position;
          for (int axis = 0; axis < 3; ++axis) {
            const int number = tile[static_cast<std::size_t>(axis)];
            const double inside = grain.position[axis];
            position[axis] = number * cube.edge + (number % 2 == 0 ? inside : cube.edge - inside);
          }
          grains.push_back({grain.radius, position});
        }
  dem::sort_in_space(grains);
  return grains;
}

/// `along` grains along each axis, which touch with an overlap of 4e-4 radii.
inline std::vector<Grain> lattice(int along) {
  std::vector<Grain> grains;
  const double spacing = (2.0 - 4e-4) * smallest_radius;
  for (int z = 0; z < along; ++z)
    for (int y = 0; y < along; ++y)
      for (int x = 0; x < along; ++x) grains.push_back({smallest_radius, Vec3(x, y, z) * spacing});
  return grains;
}

}  // namespace scaling

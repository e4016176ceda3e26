// The parts of the specimens in examples/dem: the cylinder, the servo, measures of an assembly.
#include <filesystem>

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "examples/dem/assembly_measures.hpp"
#include "examples/dem/checkpoint.hpp"
#include "examples/dem/servo.hpp"
#include "examples/dem/settle.hpp"
#include "random.hpp"

using namespace contactlaws;
using contactlaws::test::Random;
using V = dem::Vec3;

namespace {

const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
constexpr double pi_ = 3.14159265358979323846;

LinearFriction<double> linear(double friction) {
  LinearFrictionProperties<double> properties;
  properties.modulus = 500e6;
  properties.friction = friction;
  properties.stiffness_ratio = 1.0 / 1.5;
  return linear_friction(properties);
}

using Scene = dem::Simulation<LinearFriction<double>>;

dem::Wall cylinder(double radius) {
  dem::Wall wall{plane(granite), V(0.1, -0.2, 0.3), V::UnitZ()};
  wall.radius = radius;
  return wall;
}

/// Balls at random places in a vessel: a cylinder of radius 20 mm about the z axis, and platens at +-20 mm.
Scene vessel(Random& random, int balls) {
  Scene scene(linear(0.5), linear(0.0));
  dem::Wall side = cylinder(20e-3);
  side.point = V::Zero();
  scene.add(dem::Wall{plane(granite), V(0, 0, -20e-3), V::UnitZ()});
  scene.add(dem::Wall{plane(granite), V(0, 0, 20e-3), -V::UnitZ()});
  scene.add(side);
  scene.local_damping = 0.7;
  scene.log = nullptr;
  while (static_cast<int>(scene.balls.size()) < balls) {
    const double radius = random.uniform(2e-3, 3e-3);
    const V place(random.uniform(-14e-3, 14e-3), random.uniform(-14e-3, 14e-3), random.uniform(-17e-3, 17e-3));
    if (std::hypot(place.x(), place.y()) < 17e-3) scene.add(dem::Ball{sphere(granite, radius), place});
  }
  return scene;
}

}  // namespace

TEST_CASE("a ball meets a cylinder at the nearest point: overlap, normal, and the speed of the wall") {
  Scene scene(linear(0.0));
  scene.add(cylinder(50e-3));
  const double angle = 0.7;
  const V outward(std::cos(angle), std::sin(angle), 0.0);
  scene.add(dem::Ball{sphere(granite, 5e-3), scene.walls[0].point + 46e-3 * outward + 0.05 * V::UnitZ()});
  scene.walls[0].radial_velocity = -0.5;
  scene.walls[0].velocity = V(0, 0, 2.0);
  scene.log = nullptr;
  scene.start();
  REQUIRE(scene.wall_contacts.size() == 1);
  const auto contact = scene.wall_contact(0);
  // Coordinates of 0.3 m carry rounding errors of 6e-17 m; the overlap is 1 mm.
  CHECK(contact.geometry.overlap == Approx(1e-3).epsilon(1e-12));
  CHECK((contact.geometry.normal + outward).norm() < 1e-14);
  CHECK((contact.motion.velocity - (0.5 * outward - V(0, 0, 2.0))).norm() < 1e-14);
  CHECK(scene.walls[0].normal_force == Approx(contact.response.normal_force).epsilon(1e-14));
  CHECK((scene.walls[0].force - contact.response.normal_force * outward).norm() <
        1e-13 * contact.response.normal_force);
}

TEST_CASE("a ball on the axis of a cylinder does not touch it") {
  Scene scene(linear(0.0));
  scene.add(cylinder(50e-3));
  scene.add(dem::Ball{sphere(granite, 5e-3), scene.walls[0].point});
  scene.time_step = 1e-6;
  scene.step();
  CHECK(scene.balls.force[0].norm() == 0.0);
  CHECK(scene.balls.position[0].allFinite());
}

TEST_CASE("a shrinking cylinder finds a ball that was far away") {
  Scene scene(linear(0.0));
  scene.add(cylinder(50e-3));
  scene.add(dem::Ball{sphere(granite, 5e-3), scene.walls[0].point + V(30e-3, 0, 0)});
  scene.drive(0, V::Zero());
  scene.time_step = 1e-4;
  scene.walls[0].radial_velocity = -1.0;
  for (int step = 0; step < 160; ++step) scene.step();
  CHECK(scene.walls[0].radius == Approx(34e-3).epsilon(1e-12));
  // k_n = E pi R at a facet; overlap 1 mm
  CHECK(scene.walls[0].normal_force == Approx(500e6 * pi_ * 5e-3 * 1e-3).epsilon(1e-9));
}

TEST_CASE("a wall of negative radius is refused") {
  Scene scene(linear(0.0));
  CHECK_THROWS_WITH(scene.add(cylinder(-1.0)), ContainsSubstring("radius") && ContainsSubstring("-1"));
}

TEST_CASE("servos hold the pressure of a vessel; at rest the stress of the walls is that of all contacts") {
  Random random(5);
  Scene scene = vessel(random, 150);
  std::array<dem::Servo, 3> servos;
  for (dem::Servo& servo : servos) servo.target = 100e3;
  scene.time_step = 0.5 * dem::stable_time_step(scene);
  const auto height = [&] { return scene.walls[1].point.z() - scene.walls[0].point.z(); };
  const auto radius = [&] { return scene.walls[2].radius; };
  const auto area = [&](std::size_t w) { return w < 2 ? pi_ * radius() * radius() : 2.0 * pi_ * radius() * height(); };
  for (int step = 0; step < 60000; ++step) {
    scene.ball_law.shear.friction = step < 20000 ? 0.0 : 0.5;  // packs, then comes to rest
    if (step % 100 == 0) {
      scene.time_step = 0.5 * dem::stable_time_step(scene);
      for (std::size_t w = 0; w < 3; ++w) servos[w].measure(scene, w);
    }
    for (std::size_t w = 0; w < 3; ++w) {
      const double speed = servos[w].speed(scene.walls[w], area(w), scene.time_step);
      if (w < 2)
        scene.walls[w].velocity = speed * scene.walls[w].facing;
      else
        scene.walls[w].radial_velocity = -speed;
    }
    scene.step();
  }
  const double reached = dem::unbalanced_ratio(scene);
  CHECK(reached < 1e-6);
  // Each wall is as near to its pressure as the balls are to rest.
  for (std::size_t w = 0; w < 3; ++w)
    CHECK(scene.walls[w].normal_force / area(w) == Approx(100e3).epsilon(10.0 * reached + 1e-9));

  const double volume = pi_ * radius() * radius() * height();
  const Eigen::Matrix3d by_walls = dem::wall_stress(scene, volume), by_contacts = dem::contact_stress(scene, volume);
  // The difference is the unbalanced force, to the rounding of sums of some hundred terms.
  const Eigen::Matrix3d missing = dem::unbalanced_stress(scene.balls, volume);
  CHECK((by_walls - by_contacts + missing).norm() < 1e-12 * by_walls.norm());
  CHECK(missing.norm() < (10.0 * reached + 1e-12) * by_walls.norm());
  // The walls have no friction. Places of contacts are half an overlap inside the walls: 1e-6 m of 18e-3 m.
  CHECK(by_walls(2, 2) == Approx(100e3).epsilon(reached + 1e-3));
  CHECK((by_walls(0, 0) + by_walls(1, 1)) / 2.0 == Approx(100e3).epsilon(reached + 1e-3));
  CHECK(dem::coordination(scene).mean > 3.0);
}

TEST_CASE("the volume that two spheres share: touching, inside, halves, a plane cut") {
  CHECK(dem::shared_volume(1.0, 2.0, 3.0) == 0.0);
  CHECK(dem::shared_volume(1.0, 2.0, 0.5) == Approx(4.0 / 3.0 * pi_).epsilon(1e-15));
  // Two unit spheres a radius apart: two caps of height 1/2, pi h^2 (3 - h) / 3 each.
  CHECK(dem::shared_volume(1.0, 1.0, 1.0) == Approx(2.0 * pi_ * 0.25 * 2.5 / 3.0).epsilon(1e-15));
  // A small sphere whose centre is on a sphere a thousand times as large: half its volume, less 3/8 r/R of it.
  CHECK(dem::shared_volume(1.0, 1e-3, 1.0) == Approx(2.0 / 3.0 * pi_ * 1e-9 * (1.0 - 3.0 / 8.0 * 1e-3)).epsilon(1e-6));
}

TEST_CASE("porosity of a simple cubic lattice in a large sphere is 1 - pi/6") {
  dem::Balls balls;
  constexpr int half = 12;
  for (int x = -half; x <= half; ++x)
    for (int y = -half; y <= half; ++y)
      for (int z = -half; z <= half; ++z) balls.add({sphere(granite, 0.5), V(x, y, z)});
  // The mean over places of the centre is exact; that over eight places in a sphere of ten diameters is right to some 1e-3.
  double sum = 0.0;
  Random random(1);
  for (int i = 0; i < 8; ++i)
    sum += dem::porosity_in_sphere(balls, V(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)), 10.0);
  CHECK(sum / 8.0 == Approx(1.0 - pi_ / 6.0).margin(2e-3));
}

TEST_CASE("a vessel goes on from a checkpoint with the same bits") {
  Random random(7);
  Scene scene = vessel(random, 60);
  scene.walls[2].radial_velocity = -0.05;
  scene.time_step = 2e-6;
  for (int step = 0; step < 300; ++step) scene.step();
  const std::string file = (std::filesystem::temp_directory_path() / "contactlaws_test_vessel.json").string();
  dem::save(file, scene);
  Random same(7);
  Scene restored = vessel(same, 60);
  dem::restore(file, restored);
  std::filesystem::remove(file);
  for (int step = 0; step < 500; ++step) {
    scene.step();
    restored.step();
  }
  CHECK(restored.walls[2].radius == scene.walls[2].radius);
  CHECK(restored.walls[2].normal_force == scene.walls[2].normal_force);
  bool same_bits = true;
  for (std::size_t b = 0; b < 60; ++b) same_bits = same_bits && restored.balls.position[b] == scene.balls.position[b];
  CHECK(same_bits);
}

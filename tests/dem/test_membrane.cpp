// The membrane of examples/ballast/probe: its tension under pressure, and what it passes on.
#include "ballast/probe/membrane.hpp"
#include "ballast/probe/micro.hpp"
#include "ballast/probe/packing.hpp"
#include "catch.hpp"

using namespace probe;

namespace {

constexpr double radius = 0.1, pressure = -200.0;  // inflated, so that all bonds are in tension [m], [Pa]

/// A membrane of equilateral triangles around nothing.
MembraneSettings even(int around, int rows, double& height) {
  MembraneSettings settings;
  settings.around = around;
  settings.rows = rows;
  const double spacing = 2.0 * contactlaws::pi<double>() * (radius + settings.sphere_radius) / around;
  height = spacing * std::sqrt(0.75) * (rows - 1);
  return settings;
}

/// Tension per length [N/m] across the level z, and around (across half planes through the axis) between two levels.
double axial_tension(const Membrane& membrane, double z) {
  double sum = 0.0, distance = 0.0;
  const auto& x = membrane.scene.balls.position;
  for (const Membrane::Bond& bond : membrane.bonds) {
    const Vec3 along = x[bond.two] - x[bond.one];
    if ((x[bond.one].z() - z) * (x[bond.two].z() - z) < 0.0)
      sum += membrane.tension(bond) * std::abs(along.z()) / along.norm();
  }
  for (std::size_t b = 0; b < membrane.spheres(); ++b)
    distance += std::hypot(x[b].x(), x[b].y()) / static_cast<double>(membrane.spheres());
  return sum / (2.0 * contactlaws::pi<double>() * distance);
}
double hoop_tension(const Membrane& membrane, double low, double high) {
  double sum = 0.0;
  const auto& x = membrane.scene.balls.position;
  for (const Membrane::Bond& bond : membrane.bonds) {
    const Vec3 one = x[bond.one], two = x[bond.two];
    const double z = (one.z() + two.z()) / 2.0;
    if (z < low || z > high || one.x() * two.x() > 0.0) continue;
    sum += membrane.tension(bond) * std::abs((two - one).x()) / (two - one).norm();
  }
  return sum / 2.0 / (high - low);
}

/// A scene without grains, whose last step took so long [s].
dem::Simulation<Boundary> no_grains(double last_step) {
  dem::Simulation<Boundary> scene(boundary_law());
  scene.last_step = last_step;
  return scene;
}

/// Inflates the membrane; the top row is held, or carries the pressure on a lid.
Membrane inflated(const MembraneSettings& settings, double height, bool lid, double& distance) {
  Membrane membrane(settings, radius, height);
  dem::Clumps none;
  dem::Simulation<Boundary> grains = no_grains(5e-5);
  const dem::Wall bottom{{}, Vec3::Zero(), Vec3::UnitZ()};
  dem::Wall top{{}, {0.0, 0.0, height}, -Vec3::UnitZ()};
  distance = radius + settings.sphere_radius;
  for (int i = 0; i < 20000; ++i) {
    if (lid) {
      const double middle = membrane.scene.balls.position[membrane.spheres() / 2].head<2>().norm();
      const double lacking = -pressure * middle / 2.0 - axial_tension(membrane, height * 0.497);
      top.velocity.z() = 2e-3 * lacking;
    }
    membrane.step(grains, none, pressure, bottom, top);
  }
  distance = membrane.scene.balls.position[membrane.spheres() / 2].head<2>().norm();
  return membrane;
}

}  // namespace

TEST_CASE("an inflated membrane: hoop tension p R, axial tension p R / 2 under a lid, p R / 3 between fixed ends") {
  double height = 0.0, distance = 0.0;
  const MembraneSettings settings = even(36, 41, height);
  const bool lid = GENERATE(false, true);
  const Membrane membrane = inflated(settings, height, lid, distance);
  // Whole rows of spheres: between levels in the middle of triangles.
  const double row = height / 40.0;
  CHECK(hoop_tension(membrane, 15.25 * row, 25.25 * row) == Approx(-pressure * distance).epsilon(0.02));
  // Triangular lattices have Poisson's ratio 1/3. The lid carries p R / 2.
  CHECK(axial_tension(membrane, height * 0.497) ==
        Approx(-pressure * distance / (lid ? 2.0 : 3.0)).epsilon(lid ? 0.02 : 0.05));
}

TEST_CASE("the highest row of the membrane follows a platen that tilts") {
  double height = 0.0;
  const MembraneSettings settings = even(36, 11, height);
  Membrane membrane(settings, radius, height);
  dem::Clumps none;
  dem::Simulation<Boundary> grains = no_grains(1e-5);
  const dem::Wall bottom{{}, Vec3::Zero(), Vec3::UnitZ()};
  dem::Wall top{{}, {0.0, 0.0, height}, -Vec3::UnitZ()};
  top.spin = {0.3, -0.2, 0.0};
  constexpr int steps = 100;
  for (int i = 0; i < steps; ++i) {
    membrane.step(grains, none, 0.0, bottom, top);
    top.move(grains.last_step);
  }
  for (std::size_t i = membrane.spheres() - 36; i < membrane.spheres(); ++i) {
    // Still in the plane of the platen: the step's error is (spin x time)^2 of the distance, 1e-8 m.
    const Vec3 from_centre = membrane.scene.balls.position[i] - top.point;
    CHECK(from_centre.dot(top.facing) == Approx(0.0).margin(1e-8));
  }
  CHECK(Vec3(membrane.scene.balls.position[0]).z() == 0.0);
}

TEST_CASE("the membrane weighs what 4 mm of rubber weigh, and has 12 600 spheres") {
  const Membrane membrane(MembraneSettings{}, 0.15, 0.45);
  CHECK(membrane.spheres() == 12600);
  double mass = 0.0;
  for (std::size_t b = 0; b < membrane.spheres(); ++b) mass += membrane.scene.balls.mass[b];
  const double volume = 2.0 * contactlaws::pi<double>() * 0.152 * 4e-3 * 0.45;
  CHECK(mass / volume > 900.0);
  CHECK(mass / volume < 1300.0);
}

TEST_CASE("the pressure presses the membrane onto the platens, not past them") {
  // Between two platens stands one grain, a ball that touches them in their centres: wide voids at foot and head.
  constexpr double outside = 150e3, height = 2.0 * radius;
  MembraneSettings settings;
  settings.around = 100;
  settings.rows = 38;
  settings.reach = radius;
  Membrane membrane(settings, radius, height);
  dem::Simulation<Boundary> grains = no_grains(5e-6);
  dem::Clumps clumps;
  clumps.add(grains, dem::clump_shape({{Vec3::Zero(), radius}}), granite, {0.0, 0.0, radius});
  clumps.start(grains);
  membrane.surround(grains);
  const dem::Wall bottom{{}, Vec3::Zero(), Vec3::UnitZ()}, top{{}, {0.0, 0.0, height}, -Vec3::UnitZ()};
  for (int i = 0; i < 6000; ++i) membrane.step(grains, clumps, outside, bottom, top);
  const double lattice = 2.0 * contactlaws::pi<double>() * radius / settings.around * height / (settings.rows - 1);
  const double overlap = outside * lattice / settings.contact_stiffness;  // of a sphere that carries its own pressure
  std::size_t lying = 0;
  for (auto b = static_cast<std::size_t>(settings.around);
       b < membrane.spheres() - static_cast<std::size_t>(settings.around); ++b) {
    const double z = membrane.scene.balls.position[b].z(), gap = std::min(z, height - z) - settings.sphere_radius;
    CHECK(gap > -5.0 * overlap);  // a neighbour's share too, where the membrane is stretched or turns off the platen
    if (gap < 0.0) ++lying;
  }
  CHECK(lying > 100);
}

TEST_CASE("the membrane passes its pressure on to the grains") {
  // A clump as wide as a cylinder would be is too simple; grains of a small sample do.
  SampleSize size;
  size.diameter = 0.12;
  size.height = 0.18;
  const std::vector<dem::ClumpShape> shapes = unit_clumps();
  const Sample sample = make_sample(size, shapes);
  Specimen<Hertz> specimen(make_law<Hertz>(friction), boundary_law(), shapes, sample);
  MembraneSettings settings;
  settings.around = 60;
  settings.rows = 34;
  specimen.add_membrane(settings);
  specimen.clumps.start(specimen.scene);
  specimen.scene.time_step = 0.5 * dem::stable_time_step(specimen.scene, specimen.clumps, nominal_stiffness(50e3));
  specimen.vessel.pressure = 20e3;
  specimen.vessel.top_moves = true;
  for (int i = 0; i < 12000; ++i) specimen.step();
  Vec3 sum = Vec3::Zero();
  double inward = 0.0;
  for (const dem::Clump& clump : specimen.clumps.all) sum += clump.force;
  const auto& balls = specimen.membrane->scene.balls;
  for (std::size_t b = specimen.membrane->spheres(); b < balls.size(); ++b)
    inward -= Vec3(balls.force[b]).dot(Vec3(balls.position[b].x(), balls.position[b].y(), 0.0).normalized());
  const double area = specimen.vessel.lateral_area(specimen.scene);
  CHECK(inward / area == Approx(20e3).epsilon(0.15));  // the clamped rows carry a part
  CHECK(specimen.membrane->mean_stretch() < 1.1);
  CHECK(Vec3(sum.x(), sum.y(), 0.0).norm() < 0.05 * inward);

  // In motion too, the stress of all contacts less that from outside is the sum of unbalanced forces times places.
  const Micro micro = observe(specimen, 1.0);
  Eigen::Matrix3d unbalanced = Eigen::Matrix3d::Zero();
  for (const dem::Clump& clump : specimen.clumps.all)
    unbalanced += clump.force * clump.position.transpose() / specimen.vessel.volume(specimen.scene);
  const Eigen::Matrix3d difference = micro.stress + micro.outer_part - micro.outside - unbalanced;
  CHECK(difference.norm() < 1e-10 * micro.outside.norm());  // sums of some 1000 terms
}

// Clumps of examples/dem: their shape, their motion, and what their pebbles feel.
#include "catch.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "examples/dem/clumps.hpp"
#include "make_laws.hpp"
#include "random.hpp"

using namespace contactlaws;
using contactlaws::test::Random;
using dem::Ball;
using dem::Clump;
using dem::Clumps;
using dem::Pebble;
using V = dem::Vec3;

namespace {

const ElasticMaterial<double> soft{5e6, 0.3, 2500.0};

/// Three different principal moments of inertia.
dem::ClumpShape pebbles() {
  return dem::clump_shape({{{0.0, 0.0, 0.0}, 4e-3}, {{5e-3, 1e-3, 0.0}, 3e-3}, {{-2e-3, 4e-3, 1e-3}, 2e-3}}, 40);
}

template <class Scene>
Scene boxed(const DryHill<double>& law, double edge) {
  Scene scene(law);
  scene.log = nullptr;
  for (const dem::Wall& wall : dem::box_of_walls(plane(soft), V::Zero(), V::Constant(edge))) scene.add(wall);
  scene.time_step = 5e-6;
  return scene;
}
using Scene = dem::Simulation<DryHill<double>>;

Eigen::Quaterniond random_orientation(Random& random) {
  const double angle = random.uniform(0.0, 3.0);
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, random.direction()));
}

/// Clumps that fly apart and together in a box.
void add_flying(Clumps& clumps, Scene& scene, double edge, double speed) {
  Random random(5);
  for (int x = 0; x < 2; ++x)
    for (int y = 0; y < 2; ++y)
      for (int z = 0; z < 2; ++z) {
        const V where = V::Constant(edge / 4.0) + V(x, y, z) * (edge / 2.0);
        const int id = clumps.add(scene, pebbles(), soft, where, random_orientation(random));
        const V velocity = speed * random.direction();
        const V spin = 100.0 * random.direction();
        clumps.set_motion(static_cast<std::size_t>(id), velocity, spin);
      }
}

struct Sums {
  V momentum = V::Zero(), angular_momentum = V::Zero();
  double energy = 0.0;
};
Sums sums(const Clumps& clumps) {
  Sums total;
  for (const Clump& c : clumps.all) {
    total.momentum += c.mass * c.velocity;
    total.angular_momentum += c.angular_momentum + c.mass * c.position.cross(c.velocity);
    total.energy += c.kinetic_energy();
  }
  return total;
}

}  // namespace

// Shape ---------------------------------------------------------------------------------------------------------------

TEST_CASE("volume and inertia of a clump are those of closed forms") {
  const double r = 3e-3, volume = sphere_mass(r, 1.0), own = 0.4 * volume * r * r;
  SECTION("one pebble: exactly") {
    const dem::ClumpShape shape = dem::clump_shape({{{1.0, 2.0, 3.0}, r}});
    CHECK(shape.volume == volume);
    CHECK(shape.inertia == V::Constant(own));
    CHECK(shape.pebbles[0].centre == V::Zero());
    CHECK(shape.reach == r);
  }
  SECTION("a sphere, counted") {
    const dem::ClumpShape shape = dem::clump_shape({{{0.1, 0.2, 0.3}, r}, {{0.1, 0.2, 0.3}, 0.5 * r}});
    CHECK(shape.volume == Approx(volume).epsilon(2e-3));
    for (int i = 0; i < 3; ++i) CHECK(shape.inertia[i] == Approx(own).epsilon(2e-3));
    CHECK(shape.pebbles[0].centre.norm() < 1e-3 * r);
  }
  SECTION("two spheres of different size that touch, along no axis") {
    const double s = 2e-3, other = sphere_mass(s, 1.0);
    const V along = V(1.0, 2.0, -1.0).normalized();
    const dem::ClumpShape shape = dem::clump_shape({{V::Zero(), r}, {along * (r + s), s}});
    const double across = own + 0.4 * other * s * s + volume * other / (volume + other) * (r + s) * (r + s);
    CHECK(shape.volume == Approx(volume + other).epsilon(2e-3));
    CHECK(shape.inertia[0] == Approx(own + 0.4 * other * s * s).epsilon(4e-3));
    CHECK(shape.inertia[1] == Approx(across).epsilon(4e-3));
    CHECK(shape.inertia[2] == Approx(across).epsilon(4e-3));
    // The principal axis of least inertia is x.
    const V branch = shape.pebbles[1].centre - shape.pebbles[0].centre;
    CHECK(branch.norm() == Approx(r + s).epsilon(1e-12));
    CHECK(std::abs(branch.x()) == Approx(r + s).epsilon(1e-3));
    CHECK(shape.pebbles[0].centre.norm() == Approx(other / (volume + other) * (r + s)).epsilon(4e-3));
  }
  SECTION("scaled") {
    const dem::ClumpShape shape = pebbles(), twice = shape.scaled(2.0);
    CHECK(twice.volume == Approx(8.0 * shape.volume));
    CHECK(twice.inertia[1] == Approx(32.0 * shape.inertia[1]));
    CHECK(twice.reach == 2.0 * shape.reach);
  }
  CHECK_THROWS_WITH(dem::clump_shape({}), ContainsSubstring("pebbles"));
  CHECK_THROWS_WITH(dem::clump_shape({{V::Zero(), -1.0}, {V::Zero(), 1.0}}), ContainsSubstring("radius"));
}

// Motion --------------------------------------------------------------------------------------------------------------

TEST_CASE("a clump of one pebble moves as a ball, to the bit") {
  const double edge = 0.02, radius = 3e-3;
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.1);
  Scene balls = boxed<Scene>(law, edge), scene = boxed<Scene>(law, edge);
  Clumps clumps;
  const double damping = GENERATE(0.0, 0.7);
  for (Scene* one : {&balls, &scene}) {
    one->gravity = {0.0, 0.0, -9.81};
    one->local_damping = damping;
  }
  const V starts[] = {{5e-3, 6e-3, 5e-3}, {12e-3, 7e-3, 5e-3}, {9e-3, 9e-3, 13e-3}};
  for (const V& start : starts) {
    const V velocity = V::Constant(1e-2) - start, spin(30.0, -40.0, 20.0);
    balls.add(Ball{sphere(soft, radius), start, 100.0 * velocity, spin});
    const int id = clumps.add(scene, dem::clump_shape({{V::Zero(), radius}}), soft, start);
    clumps.set_motion(static_cast<std::size_t>(id), 100.0 * velocity, spin);
  }
  double contact = 0.0;
  for (int step = 0; step < 3000; ++step) {
    balls.step();
    clumps.step(scene);
    for (const dem::Row& force : balls.balls.force) contact += force.norm();
  }
  CHECK(contact > 0.0);
  clumps.place_all(scene);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(clumps.all[i].position == balls.balls.position[i]);
    CHECK(clumps.all[i].velocity == balls.balls.velocity[i]);
    CHECK(clumps.all[i].spin == balls.balls.spin[i]);
    CHECK(scene.balls.position[i] == balls.balls.position[i]);
  }
}

TEST_CASE(
    "a free clump keeps momentum and angular momentum; the error of its energy and of its turn falls with the step "
    "squared") {
  const auto tumble = [](int steps) {
    Scene scene(test::dry_hill<double>(0.4));
    Clumps clumps;
    clumps.add(scene, pebbles(), soft, V::Zero());
    clumps.set_motion(0, {1.0, 2.0, 3.0}, {100.0, 300.0, -50.0});
    scene.time_step = 0.1 / steps;
    const Clump before = clumps.all[0];
    double error = 0.0;
    const Clump& now = clumps.all[0];
    for (int i = 0; i < steps; ++i) {
      clumps.step(scene);
      error = std::max(error, std::abs(now.kinetic_energy() / before.kinetic_energy() - 1.0));
    }
    CHECK(now.velocity == before.velocity);
    CHECK(now.angular_momentum == before.angular_momentum);
    CHECK((now.position - V(0.1, 0.2, 0.3)).norm() < 1e-12);
    return std::make_pair(now.orientation, error);
  };
  const auto exact = tumble(64000), coarse = tumble(1000), fine = tumble(2000);
  const double error = coarse.first.angularDistance(exact.first), error_fine = fine.first.angularDistance(exact.first);
  CHECK(error > 1e-5);  // the test sees something
  CHECK(error / error_fine == Approx(4.0).epsilon(0.1));
  CHECK(coarse.second < 1e-4);
  CHECK(coarse.second / fine.second == Approx(4.0).epsilon(0.1));
}

TEST_CASE("colliding clumps keep momentum and angular momentum to rounding, and energy with the step squared") {
  const auto error_of_energy = [](double time_step) {
    Scene scene(test::dry_hill<double>(0.0));
    Clumps clumps;
    add_flying(clumps, scene, 0.03, 0.0);
    for (Clump& c : clumps.all) c.velocity = 200.0 * (V::Constant(0.015) - c.position) + V(0.1, 0.2, 0.3);
    scene.time_step = time_step;
    const Sums before = sums(clumps);
    double contact = 0.0;
    const int steps = static_cast<int>(std::lround(0.01 / time_step));
    for (int i = 0; i < steps; ++i) {
      clumps.step(scene);
      contact += clumps.all[0].force.norm();
    }
    CHECK(contact > 0.0);
    CHECK(clumps.all[0].force.norm() == 0.0);  // and apart again
    const Sums after = sums(clumps);
    CHECK((after.momentum - before.momentum).norm() < 1e-12 * before.momentum.norm());
    CHECK((after.angular_momentum - before.angular_momentum).norm() < 1e-12 * before.angular_momentum.norm());
    return std::abs(after.energy / before.energy - 1.0);
  };
  const double coarse = error_of_energy(2e-6), fine = error_of_energy(5e-7);
  INFO(coarse << ' ' << fine);
  CHECK(coarse < 1e-3);
  CHECK(fine < coarse / 8.0);  // 16 for a force without kinks
}

// Contacts ------------------------------------------------------------------------------------------------------------

TEST_CASE("pebbles of one clump do not touch each other") {
  Scene scene(test::dry_hill<double>(0.4));
  Clumps clumps;
  clumps.add(scene, pebbles(), soft, V::Zero());
  clumps.add(scene, pebbles(), soft, {9.9e-3, 0.0, 0.0});
  scene.log = nullptr;
  clumps.start(scene);
  REQUIRE(scene.ball_contacts.size() > 0);
  for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
    CHECK(scene.balls.group[scene.ball_contacts.first(c)] != scene.balls.group[scene.ball_contacts.second(c)]);
}

TEST_CASE("clumps do not depend on when neighbours were listed, to the last bit") {
  const double edge = 0.05;
  Scene always = boxed<Scene>(test::dry_hill<double>(0.4, 0.1), edge), seldom = always;
  always.skin = 1e-9;
  seldom.skin = 1.0;
  Clumps one, other;
  add_flying(one, always, edge, 5.0);
  add_flying(other, seldom, edge, 5.0);
  double contact = 0.0;
  for (int step = 0; step < 4000; ++step) {
    one.step(always);
    other.step(seldom);
    contact += one.all[0].force.norm();
  }
  CHECK(contact > 0.0);
  CHECK(always.listings > 10 * seldom.listings);
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one.all[i].position == other.all[i].position);
    CHECK(one.all[i].angular_momentum == other.all[i].angular_momentum);
  }
}

TEST_CASE(
    "a clump that lands on two pebbles at once: restitution asked .5 gives .366, and .500 if they share the mass") {
  const auto restitution = [](double mass_share) {
    Scene scene(test::dry_hill<double>(0.0, damping_constant(0.5, Spring::hertz, Tension::allowed)));
    scene.add(dem::Wall{plane(soft), V::Zero(), V::UnitZ()});
    Clumps clumps;
    const dem::ClumpShape two = dem::clump_shape({{{-3e-3, 0.0, 0.0}, 3e-3}, {{3e-3, 0.0, 0.0}, 3e-3}}, 60);
    clumps.add(scene, two, soft, {0.0, 0.0, 3.001e-3}, Eigen::Quaterniond::Identity(), mass_share);
    clumps.all[0].velocity = {0.0, 0.0, -1.0};
    scene.time_step = 1e-7;
    for (int step = 0; step < 40000 && !(clumps.all[0].position.z() > 3.001e-3 && step > 100); ++step)
      clumps.step(scene);
    return clumps.all[0].velocity.z();
  };
  CHECK(restitution(1.0) == Approx(0.366).epsilon(2e-3));
  CHECK(restitution(0.5) == Approx(0.500).epsilon(2e-3));
}

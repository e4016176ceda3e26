// The integrator of examples/dem: neighbours, conservation, motion, input, files. Closed forms: test_impact.cpp.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/laws.hpp"
#include "examples/dem/checkpoint.hpp"
#include "examples/dem/output.hpp"
#include "examples/dem/settle.hpp"
#include "make_laws.hpp"
#include "random.hpp"

using namespace contactlaws;
using contactlaws::test::Random;
using dem::Ball;
using dem::Pair;
using V = dem::Vec3;

namespace {

const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
const ElasticMaterial<double> soft{5e6, 0.3, 2500.0};

using Scene = dem::Simulation<Hill<double>, LinearFriction<double>>;

LinearFriction<double> linear(double modulus) {
  LinearFriction<double> law;
  law.normal.modulus = modulus;
  law.shear.friction = 0.4;
  return law;
}

/// Balls of 1 to 5 mm that move at random in a box, without overlaps at the start.
std::vector<Ball> cloud(Random& random, int count, double edge, double speed) {
  std::vector<Ball> balls;
  while (static_cast<int>(balls.size()) < count) {
    const double radius = random.uniform(1e-3, 5e-3);
    const auto coordinate = [&] { return random.uniform(radius, edge - radius); };
    const V position(coordinate(), coordinate(), coordinate());
    const bool free = std::all_of(balls.begin(), balls.end(), [&](const Ball& other) {
      return (other.position - position).norm() > other.side.radius + radius;
    });
    if (free) balls.push_back({sphere(soft, radius), position, speed * random.direction(), 100.0 * random.direction()});
  }
  return balls;
}

Scene rushing_cloud(const std::vector<Ball>& balls, double edge) {
  Scene scene(test::hill<double>(0.4, 1e3, 0.1), linear(5e6));
  for (const dem::Wall& wall : dem::box_of_walls(plane(soft), V::Zero(), V::Constant(edge))) scene.add(wall);
  for (const Ball& ball : balls) scene.add(ball);
  scene.gravity = {0.0, 0.0, -9.81};
  scene.time_step = 5e-6;
  return scene;
}

template <class Position>
std::set<std::pair<int, int>> near_by_brute_force(const std::vector<Position>& x, const std::vector<double>& radius,
                                                  double reach) {
  std::set<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j)
      if ((x[j] - x[i]).norm() - radius[i] - radius[j] <= reach)
        pairs.insert({static_cast<int>(i), static_cast<int>(j)});
  return pairs;
}

}  // namespace

// Neighbours ----------------------------------------------------------------------------------------------------------

TEST_CASE("the neighbour search finds the pairs that comparing all pairs finds") {
  Random random;
  struct Cloud {
    int count;
    double ratio, edge, reach, stretch;
  };
  const Cloud clouds[] = {{400, 1.0, 0.1, 0.0, 1.0},    {400, 5.0, 0.1, 1e-3, 1.0},  {300, 100.0, 0.5, 1e-4, 1.0},
                          {200, 5.0, 0.02, 5e-3, 1.0},  {300, 5.0, 0.1, 1e-3, 50.0}, {1, 1.0, 0.1, 0.0, 1.0},
                          {300, 3.0, 0.05, 2e-2, 0.01}, {0, 1.0, 0.1, 0.0, 1.0}};
  for (const Cloud& cloud : clouds) {
    std::vector<V> x;
    std::vector<double> radius;
    for (int i = 0; i < cloud.count; ++i) {
      x.emplace_back(random.uniform(-1, 1) * cloud.edge, random.uniform(-1, 1) * cloud.edge,
                     random.uniform(-1, 1) * cloud.edge * cloud.stretch);
      radius.push_back(random.log_uniform(2e-3, 2e-3 * cloud.ratio * (1 + 1e-15)));
    }
    if (cloud.count > 10) x.back() = V(1e9, -1e9, 1e9);  // one that got away
    const std::vector<Pair> found = dem::find_neighbours(x, radius, cloud.reach);
    std::set<std::pair<int, int>> pairs;
    for (const Pair& p : found) pairs.insert({p.first, p.second});
    CHECK(pairs.size() == found.size());  // none twice
    CHECK(pairs == near_by_brute_force(x, radius, cloud.reach));
  }
}

TEST_CASE("a position that is not finite: the message has the ball") {
  const std::vector<V> x{V::Zero(), V(0.0, std::nan(""), 0.0)};
  CHECK_THROWS_WITH(dem::find_neighbours(x, {1.0, 1.0}, 0.0), ContainsSubstring("ball 1 is lost"));
}

TEST_CASE("in motion the active contacts are those of all pairs") {
  Random random(7);
  const double edge = 0.05;
  Scene scene = rushing_cloud(cloud(random, 80, edge, 3.0), edge);
  int touches = 0;
  for (int step = 0; step < 2000; ++step) {
    scene.step();
    std::set<std::pair<int, int>> active;
    for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
      if (scene.ball_contact(c).response.active)
        active.insert({scene.ball_contacts.bodies[c].first, scene.ball_contacts.bodies[c].second});
    touches += static_cast<int>(active.size());
    REQUIRE(active == near_by_brute_force(scene.balls.position, scene.balls.radius, 0.0));
  }
  CHECK(touches > 2000);  // the test saw something
  for (const V& x : scene.balls.position) CHECK(((x.array() > 0.0) && (x.array() < edge)).all());  // the box holds
}

// Histories -----------------------------------------------------------------------------------------------------------

TEST_CASE("results do not depend on when neighbours were listed, to the last bit") {
  Random random(11);
  const double edge = 0.05;
  const std::vector<Ball> balls = cloud(random, 60, edge, 2.0);
  Scene always = rushing_cloud(balls, edge), seldom = rushing_cloud(balls, edge);
  always.skin = 1e-9;  // lists at every step
  seldom.skin = 3.0;
  for (Scene* scene : {&always, &seldom})
    for (int step = 0; step < 3000; ++step) scene->step();
  for (std::size_t b = 0; b < balls.size(); ++b) {
    CHECK(always.balls.position[b] == seldom.balls.position[b]);
    CHECK(always.balls.spin[b] == seldom.balls.spin[b]);
  }
}

TEST_CASE("a bridge keeps its history across listings until it ruptures") {
  dem::Simulation<Hill<double>> scene(test::hill<double>(0.4, 200e3, 0.0));
  scene.add(Ball{sphere(granite, 7.5e-3), V::Zero(), V::Zero(), V::Zero(), false});
  const int top = scene.add(Ball{sphere(granite, 5e-3), {0.0, 0.0, 12.5e-3}, V::Zero(), V::Zero(), false});
  scene.skin = 1e-6;
  scene.start();
  scene.make_wet(0.0);
  scene.drive(top, V::UnitZ());
  scene.time_step = 1e-5;
  for (int step = 1; step < 1000; ++step) {
    scene.step();
    const double expected = 200e3 * pi<double>() * 25e-6 * std::exp(-step * 1e-5 / 10e-3);
    REQUIRE(scene.ball_contact(0).response.bridge_force == Approx(expected).epsilon(1e-9));
  }
  for (int step = 0; step < 10; ++step) scene.step();
  CHECK(scene.ball_contacts.size() == 0);

  scene.skin = 3.0;
  scene.drive(top, -V::UnitZ());
  for (int step = 0; step < 20; ++step) scene.step();  // to a gap of 9.9 mm
  REQUIRE(scene.ball_contacts.size() == 1);
  CHECK(scene.ball_contacts.state(0).moisture == 0.0);  // a new contact, dry
  CHECK_FALSE(scene.ball_contact(0).response.active);
  scene.make_wet(9e-3);
  CHECK(scene.ball_contacts.state(0).moisture == 0.0);
  scene.make_wet(9.95e-3);
  scene.step();
  CHECK(scene.ball_contact(0).response.active);
  scene.drive(top, V::UnitZ());
  for (int step = 0; step < 20; ++step) scene.step();
  REQUIRE(scene.ball_contacts.size() == 1);             // still listed
  CHECK(scene.ball_contacts.state(0).moisture == 1.0);  // dry after rupture, as the law says
  CHECK_FALSE(scene.ball_contact(0).response.active);
}

TEST_CASE("starting a scene and measuring it changes no history and no body") {
  Random random(3);
  Scene scene = rushing_cloud(cloud(random, 20, 0.04, 1.0), 0.04);
  const Scene before = scene;
  for (int i = 0; i < 3; ++i) {
    scene.start();
    dem::stable_time_step(scene);
    dem::unbalanced_ratio(scene);
  }
  CHECK(scene.time == 0.0);
  for (std::size_t b = 0; b < before.balls.size(); ++b) CHECK(scene.balls.position[b] == before.balls.position[b]);
  for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c)
    CHECK(scene.wall_contacts.state(c).shear == std::array<double, 3>{});
}

TEST_CASE("a restored scene goes on bit for bit") {
  Random random(5);
  const std::vector<Ball> balls = cloud(random, 40, 0.04, 2.0);
  Scene scene = rushing_cloud(balls, 0.04);
  const auto slides_on_a_wall = [&scene] {
    for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c)
      if (scene.wall_contacts.state(c).shear != std::array<double, 3>{}) return true;
    return false;
  };
  while (scene.steps < 1500 || !slides_on_a_wall()) scene.step();
  const std::string file = (std::filesystem::temp_directory_path() / "contactlaws_test_checkpoint.json").string();
  dem::save(file, scene);
  Scene restored = rushing_cloud(balls, 0.04);
  restored.log = nullptr;  // which would warn of overlaps in mid-impact
  dem::restore(file, restored);
  std::filesystem::remove(file);
  for (Scene* s : {&scene, &restored})
    for (int step = 0; step < 500; ++step) s->step();
  CHECK(restored.time == scene.time);
  for (std::size_t b = 0; b < balls.size(); ++b) CHECK(restored.balls.position[b] == scene.balls.position[b]);

  Scene other = rushing_cloud({balls[0]}, 0.04);
  CHECK_THROWS_WITH(dem::restore("/nowhere", other), ContainsSubstring("cannot read /nowhere"));
}

// Conservation --------------------------------------------------------------------------------------------------------

TEST_CASE("forces and torques balance") {
  Random random(13);
  Scene scene = rushing_cloud(cloud(random, 80, 0.05, 3.0), 0.05);
  for (int step = 0; step < 1000; ++step) {
    scene.step();
    V force = V::Zero(), torque = V::Zero();  // of the whole scene, about the origin
    double size = 0.0;
    for (const dem::Wall& wall : scene.walls) force += wall.force;
    for (std::size_t b = 0; b < scene.balls.size(); ++b) {
      force += scene.balls.force[b];
      torque += scene.balls.torque[b] + scene.balls.position[b].cross(scene.balls.force[b]);
      size += scene.balls.force[b].norm();
    }
    for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c) {
      if (!scene.wall_contact(c).response.active) continue;
      const V at = scene.balls.position[scene.wall_contacts.second(c)] + scene.wall_contact(c).geometry.arm2;
      torque -= at.cross(scene.wall_contact(c).response.force);
    }
    CHECK(force.norm() <= 1e-14 * size);
    CHECK(torque.norm() <= 1e-14 * 0.05 * size);  // the two arms of a contact end in one point
  }
}

TEST_CASE("a bounce without damping keeps its energy, to the square of the step") {
  const double height = 5e-3, radius = 5e-3;
  std::vector<double> errors;
  for (const double step : {4e-6, 2e-6, 1e-6}) {
    dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.0));
    scene.add(dem::Wall{plane(soft), V::Zero(), V::UnitZ()});
    scene.add(Ball{sphere(soft, radius), {0.0, 0.0, radius + height}});
    scene.gravity = {0.0, 0.0, -9.81};
    scene.time_step = step;
    double highest = 0.0;
    int landings = 0;
    for (double before = 1.0; landings < 3;) {  // the highest point after the second bounce
      scene.step();
      const double z = scene.balls.position[0].z();
      if (z < radius && before >= radius) ++landings;
      if (landings == 2) highest = std::max(highest, z - radius);
      before = z;
    }
    errors.push_back(std::abs(highest / height - 1.0));
  }
  CHECK(errors.back() < 1e-6);
  CHECK(errors[0] / errors[2] >
        8.0);  // 16 for second order; the moment of touch falls between steps, differently each time
}

TEST_CASE("shear does not creep while a grain vibrates at a slant") {
  // On a straight line and back the slip must sum to zero. Velocities of the half step, projected on the contact plane of the
  // full step, would add v_n v_t dt^2 / (2 (R1 + R2)) of slip per step, always in one direction. (A law that stores the force
  // adds a creep of v_n v_t dt^2 / (4 o), since it takes the stiffness of the end of the step.)
  using Law = ContactLaw<Hertz<double>, NoDashpots<double>, ShearDisplacement<double>>;
  Law law;
  law.shear.friction = 1e6;
  dem::Simulation<Law> scene(law);
  const double radius = 1e-3, amplitude = 2e-6;
  scene.add(Ball{sphere(granite, radius), V::Zero(), V::Zero(), V::Zero(), false});
  const int top = scene.add(Ball{sphere(granite, radius), {0.0, 0.0, 2 * radius - 1e-5}, V::Zero(), V::Zero(), false});
  const V line = V(1.0, 0.0, 1.0).normalized();
  scene.time_step = 1e-7;
  const int steps = 40, cycles = 500;
  const V start = scene.balls.position[1];
  double largest = 0.0, crept = 0.0;
  for (int step = 1; step <= steps * cycles; ++step) {
    const V target = start + line * (amplitude * std::sin(2 * pi<double>() * step / steps));
    scene.drive(top, (target - scene.balls.position[1]) / scene.time_step);
    scene.step();
    const V force = scene.ball_contact(0).response.force;
    largest = std::max(largest, std::abs(force.x()));
    crept = force.x();
  }
  // By that formula 500 cycles would creep by 0.12 um, a twelfth of the amplitude in shear.
  CHECK(std::abs(crept) < 0.02 * largest);
}

TEST_CASE("results depend on the order of the balls by rounding only") {
  Random random(17);
  const double edge = 0.05;
  const std::vector<Ball> balls = cloud(random, 60, edge, 2.0);
  std::vector<std::size_t> order(balls.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), random.engine);
  std::vector<Ball> shuffled;
  for (const std::size_t b : order) shuffled.push_back(balls[b]);
  Scene one = rushing_cloud(balls, edge), two = rushing_cloud(shuffled, edge);
  for (Scene* scene : {&one, &two})
    for (int step = 0; step < 1500; ++step) scene->step();
  double farthest = 0.0;
  for (std::size_t b = 0; b < balls.size(); ++b)
    farthest = std::max(farthest, (one.balls.position[order[b]] - two.balls.position[b]).norm());
  CHECK(farthest <
        1e-11);  // each collision magnifies rounding (1e-18 m) by about d/R: some thousand in three collisions
}

// Motion --------------------------------------------------------------------------------------------------------------

TEST_CASE("local damping takes its share of each component, against the motion") {
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.0));
  scene.add(Ball{sphere(granite, 5e-3), V::Zero(), {0.0, 1.0, 1.0}});
  scene.gravity = {-10.0, -10.0, 10.0};
  scene.local_damping = 0.7;
  scene.time_step = 1e-3;
  scene.step();  // half a step's kick: from rest in x undamped, against the motion in y, with it in z
  CHECK(scene.balls.velocity[0].isApprox(V(-5e-3, 1.0 - 8.5e-3, 1.0 + 1.5e-3), 1e-12));
}

TEST_CASE("a driven wall takes balls along, and fixed balls stay") {
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.0));
  const int wall = scene.add(dem::Wall{plane(soft), V::Zero(), V::UnitZ()});
  const int fixed = scene.add(Ball{sphere(soft, 5e-3), {0.0, 0.0, 40e-3}, V::Zero(), V::Zero(), false});
  scene.add(Ball{sphere(soft, 5e-3), {0.0, 0.0, 12e-3}});  // 7 mm away: not listed at first
  scene.drive_wall(wall, V::UnitZ());
  scene.time_step = 1e-6;
  while (scene.time < 9e-3) scene.step();
  CHECK(scene.walls[0].point.z() == Approx(9e-3).epsilon(1e-3));
  CHECK(scene.balls.position[1].z() > 14e-3);
  CHECK(scene.balls.position[static_cast<std::size_t>(fixed)] == V(0.0, 0.0, 40e-3));
}

TEST_CASE("the stable step is stable, and 1.6 times of it is not") {
  // A row of 30 balls between two walls, under uniform compression, then disturbed. In the fastest mode of a long row
  // neighbours move against each other: sum k = 2 k, w^2 = 4 k/m, so central differences are stable up to
  // 2/w = sqrt(m/k) = sqrt(2) estimates; 1.5 here, since the stiffer contacts at the walls determine the estimate.
  const auto growth = [](double share) {
    dem::Simulation<SmoothHertz<double>> scene(SmoothHertz<double>{});
    const double radius = 1e-3, overlap = 1e-6, spacing = 2 * radius - overlap, disturbance = 1e-9;
    const double to_wall = radius - overlap * std::cbrt(0.5);  // R* is twice that of a pair: the same force
    scene.add(dem::Wall{plane(soft), {-to_wall, 0.0, 0.0}, V::UnitX()});
    for (int i = 0; i < 30; ++i)
      scene.add(
          Ball{sphere(soft, radius), {i * spacing, 0.0, 0.0}, {i % 2 == 0 ? disturbance : -disturbance, 0.0, 0.0}});
    scene.add(dem::Wall{plane(soft), {29 * spacing + to_wall, 0.0, 0.0}, -V::UnitX()});
    scene.time_step = share * dem::stable_time_step(scene);
    double fastest = 0.0;
    for (int step = 0; step < 2000 && fastest < 1e6 * disturbance; ++step) {
      scene.step();
      for (const V& v : scene.balls.velocity) fastest = std::max(fastest, v.norm());
    }
    return fastest / disturbance;
  };
  CHECK(growth(1.0) < 5.0);
  CHECK(growth(1.4) < 10.0);
  CHECK(growth(1.6) > 1e5);
}

TEST_CASE("a grain a hundred times smaller falls through a gap between large ones without sticking") {
  Random random(23);
  for (int trial = 0; trial < test::cases(5); ++trial) {
    const double damping = damping_constant(0.5, Spring::hertz, Tension::allowed);
    // Between two large grains that touch, the small one is in a wedge of sqrt(2 r/R) = 0.14 rad to either side. Friction
    // above its tangent would rightly hold it there.
    dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.1, damping));
    scene.gravity = {0.0, 0.0, -9.81};
    const double large = 10e-3, small = 0.1e-3;
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * pi<double>() * k / 3, distance = 2 * large / std::sqrt(3.0);
      scene.add(Ball{sphere(soft, large),
                     {distance * std::cos(angle), distance * std::sin(angle), 0.0},
                     V::Zero(),
                     V::Zero(),
                     false});
    }
    scene.add(Ball{sphere(soft, small), {large * random.uniform(-0.4, 0.4), large * random.uniform(-0.4, 0.4), large}});
    const double energy = 9.81 * 2.0 * large;  // per mass, above where it ends
    double most = 0.0;
    for (int step = 0; scene.balls.position[3].z() > -large && scene.time < 1.0; ++step) {
      if (step % 10 == 0) scene.time_step = 0.2 * dem::stable_time_step(scene);
      scene.step();
      const double kinetic =
          scene.balls.velocity[3].squaredNorm() / 2 + 0.2 * small * small * scene.balls.spin[3].squaredNorm();
      most = std::max(most, kinetic + 9.81 * (scene.balls.position[3].z() + large));
    }
    CHECK(scene.balls.position[3].z() <= -large);
    CHECK(most <= energy * 1.001);  // the potential energy of half a step
  }
}

TEST_CASE("the unbalanced ratio divides unbalanced forces and torques by normal forces and weights") {
  Scene scene(test::hill<double>(0.4, 200e3, 0.0), linear(29e6));
  scene.add(dem::Wall{plane(granite), V::Zero(), V::UnitZ()});
  scene.add(Ball{sphere(granite, 5e-3), {0.0, 0.0, 4.999e-3}, V::UnitX()});
  scene.add(Ball{sphere(granite, 7.5e-3), {0.0, 0.0, 4.999e-3 + 12.499e-3}});
  scene.gravity = {0.0, 0.0, -9.81};
  scene.time_step = 1e-9;
  scene.start();
  scene.make_wet(0.0);
  scene.step();
  const auto& pair = scene.ball_contact(0).response;
  const double at_wall = scene.wall_contact(0).response.normal_force;
  const auto unbalanced = [&scene](std::size_t b) {
    const V force = scene.balls.force[b] + scene.balls.mass[b] * scene.gravity;
    return force.norm() + scene.balls.torque[b].norm() / scene.balls.radius[b];
  };
  const double between = pair.normal_force + pair.bridge_force;
  const double load0 = at_wall + between + scene.balls.mass[0] * 9.81, load1 = between + scene.balls.mass[1] * 9.81;
  CHECK(pair.bridge_force > 15.0);
  CHECK(scene.balls.torque[0].norm() > 0.0);
  CHECK(dem::unbalanced_ratio(scene) == Approx((unbalanced(0) + unbalanced(1)) / (load0 + load1)).epsilon(1e-12));
  scene.drive(1, V::Zero());  // those that are driven do not count
  CHECK(dem::unbalanced_ratio(scene) == Approx(unbalanced(0) / load0).epsilon(1e-12));
}

TEST_CASE("the stable step of one spring, on either side of a contact") {
  for (const bool swapped : {false, true}) {
    dem::Simulation<SmoothHertz<double>> scene(SmoothHertz<double>{});
    const double overlap = 10e-6;
    const Ball light{sphere(granite, 5e-3), {0.0, 0.0, 12.5e-3 - overlap}};
    const Ball held{sphere(granite, 7.5e-3), V::Zero(), V::Zero(), V::Zero(), false};
    scene.add(swapped ? held : light);
    scene.add(swapped ? light : held);
    const double stiffness = 1.5 * 1.08330463206478e9 * std::sqrt(overlap);  // k_n of the memo's two grains
    const double mass = sphere_mass(5e-3, 2650.0);
    CHECK(dem::stable_time_step(scene) == Approx(std::sqrt(mass / stiffness)).epsilon(1e-12));
  }
}

TEST_CASE("settling ends at rest, and at Ctrl-C") {
  Scene scene(test::hill<double>(0.4, 0.0, 0.07), linear(29e6));
  scene.add(dem::Wall{plane(granite), V::Zero(), V::UnitZ()});
  scene.add(Ball{sphere(granite, 5e-3), {0.0, 0.0, 6e-3}});
  scene.gravity = {0.0, 0.0, -9.81};
  scene.local_damping = 0.7;
  Scene interrupted = scene;
  CHECK(dem::settle(scene, {1e-9}, [] {}));
  CHECK(-scene.walls[0].force.z() == Approx(scene.balls.mass[0] * 9.81).epsilon(1e-8));

  Scene roughly = interrupted;  // while it bounces its force passes through zero often
  CHECK(dem::settle(roughly, {1e-2}, [] {}));
  for (int step = 0; step < 5000; ++step) {
    roughly.step();
    REQUIRE(dem::unbalanced_ratio(roughly) < 1e-2);
  }

  const common::InterruptGuard guard;
  CHECK_FALSE(dem::settle(interrupted, {1e-9}, [&] {
    if (interrupted.steps == 25) std::raise(SIGINT);
  }));
  CHECK(common::stop_requested());
  CHECK(interrupted.steps == 25);
}

// Input ---------------------------------------------------------------------------------------------------------------

TEST_CASE("invalid input: the message has the quantity, its value, unit and range") {
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.0));
  const ContactBody<double> side = sphere(granite, 5e-3);
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(scene.add(Ball{plane(granite), V::Zero()}),
                    ContainsSubstring("Ball: radius is 0 m, must lie in (0, inf)"));
  CHECK_THROWS_WITH(scene.add(Ball{side.fixed(), V::Zero()}),
                    ContainsSubstring("Ball: mass is inf kg, must lie in (0, inf)"));
  CHECK_THROWS_WITH(scene.add(dem::Wall{plane(granite), V::Zero(), V(0, 0, 2)}),
                    ContainsSubstring("Wall: the length of facing is 2, must lie in [1, 1]"));
  CHECK_THROWS_WITH(dem::box_of_walls(plane(granite), V::Zero(), V(1, 1, -1)),
                    ContainsSubstring("box_of_walls: edge is -1 m, must lie in (0, inf)"));
  scene.add(Ball{side, V::Zero()});
  for (const double bad : {0.0, -1e-6, infinity, std::nan("")}) {
    scene.time_step = bad;
    CHECK_THROWS_AS(scene.step(), std::invalid_argument);
  }
  scene.time_step = -1e-6;
  CHECK_THROWS_WITH(scene.step(),
                    ContainsSubstring("Simulation: time_step is") && ContainsSubstring("s, must lie in (0, inf)"));
  scene.time_step = 1e-6;
  scene.local_damping = 1.0;
  CHECK_THROWS_WITH(scene.step(), ContainsSubstring("Simulation: local_damping is 1, must lie in [0, 1)"));
  CHECK_THROWS_WITH(scene.drive(1, V::Zero()), ContainsSubstring("Simulation: ball is 1, must lie in [0, 1)"));
  CHECK_THROWS_WITH(scene.release(-1), ContainsSubstring("Simulation: ball is -1, must lie in [0, 1)"));
  CHECK_THROWS_WITH(scene.drive_wall(0, V::Zero()), ContainsSubstring("Simulation: wall is 0, must lie in [0, 0)"));
  DryHill<double> negative;
  negative.shear.friction = -1.0;
  CHECK_THROWS_WITH(dem::Simulation<DryHill<double>>(negative),
                    ContainsSubstring("friction is -1, must lie in [0, inf)"));
  CHECK_THROWS_WITH(dem::save("/nowhere/scene.json", scene),
                    ContainsSubstring("/nowhere/scene.json: cannot be written"));
}

TEST_CASE("a warning names the bodies that start with large overlaps") {
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.0));
  std::ostringstream log;
  scene.log = &log;
  scene.add(dem::Wall{plane(granite), {0.0, 0.0, -4e-3}, V::UnitZ()});
  for (const double x : {0.0, 9.6e-3, 18.6e-3}) scene.add(Ball{sphere(granite, 5e-3), {x, 0.0, 0.0}});
  scene.balls.position[0].z() = scene.balls.position[1].z() = 2e-3;
  scene.start();
  const std::string said = log.str();
  CHECK_THAT(said, ContainsSubstring("warning: ball 1 and ball 2 start with an overlap of"));
  CHECK_THAT(said,
             ContainsSubstring("warning: wall 0 and ball 2 start with an overlap of 0.001 m, more than a tenth of the "
                               "smaller radius (0.0005 m)"));
  CHECK(std::count(said.begin(), said.end(), '\n') == 2);  // 0.4 mm between balls 0 and 1 is allowed
  scene.time_step = 1e-9;
  scene.step();
  CHECK(log.str() == said);  // once
}

// Files ---------------------------------------------------------------------------------------------------------------

TEST_CASE("what ParaView gets is what the scene holds") {
  Random random(29);
  Scene scene = rushing_cloud(cloud(random, 30, 0.04, 2.0), 0.04);
  const auto active = [](const auto& contacts, const auto& outcome) {
    std::vector<std::size_t> numbers;
    for (std::size_t c = 0; c < contacts.size(); ++c)
      if (outcome(c).response.active) numbers.push_back(c);
    return numbers;
  };
  const auto between = [&scene](std::size_t c) { return scene.ball_contact(c); };
  const auto at_wall = [&scene](std::size_t c) { return scene.wall_contact(c); };
  while (active(scene.ball_contacts, between).empty()) scene.step();
  scene.make_wet(0.5e-3);
  while (active(scene.wall_contacts, at_wall).empty()) scene.step();

  const common::VtkData balls = dem::balls_for_vtk(scene.balls);
  REQUIRE(balls.points.size() == 30);
  CHECK(balls.points[7] == V(scene.balls.position[7]));
  CHECK(balls.scalars.at("radius") == scene.balls.radius);
  CHECK(balls.vectors.at("force")[7] == V(scene.balls.force[7]));

  const auto compare = [](const common::VtkData& data, std::size_t line, const auto& contact, const V& start,
                          const V& end) {
    CAPTURE(line);
    // Ends are computed from the contact point, with a rounding or two of positions below 0.04 m.
    CHECK((data.points[2 * line] - start).norm() < 4 * 0.04 * 2.3e-16);
    CHECK(data.points[2 * line + 1] == end);
    const auto& step = contact.response;
    CHECK(data.vectors.at("force")[2 * line] == -step.force);
    CHECK(data.vectors.at("force")[2 * line + 1] == step.force);
    for (const std::size_t i : {2 * line, 2 * line + 1}) {
      CHECK(data.scalars.at("overlap")[i] == contact.geometry.overlap);
      const double shear = data.scalars.at("shear_force")[i], largest = 1e-15 + step.force.norm();
      CHECK(std::abs(data.scalars.at("normal_force")[i] - step.force.dot(contact.geometry.normal)) < 1e-15 * largest);
      CHECK(std::abs(shear - step.force.cross(contact.geometry.normal).norm()) < 1e-15 * largest);
      CHECK(data.scalars.at("sliding")[i] == (step.sliding ? 1.0 : 0.0));
    }
  };
  const common::VtkData contacts = dem::ball_contacts_for_vtk(scene);
  const std::vector<std::size_t> of_balls = active(scene.ball_contacts, between);
  REQUIRE(contacts.points.size() == 2 * of_balls.size());
  for (std::size_t i = 0; i < of_balls.size(); ++i) {
    const std::size_t c = of_balls[i];
    compare(contacts, i, between(c), scene.balls.position[scene.ball_contacts.first(c)],
            scene.balls.position[scene.ball_contacts.second(c)]);
    CHECK(contacts.scalars.at("moisture")[2 * i] == scene.ball_contacts.state(c).moisture);
  }
  CHECK(contacts.scalars.at("moisture")[0] > 0.0);

  const common::VtkData at_walls = dem::wall_contacts_for_vtk(scene);
  const std::vector<std::size_t> of_walls = active(scene.wall_contacts, at_wall);
  REQUIRE(at_walls.points.size() == 2 * of_walls.size());
  for (std::size_t i = 0; i < of_walls.size(); ++i) {
    const auto contact = at_wall(of_walls[i]);
    const V centre = scene.balls.position[scene.wall_contacts.second(of_walls[i])];
    const double radius = scene.balls.radius[scene.wall_contacts.second(of_walls[i])];
    compare(at_walls, i, contact, centre - contact.geometry.normal * (radius - contact.geometry.overlap / 2), centre);
  }
  CHECK(at_walls.scalars.count("moisture") == 0);
}

// Histories, bodies and bridges of examples/dem: what a contact keeps, from what, and for how long.
#include <filesystem>

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "examples/dem/checkpoint.hpp"
#include "examples/dem/measures.hpp"
#include "make_laws.hpp"

using namespace contactlaws;
using dem::Ball;
using V = dem::Vec3;

namespace {

const ElasticMaterial<double> soft{1e8, 0.25, 2500.0};
const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};

DryHill<double> sticky() { return test::dry_hill<double>(10.0, 0.05); }

/// Two balls on a floor and one held beside them.
dem::Simulation<DryHill<double>> pile() {
  dem::Simulation<DryHill<double>> scene(sticky());
  scene.log = nullptr;
  scene.gravity = {0.0, 0.0, -9.81};
  scene.add(dem::Wall{plane(soft), V::Zero(), V::UnitZ()});
  scene.add(Ball{sphere(soft, 1e-3), {0.0, 0.0, 0.9999e-3}, {0.01, 0.0, 0.0}});
  scene.add(Ball{sphere(soft, 1e-3), {0.0, 0.3e-3, 2.977e-3}, {0.01, 0.0, 0.0}});
  scene.add(Ball{sphere(soft, 1e-3), {5e-3, 0.0, 1e-3}, V::Zero(), V::Zero(), false});
  scene.time_step = 1e-7;
  return scene;
}

template <class Scene>
void run(Scene& scene, int steps) {
  for (int i = 0; i < steps; ++i) scene.step();
}

/// Saves, restores in a scene built by `build`, and takes as many steps in both: whether all bits are the same.
template <class Scene, class Build>
void check_restart(Scene& scene, const Build& build, int steps) {
  const std::string file = (std::filesystem::temp_directory_path() / "contactlaws_test_histories.json").string();
  dem::save(file, scene);
  Scene restored = build();
  dem::restore(file, restored);
  std::filesystem::remove(file);
  CHECK(dem::unbalanced_ratio(restored) == dem::unbalanced_ratio(scene));
  CHECK(dem::stable_time_step(restored) == dem::stable_time_step(scene));
  for (Scene* s : {&scene, &restored}) run(*s, steps);
  CHECK(restored.time == scene.time);
  for (std::size_t b = 0; b < scene.balls.size(); ++b) {
    CHECK(restored.balls.position[b] == scene.balls.position[b]);
    CHECK(restored.balls.spin[b] == scene.balls.spin[b]);
  }
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    CHECK(restored.walls[w].point == scene.walls[w].point);
    CHECK(restored.walls[w].force == scene.walls[w].force);
  }
}

/// Hertz's force of two balls of `soft` [N].
double hertz_force(double radius1, double radius2, double overlap) {
  const double r = radius1 * radius2 / (radius1 + radius2), e = 1e8 / (1.0 - 0.25 * 0.25) / 2.0;
  return 4.0 / 3.0 * e * std::sqrt(r * overlap) * overlap;
}

template <Recontact recontact>
using Rough = ContactLaw<PohrtPopovElastoPlastic<double, recontact>, NoDashpots<double>,
                         ShearForce<double, ConstantRatio<double>>>;

}  // namespace

TEST_CASE("a restart gives the same bits, whatever was changed since the scene was built") {
  auto scene = pile();
  run(scene, 2000);
  SECTION("nothing") {}
  SECTION("a wall is driven") { scene.drive_wall(0, {0.05, 0.0, 0.2}); }
  SECTION("a ball is released") { scene.release(2); }
  SECTION("a ball is driven") { scene.drive(1, {0.0, 0.1, 0.0}, {0.0, 30.0, 0.0}); }
  SECTION("the step") { scene.time_step = 2e-7; }
  SECTION("gravity and local damping") {
    scene.gravity = {5.0, 0.0, -5.0};
    scene.local_damping = 0.5;
  }
  SECTION("a ball and a wall") {
    scene.change(1, sphere(soft, 1.1e-3));
    scene.change_wall(0, plane(granite));
  }
  run(scene, 100);
  check_restart(scene, pile, 2000);
}

TEST_CASE("a restart keeps wet gaps beyond the skin") {
  const auto build = [] {
    dem::Simulation<Hill<double>> scene(test::hill<double>(0.4, 1e3, 0.1));
    scene.add(Ball{sphere(soft, 1e-3), V::Zero()});
    scene.add(Ball{sphere(soft, 1e-3), {2.9e-3, 0.0, 0.0}});
    scene.time_step = 1e-6;
    return scene;
  };
  auto scene = build();
  scene.make_wet(1e-3);
  run(scene, 10);
  CHECK(scene.balls.force[0].x() > 0.0);
  check_restart(scene, build, 100);
}

TEST_CASE("a contact follows a ball that grows, and a body that changes its material") {
  const double radius = 1e-3, grown = 1.2e-3, overlap = 1e-5;
  dem::Simulation<SmoothHertz<double>> scene(SmoothHertz<double>{});
  scene.log = nullptr;
  scene.add(Ball{sphere(soft, radius), V::Zero(), V::Zero(), V::Zero(), false});
  scene.add(Ball{sphere(soft, radius), {0.0, 0.0, 2.0 * radius - overlap}, V::Zero(), V::Zero(), false});
  scene.time_step = 1e-7;
  scene.step();
  const double eps = 1e-13;  // the overlap is a difference of centres 200 times as large: 200 eps
  CHECK(scene.balls.force[1].z() == Approx(hertz_force(radius, radius, overlap)).epsilon(eps));

  scene.change(1, sphere(soft, grown));
  scene.balls.position[1] = V(0.0, 0.0, radius + grown - overlap);
  scene.step();
  CHECK(scene.balls.force[1].z() == Approx(hertz_force(radius, grown, overlap)).epsilon(eps));
  CHECK(scene.balls.mass[1] == Approx(2500.0 * 4.0 / 3.0 * pi<double>() * std::pow(grown, 3)).epsilon(1e-14));
  CHECK(scene.ball_contacts.pair(0).effective_mass ==
        Approx(1.0 / (1.0 / scene.balls.mass[0] + 1.0 / scene.balls.mass[1])).epsilon(1e-14));
  CHECK(scene.balls.inertia[1] == Approx(0.4 * scene.balls.mass[1] * grown * grown).epsilon(1e-14));

  scene.change(0, sphere(soft, radius).rigid());  // E* is twice as large
  scene.step();
  CHECK(scene.balls.force[1].z() == Approx(2.0 * hertz_force(radius, grown, overlap)).epsilon(eps));
  CHECK_THROWS_WITH(scene.change(2, sphere(soft, radius)),
                    Catch::Matchers::Contains("Simulation: ball is 2, must lie in [0, 2)"));
}

TEST_CASE("a history outlives separation exactly where the law says so, whatever the skin") {
  // A flattened rough contact opens far beyond the skin and closes again: the integrator, for any skin, and the law alone.
  const auto check = [](auto law) {
    using Law = decltype(law);
    law.normal = decltype(law.normal)::of({2.13, 26.1e-6});
    law.shear.friction = 0.7;
    const double radius = 4.72e-3;
    const ElasticMaterial<double> stone{60e9, 0.25, 2600.0};
    for (const double skin : {1e-6, 0.01, 3.0}) {
      dem::Simulation<Law> scene(law);
      scene.log = nullptr;
      scene.skin = skin;
      scene.time_step = 1e-6;
      scene.add(Ball{sphere(stone, radius), V::Zero(), V::Zero(), V::Zero(), false});
      const int top = scene.add(Ball{sphere(stone, radius), {0.0, 0.0, 2.0 * radius}, V::Zero(), V::Zero(), false});
      const auto pair = pair_properties(sphere(stone, radius), sphere(stone, radius));
      typename Law::State state{};
      double largest = 0.0, again = 0.0;
      const auto move_to = [&](double overlap, int steps) {
        const double from = 2.0 * radius - scene.balls.position[1].z();
        scene.drive(top, {0.0, 0.0, (from - overlap) / steps / scene.time_step});
        for (int i = 0; i < steps; ++i) {
          scene.step();
          const double now = 2.0 * radius - scene.balls.position[1].z();
          const auto alone = law.step(pair, {V::UnitZ(), now, scene.balls.velocity[1], scene.time_step}, state);
          state = alone.state;
          // The overlap differs by the rounding of the centres (2e-18 m): 1e-12 of 10 um, where the force is not zero.
          CHECK(scene.balls.force[1].z() == Approx(alone.force.z()).epsilon(1e-8).margin(1e-9));
          again = alone.force.z();
          largest = std::max(largest, again);
        }
      };
      move_to(30e-6, 30);
      move_to(-1e-3, 50);
      move_to(20e-6, 50);
      CHECK(largest > 50.0);
      CHECK((again < 1.0) == Law::outlives_separation);  // the virgin surface would push with 27 N
      move_to(30e-6, 10);
    }
  };
  check(Rough<Recontact::same_spot>{});
  check(Rough<Recontact::fresh_surface>{});
}

TEST_CASE("a restart keeps the history of a pair that is not listed") {
  const auto build = [] {
    Rough<Recontact::same_spot> law;
    law.normal = decltype(law.normal)::of({2.13, 26.1e-6});
    dem::Simulation<Rough<Recontact::same_spot>> scene(law);
    scene.log = nullptr;
    scene.skin = 1e-3;
    scene.time_step = 1e-7;
    scene.add(Ball{sphere(granite, 5e-3), V::Zero(), V::Zero(), V::Zero(), false});
    scene.add(Ball{sphere(granite, 5e-3), {0.0, 0.0, 10e-3 - 30e-6}, V::Zero(), V::Zero(), false});
    return scene;
  };
  auto scene = build();
  scene.step();
  scene.drive(1, {0.0, 0.0, 100.0});
  run(scene, 100);
  CHECK(scene.ball_contacts.size() == 0);
  scene.drive(1, {0.0, 0.0, -100.0});
  check_restart(scene, build, 99);
  const auto pair = scene.ball_contacts.pair(0);
  const double virgin = scene.ball_law.step(pair, {V::UnitZ(), 20e-6, V::Zero(), 0.0}, {}).force.z();
  CHECK(scene.balls.force[1].z() < 0.1 * virgin);  // an overlap of 20 um on the flattened spot
}

TEST_CASE("dry gaps of a wet law are neither listed beyond the skin nor counted in the step") {
  const auto build = [] {
    dem::Simulation<Hill<double>> scene(test::hill<double>(0.4, 1e3, 0.1));
    const double spacing = 10e-3 + 1e-6;  // gaps of 1 um to six neighbours, 4.1 mm to the next
    for (int x = 0; x < 3; ++x)
      for (int y = 0; y < 3; ++y)
        for (int z = 0; z < 3; ++z) scene.add(Ball{sphere(granite, 5e-3), spacing * V(x, y, z)});
    return scene;
  };
  auto dry = build(), wet = build();
  dem::Simulation<DryHill<double>> never_wet(test::dry_hill<double>(0.4, 0.1));
  for (const V& x : dry.balls.position) never_wet.add(Ball{sphere(granite, 5e-3), x});
  CHECK(dem::stable_time_step(dry) == dem::stable_time_step(never_wet));
  CHECK(dry.ball_contacts.size() == never_wet.ball_contacts.size());
  CHECK(dry.ball_contacts.size() == 54);

  wet.make_wet(5e-3);  // out to the diagonals of a face
  CHECK(wet.ball_contacts.size() == 54 + 72);
  CHECK(dem::stable_time_step(wet) < 0.6 * dem::stable_time_step(dry));
  dry.make_wet(2e-6);
  CHECK(dry.ball_contacts.size() == 54);

  dem::Simulation<Hill<double>> apart(test::hill<double>(0.4, 1e3, 0.1));  // a dry pair that separates
  apart.add(Ball{sphere(granite, 5e-3), V::Zero(), V::Zero(), V::Zero(), false});
  apart.add(Ball{sphere(granite, 5e-3), {10e-3, 0.0, 0.0}, {1.0, 0.0, 0.0}, V::Zero(), false});
  apart.time_step = 1e-4;
  run(apart, 30);
  CHECK(apart.ball_contacts.size() == 0);  // a gap of 3 mm, the skin is 1.5 mm
}

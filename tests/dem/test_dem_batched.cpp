// Contacts of examples/dem in packs give the results of contacts one at a time, for any number of threads.
#include <thread>

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "examples/dem/simulation.hpp"
#include "make_laws.hpp"
#include "random.hpp"

using namespace contactlaws;
using contactlaws::test::Random;
using V = dem::Vec3;

namespace {

const ElasticMaterial<double> soft{5e6, 0.3, 2500.0};
constexpr double moisture_gap = 1e-3;

/// `count` balls that move at random in a box: they touch, slide, separate and are listed anew.
template <class Scene>
void fill(Scene& scene, int count) {
  Random random(19);
  const double cell = 7e-3;
  const int edge = 4;
  for (const dem::Wall& wall : dem::box_of_walls(plane(soft), V::Zero(), V::Constant(cell * edge))) scene.add(wall);
  for (int i = 0; i < count; ++i) {
    const V corner(i % edge, i / edge % edge, i / edge / edge);
    scene.add(dem::Ball{sphere(soft, random.uniform(2e-3, 3.4e-3)), (corner + V::Constant(0.5)) * cell,
                        2.0 * random.direction(), 100.0 * random.direction()});
  }
  scene.gravity = {0.0, 0.0, -9.81};
  scene.skin = 0.1;
  scene.time_step = 5e-6;
}

template <class One, class Other>
double largest_difference(const One& one, const Other& other) {
  double largest = 0.0;
  for (std::size_t b = 0; b < one.balls.size(); ++b)
    largest = std::max(largest, (one.balls.position[b] - other.balls.position[b]).norm() +
                                    (one.balls.spin[b] - other.balls.spin[b]).norm());
  return largest;
}

}  // namespace

TEST_CASE("packs give the bits of one contact at a time, for any number of contacts left over") {
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.1);
  for (const int count : {2, 3, 5, 16, 63, 64}) {
    dem::Simulation<DryHill<double>, DryHill<double>, double> one_by_one(law);
    dem::Simulation<DryHill<double>> in_packs(law);
    fill(one_by_one, count);
    fill(in_packs, count);
    std::size_t touches = 0;
    for (int step = 0; step < 1500; ++step) {
      one_by_one.step();
      in_packs.step();
      touches += in_packs.ball_contacts.size();
    }
    CHECK(largest_difference(one_by_one, in_packs) == 0.0);
    CHECK((count < 16 || touches > 1000));  // the test saw something
  }
}

TEST_CASE("a contact evaluated again alone gives the bits of its pack") {
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.4, 0.1));
  fill(scene, 64);
  int touching = 0, sliding = 0;
  for (int step = 0; step < 1000; ++step) {
    scene.step();
    for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c) {
      const auto contact = scene.ball_contact(c);
      touching += contact.response.active;
      sliding += contact.response.sliding;
      for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(scene.ball_contacts.force[c][static_cast<int>(i)] == contact.response.force[static_cast<int>(i)]);
        REQUIRE(scene.ball_contacts.state(c).shear[i] == contact.response.state.shear[i]);
      }
    }
  }
  CHECK(touching > 1000);
  CHECK(sliding > 100);
}

TEST_CASE("a wet contact differs from its pack by the rounding of exp alone") {
  dem::Simulation<Hill<double>> scene(test::hill<double>(0.4, 1e3, 0.1));
  fill(scene, 64);
  scene.make_wet(moisture_gap);
  int pulling = 0;
  for (int step = 0; step < 500; ++step) {
    scene.step();
    for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c) {
      const auto contact = scene.ball_contact(c);
      const V in_pack = scene.ball_contacts.force[c];
      pulling += contact.response.bridge_force > 0.0 && contact.geometry.overlap < 0.0;
      const double size = std::abs(contact.response.normal_force) + contact.response.bridge_force;
      REQUIRE((in_pack - contact.response.force).norm() <= 1e-15 * size);
      REQUIRE(scene.ball_contacts.state(c).moisture == contact.response.state.moisture);
    }
  }
  CHECK(pulling > 1000);
}

TEST_CASE("any number of threads gives the same bits") {
  const Hill<double> law = test::hill<double>(0.4, 1e3, 0.1);
  const auto run = [&law](int threads, int steps) {
    dem::Simulation<Hill<double>> scene(law);
    fill(scene, 61);
    scene.threads = threads;
    scene.make_wet(moisture_gap);
    for (int step = 0; step < steps; ++step) scene.step();
    return scene;
  };
  // Threads that share a core wait for each other: with more of them than balls, fewer steps.
  for (const auto& [threads, steps] : {std::pair(2, 500), {3, 200}, {100, 20}}) {
    const auto alone = run(1, steps), shared = run(threads, steps);
    CHECK(largest_difference(alone, shared) == 0.0);
    for (std::size_t w = 0; w < alone.walls.size(); ++w) CHECK(alone.walls[w].force == shared.walls[w].force);
  }
}

TEST_CASE("scenes on threads of their own, whose number of threads changes, give the bits of one thread") {
  const auto run = [](const std::vector<int>& threads) {
    dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.4, 0.1));
    fill(scene, 61);
    for (const int number : threads) {
      scene.threads = number;
      for (int step = 0; step < 50; ++step) scene.step();
    }
    return scene;
  };
  const auto alone = run({1, 1, 1, 1});
  std::vector<double> differences(2, 1.0);
  std::vector<std::thread> users;
  for (double& difference : differences)
    users.emplace_back([&] { difference = largest_difference(alone, run({2, 3, 1, 2})); });
  for (std::thread& user : users) user.join();
  CHECK(differences == std::vector<double>{0.0, 0.0});
}

TEST_CASE("the memory of a list is that of its columns") {
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.4));
  fill(scene, 64);
  scene.skin = 2.0;  // none touch yet
  scene.start();
  const auto& list = scene.ball_contacts;
  REQUIRE(list.size() > 20);
  // Two ids, two histories, two rows; and at most four times that for the lists by body, properties and room to grow.
  const std::size_t least =
      list.size() * (sizeof(dem::Pair) + 2 * 8 * DryHill<double>::state_size + 2 * sizeof(dem::Row));
  CHECK(list.bytes() >= least);
  CHECK(list.bytes() <= 5 * least);
}

TEST_CASE("a scene without contacts, without balls, and with more threads than either") {
  dem::Simulation<DryHill<double>> scene(test::dry_hill<double>(0.4));
  scene.threads = 4;
  scene.time_step = 1e-3;
  scene.step();
  scene.add(dem::Ball{sphere(soft, 1e-3), V::Zero(), V::UnitX()});
  scene.step();
  CHECK(scene.balls.position[0] == V(1e-3, 0.0, 0.0));
  scene.threads = 0;
  CHECK_THROWS_WITH(scene.step(), ContainsSubstring("Simulation: threads is 0, must lie in [1, inf)"));
}

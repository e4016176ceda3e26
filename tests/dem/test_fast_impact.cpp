// The time steps that examples/dem chooses, taken through impacts: no undamped impact may gain energy by its step.
#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "examples/dem/settle.hpp"

using namespace contactlaws;
using dem::Ball;
using V = dem::Vec3;

namespace {

const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
constexpr double radius = 5e-3;

template <class Scene>
double kinetic_energy(const Scene& scene) {
  double sum = 0.0;
  for (std::size_t b = 0; b < scene.balls.size(); ++b)
    if (scene.balls.free[b]) sum += scene.balls.mass[b] * scene.balls.velocity[b].squaredNorm() / 2.0;
  return sum;
}

/// Largest gain of kinetic energy in an impact, relative, over moments of touch within a step. `scene_at(gap)` builds the
/// scene that collides at `speed`; `next_step(scene)` yields the step.
template <class SceneAt, class NextStep>
double largest_gain(double speed, const SceneAt& scene_at, const NextStep& next_step) {
  constexpr int phases = 20;
  auto probe = scene_at(1e-6);
  const double way = speed * next_step(probe);
  double largest = -1.0;
  for (int phase = 0; phase < phases; ++phase) {
    auto scene = scene_at(way * (10.0 + (phase + 0.5) / phases));
    const double before = kinetic_energy(scene);
    bool touched = false;
    for (int i = 0;; ++i) {
      if (i % 10 == 0) scene.time_step = next_step(scene);
      scene.step();
      bool touches = false;
      for (std::size_t c = 0; c < scene.ball_contacts.size(); ++c)
        touches = touches || scene.ball_contact(c).geometry.overlap > 0.0;
      for (std::size_t c = 0; c < scene.wall_contacts.size(); ++c)
        touches = touches || scene.wall_contact(c).geometry.overlap > 0.0;
      if (touched && !touches) break;
      touched = touched || touches;
      REQUIRE(i < 100000);
    }
    largest = std::max(largest, kinetic_energy(scene) / before - 1.0);
  }
  return largest;
}

template <class Law>
auto ball_at_wall(const Law& law, double speed, bool rigid) {
  return [=](double gap) {
    dem::Simulation<Law> scene(law);
    scene.log = nullptr;
    scene.add(dem::Wall{rigid ? plane(granite).rigid() : plane(granite), V::Zero(), V::UnitZ()});
    scene.add(Ball{sphere(granite, radius), {0.0, 0.0, radius + gap}, {0.0, 0.0, -speed}});
    return scene;
  };
}

/// A ball at rest is hit by one of `ratio` times its radius.
template <class Law>
auto ball_at_ball(const Law& law, double speed, double ratio) {
  return [=](double gap) {
    dem::Simulation<Law> scene(law);
    scene.log = nullptr;
    scene.add(Ball{sphere(granite, radius), V::Zero()});
    scene.add(Ball{sphere(granite, ratio * radius), {(1.0 + ratio) * radius + gap, 0.0, 0.0}, {-speed, 0.0, 0.0}});
    return scene;
  };
}

constexpr double speeds[] = {0.1, 1.0, 10.0, 50.0};  // [m/s]

}  // namespace

TEST_CASE("steps of t_c / n gain the energy that timestep.hpp states") {
  // Figures of the leapfrog scheme on m x'' = -k x^(3/2), from code of its own, over 400 moments of touch.
  const struct {
    double n, gain;
  } table[] = {{4, 6.78e-2}, {5, 3.53e-2}, {8, 9.54e-3}, {10, 5.24e-3}, {16, 1.52e-3}, {20, 8.53e-4}};
  const double speed = 1.0;
  const auto pair = pair_properties(plane(granite), sphere(granite, radius));
  for (const auto& row : table) {
    const double step = impact_duration(pair, speed) / row.n;
    const double gain =
        largest_gain(speed, ball_at_wall(SmoothHertz<double>{}, speed, false), [step](const auto&) { return step; });
    CHECK(gain <= 1.01 * row.gain);  // three digits, and the deepest overlap lies elsewhere in a step
    CHECK(gain >= 0.8 * row.gain);   // 20 moments of touch find less than 400
  }
}

TEST_CASE("no impact from 0.1 to 50 m/s gains 1 % of energy by the steps chosen") {
  // 1 % is what a tenth of the duration keeps (the table above: 5e-3), with room for the change of the step within an impact.
  const auto once = [](auto& scene) { return scene.steps == 0 ? dem::stable_time_step(scene) : scene.time_step; };
  const auto anew = [](auto& scene) { return dem::Settling{}.safety * dem::stable_time_step(scene); };
  const auto check = [&](double speed, const auto& scene_at) {
    CHECK(largest_gain(speed, scene_at, once) < 1e-2);
    CHECK(largest_gain(speed, scene_at, anew) < 1e-2);
  };
  RoughBallast<double> rough;
  rough.normal = decltype(rough.normal)::of({2.13, 26.1e-6});
  for (const double speed : speeds) {
    CAPTURE(speed);
    check(speed, ball_at_wall(SmoothHertz<double>{}, speed, false));
    check(speed, ball_at_wall(SmoothHertz<double>{}, speed, true));
    for (const double ratio : {0.1, 1.0, 3.0}) check(speed, ball_at_ball(SmoothHertz<double>{}, speed, ratio));
    check(speed, ball_at_wall(rough, speed, false));
  }
}

TEST_CASE("a ball that settles without damping never rises above where it fell from") {
  for (const double height : {0.05, 5.0}) {
    for (int phase = 0; phase < 10; ++phase) {
      const double drop = height * (1.0 + 0.003 * phase);
      dem::Simulation<SmoothHertz<double>> scene(SmoothHertz<double>{});
      scene.gravity = {0.0, 0.0, -9.81};
      scene.add(dem::Wall{plane(granite), V::Zero(), V::UnitZ()});
      scene.add(Ball{sphere(granite, radius), {0.0, 0.0, radius + drop}});
      bool hit = false;
      double highest = 0.0;
      dem::Settling settling;
      const double fall = std::sqrt(2.0 * drop / 9.81);
      settling.most_steps = std::numeric_limits<int>::max();
      struct Enough {};
      try {
        dem::settle(scene, settling, [&] {
          const double above = scene.balls.position[0].z() - radius;
          hit = hit || above < 0.0;
          if (hit) highest = std::max(highest, above);
          if (scene.time > 2.2 * fall) throw Enough{};
        });
      } catch (const Enough&) {
      }
      CHECK(hit);
      CHECK(highest / drop - 1.0 < 1e-2);
      CHECK(highest / drop - 1.0 > -1e-2);
    }
  }
}

TEST_CASE("speeds bound the step by the shortest impact, for laws that are not linear") {
  const auto step_at = [](double speed, const auto& law) {
    auto scene = ball_at_ball(law, speed, 1.0)(1.0);  // 1 m away
    return dem::stable_time_step(scene);
  };
  const auto pair = pair_properties(sphere(granite, radius), sphere(granite, radius));
  // Both balls count as if they met their like at the sum of their own speed and the largest: 2 x 10 m/s.
  CHECK(step_at(10.0, SmoothHertz<double>{}) == Approx(impact_duration(pair, 20.0) / 10.0).epsilon(1e-14));
  ContactLaw<LinearSpring<double>> linear;
  linear.normal.normal_stiffness = 1e6;
  CHECK(step_at(10.0, linear) == step_at(0.0, linear));
}

// Item 15: how large a step a leapfrog integrator bears with each law, in durations t_c of an impact, and at what order the
// restitution that it finds converges. Published figures, without a target.
//
// A granite sphere of 5 mm on a plane, at 1 m/s. "Stable": pressed by the largest force of that impact and disturbed a
// little, sticking, it stays where it is for 2000 steps; its spin is coupled in and sets the limit.
#include "contactlaws/damping/restitution.hpp"
#include "contactlaws/laws.hpp"
#include "contactlaws/timestep.hpp"
#include "impact.hpp"
#include "make_laws.hpp"
#include "row.hpp"

using namespace contactlaws;
using namespace contactlaws::test;

namespace {

constexpr double radius = 5e-3, speed = 1.0;
const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};

PairProperties<double> ball_on_plane() { return pair_properties(plane(granite), sphere(granite, radius)); }

/// The overlap at which a law, loaded for the first time, carries `force`.
template <class Law>
double overlap_under(const Law& law, const PairProperties<double>& pair, double force) {
  double low = 0.0, high = radius;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (law.step(pair, {{0, 0, 1}, middle, {0, 0, 0}, 1.0}, {}).normal_elastic < force ? low : high) = middle;
  }
  return high;
}

/// Whether the pressed sphere, set rolling and bouncing a little, has not moved far after 2000 steps of `dt` [s].
template <class Law>
bool is_stable(const Law& law, const PairProperties<double>& pair, double press, double dt) {
  const double rest = overlap_under(law, pair, press), inertia = 0.4 * pair.effective_mass * radius * radius;
  const double nudge = 1e-4 * rest / dt;
  BodyMotion<double> ball{{0, 0, radius - rest}, {nudge, 0, nudge}, {0, 0, 0}};
  const BodyMotion<double> wall{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  typename Law::State state{};
  for (int i = 0; i < 2000; ++i) {
    const auto geometry = plane_sphere<double>({0, 0, 0}, {0, 0, 1}, ball.position, radius);
    const auto step = law.step(pair, contact_kinematics(geometry, wall, ball, dt), state);
    state = step.state;
    ball.velocity += (step.force - Vec3<double>(0, 0, press)) / pair.effective_mass * dt;
    ball.spin += geometry.arm2.cross(step.force) / inertia * dt;
    ball.position += ball.velocity * dt;
    if (!(std::abs(radius - ball.position.z() - rest) < 0.05 * rest)) return false;
    if (!(std::abs(ball.spin.y()) * radius < 500 * nudge)) return false;
  }
  return true;
}

template <class Law>
void publish(const std::string& name, Law law) {
  const PairProperties<double> pair = ball_on_plane();
  const double roughly = 1e-5;  // s; t_c is some 20 us with granite, 3 ms with the softest spring here
  const Impact coarse = leap_through_impact(law, pair, speed, roughly / 100, 0.5);
  const Impact fine = leap_through_impact(law, pair, speed, coarse.duration / 100000, 0.5);
  const double duration = fine.duration, press = fine.largest_force;
  const std::string scene = text_of("t_c = ", duration, " s");

  law.shear.friction = 1e6;
  double low = 0.0, high = 2.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (is_stable(law, pair, press, middle * duration) ? low : high) = middle;
  }
  report({15, name + ": largest stable step", low, "t_c", {}, 40, scene});
  const double rest = overlap_under(law, pair, press);
  typename Law::State state{};
  state = law.step(pair, {{0, 0, 1}, rest, {0, 0, 0}, 1.0}, state).state;
  BodyStiffness<double> body;
  body.add(law.stiffness(pair, rest, state), {0, 0, 1}, radius - rest / 2);
  const double estimate = stable_time_step(pair.effective_mass, 0.4 * pair.effective_mass * radius * radius, body, 1.0);
  report({15, name + ": stable_time_step over the largest stable", estimate / (low * duration), "of 1", 1.0, 1, scene,
          "no safety factor included"});

  const auto error_at = [&](int steps) {
    double worst = 0.0;
    for (const double phase : {0.1, 0.3, 0.5, 0.7, 0.9})
      worst = std::max(worst, std::abs(leap_through_impact(law, pair, speed, duration / steps, phase).restitution -
                                       fine.restitution));
    return worst;
  };
  int steps = 2000;
  while (steps > 2 && error_at(steps) <= 0.01) --steps;
  report({15,
          name + ": largest step for 1 % of restitution",
          1.0 / (steps + 1),
          "t_c",
          {},
          5,
          text_of(scene, ", e = ", fine.restitution)});
  report({15,
          name + ": observed order of the restitution",
          std::log2(error_at(250) / error_at(1000)) / 2,
          "1",
          {},
          10,
          text_of("error at t_c/1000: ", error_at(1000))});
}

}  // namespace

int main(int argc, char** argv) {
  const Effort effort(argc, argv);
  using T = double;
  publish("Hertz, Mindlin, undamped", test::dry_hill<T>(0.4, 0.0));
  publish("DryHill, alpha 0.07", test::dry_hill<T>(0.4, 0.07));
  publish("DryHill, alpha 0.5", test::dry_hill<T>(0.4, 0.5));
  publish("DryHill clipped, alpha 0.5", DryHill<T, Tension::clipped>{{}, {0.5}, {{}, 0.4}, {}});
  publish("Hertz, rescaled force", ContactLaw<Hertz<T>, NoDashpots<T>, ShearForceRescaled<T>>{{}, {}, {{}, 0.4}, {}});
  publish("LinearFriction", LinearFriction<T>{{5e8}, {}, {{0.6}, 0.4}, {}});
  publish("LinearSpringDashpot, alpha 0.3", LinearSpringDashpot<T>{{1e7}, {0.3}, {{0.6}, 0.4}, {}});
  publish("RoughBallast", RoughBallast<T>{PohrtPopovElastoPlastic<T>::of({2.13, 26.1e-6}), {}, {{0.6}, 0.7}, {}});
}

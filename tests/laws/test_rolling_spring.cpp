#include "contactlaws/rolling/rolling_spring.hpp"

#include "catch.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using V = Vec3<double>;
using Law = ContactLaw<Hertz<double>, NoDashpots<double>, Frictionless<double>, Dry<double>, RollingSpring<double>>;

Law rolling(double rolling_friction) {
  Law law;
  law.rolling.rolling_friction = rolling_friction;
  return law;
}

/// The memo's grains, R* = 3 mm, 0.1 mm deep, normal +z: F = 1083.30463206478 N, k_n = 3/2 F/o.
const PairProperties<double> pair = granite_pair<double>();
constexpr double overlap = 1e-4, force = 1083.30463206478, radius = 3e-3;
constexpr double normal_stiffness = 1.5 * force / overlap;

ContactKinematics<double> turning(const V& relative_spin, double dt = 1.0) {
  return {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, relative_spin};
}

}  // namespace

TEST_CASE("Rolling spring: stiffness 9/4 k_n (mu_r R*)^2 against rolling, none against twisting") {
  const Law law = rolling(0.1);
  const double k = 2.25 * normal_stiffness * (0.1 * radius) * (0.1 * radius);
  CHECK(law.rolling.stiffness(pair, normal_stiffness) == Approx(k).epsilon(1e-14));
  const auto step = law.step(pair, turning({1e-4, -2e-4, 5.0}), {});
  CHECK(step.couple.x() == Approx(-k * 1e-4).epsilon(1e-13));
  CHECK(step.couple.y() == Approx(k * 2e-4).epsilon(1e-13));
  CHECK(step.couple.z() == 0.0);
  CHECK(step.force.z() == Approx(force).epsilon(1e-14));  // a couple leaves the force alone
  // A second step adds to the first.
  CHECK(law.step(pair, turning({1e-4, 0, 0}), step.state).couple.x() == Approx(-2 * k * 1e-4).epsilon(1e-13));
  CHECK(step.state.rolling_couple[0] == step.couple.x());
}

TEST_CASE("Rolling spring: the couple is at most mu_r R* F_n, and is reset when the contact opens") {
  const Law law = rolling(0.1);
  const auto far = law.step(pair, turning({3.0, 4.0, 0.0}), {});
  CHECK(far.couple.norm() == Approx(0.1 * radius * force).epsilon(1e-14));
  CHECK(far.couple.x() / far.couple.y() == Approx(0.75).epsilon(1e-14));
  CHECK(far.couple.x() < 0.0);
  const double k = law.rolling.stiffness(pair, normal_stiffness);
  const auto back = law.step(pair, turning({-1e-4, 0.0, 0.0}), far.state);  // unloads at once
  CHECK(back.couple.x() - far.couple.x() == Approx(k * 1e-4).epsilon(1e-10));
  ContactKinematics<double> apart = turning({1, 0, 0});
  apart.overlap = -1e-9;
  const auto open = law.step(pair, apart, far.state);
  CHECK(open.couple == V(0, 0, 0));
  CHECK(law.step(pair, turning({0, 0, 0}), open.state).couple == V(0, 0, 0));
}

TEST_CASE("Rolling spring: below the limit the stored energy is the work, k_r angle^2/2") {
  const Law law = rolling(0.1);
  EnergyLedger<double> ledger;
  Law::State state{};
  // The overlap is there from the start, so that the normal force does no work.
  const double normal = law.stored_energy(pair, overlap, state);
  ledger.stored = ledger.stored_at_start = normal;
  ledger.last_force = law.step(pair, turning({0, 0, 0}), state).force;
  const int steps = 100;
  const double angle = 1e-4;
  for (int i = 0; i < steps; ++i) {
    const auto k = turning({angle / steps, 0, 0});
    const auto step = law.step(pair, k, state);
    ledger.enter(law, pair, k, step);
    state = step.state;
  }
  const double k_r = law.rolling.stiffness(pair, normal_stiffness);
  // A trapezoid is exact for a linear spring; `stored` is 1e-8 of the normal energy it is a difference from.
  CHECK(ledger.work == Approx(k_r * angle * angle / 2).epsilon(1e-12));
  CHECK(ledger.stored - normal == Approx(k_r * angle * angle / 2).epsilon(1e-7));
}

TEST_CASE("Rolling spring: a ball on a plane stops after v0/(5/7 mu_r g), and stays on an incline below mu_r") {
  // The ball rolls without slip about its contact point: moment of inertia 7/5 m R^2, load m g cos(angle).
  const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
  const double r = 5e-3, g = 9.81, mu_r = 0.05;
  const double m = sphere_mass(r, granite.density);
  const PairProperties<double> on_plane = pair_properties(plane(granite), sphere(granite, r));
  const Law law = rolling(mu_r);
  const double inertia = 1.4 * m * r * r;
  const auto spin_after = [&](double tangent, double spin, double duration, int steps) {
    const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent), sine = tangent * cosine;
    const double stiffness = 4.0 / 3.0 * on_plane.effective_young * std::sqrt(on_plane.effective_radius);
    const double deep = std::pow(m * g * cosine / stiffness, 2.0 / 3.0);  // Hertz's force bears the weight
    const double dt = duration / steps;
    Law::State state{};
    double largest = 0.0;
    for (int i = 0; i < steps; ++i) {
      const auto step = law.step(on_plane, {{0, 0, 1}, deep, {0, 0, 0}, dt, 0.0, {0.0, spin, 0.0}}, state);
      state = step.state;
      spin += (m * g * r * sine + step.couple.y()) / inertia * dt;
      largest = std::max(largest, std::abs(spin));
    }
    return std::pair(spin, largest);
  };
  const double v0 = 0.01, first = v0 / r, stop = v0 / (5.0 / 7.0 * mu_r * g), deceleration = first / stop;
  // Until the spring yields, at the angle mu_r R P/k_r, the couple grows in proportion to the angle: half its impulse is missing.
  const double stiffness = 4.0 / 3.0 * on_plane.effective_young * std::sqrt(on_plane.effective_radius);
  const double deep = std::pow(m * g / stiffness, 2.0 / 3.0);
  const double k_r = 2.25 * (1.5 * m * g / deep) * (mu_r * r) * (mu_r * r), yield = mu_r * r * m * g / k_r;
  const double late = yield / (2.0 * first);
  // Neglected: the slowing down while the spring yields, 1e-3 of `late`, and half a step of the integration, 1e-5.
  CHECK(spin_after(0.0, first, 0.5 * stop, 100000).first ==
        Approx(0.5 * first + late * deceleration).margin(2e-5 * first));
  CHECK(spin_after(0.0, first, 0.99 * stop, 100000).first ==
        Approx(0.01 * first + late * deceleration).margin(2e-5 * first));

  // Released at rest below mu_r the spring holds, and the ball rocks: G (1 - cos(w t)) / k_r under the torque G.
  const auto with_angle = [](double tangent) { return 1.0 / std::sqrt(1.0 + tangent * tangent); };
  const double frequency = std::sqrt(k_r / inertia), gentle = 0.4 * mu_r;  // 2 tan < mu_r: no yield in the overshoot
  const double torque = m * g * r * gentle * with_angle(gentle);
  CHECK(spin_after(gentle, 0.0, 0.1, 100000).second == Approx(torque / k_r * frequency).epsilon(1e-3));  // w dt = 1e-3
  // Above mu_r it yields where cos(w t) = 1 - L/G, L the limit; from then on the surplus G - L accelerates the ball.
  const double steep = 1.5 * mu_r, drive = m * g * r * steep * with_angle(steep), limit = drive / 1.5;
  const double cosine = 1.0 - limit / drive, at_yield = std::acos(cosine) / frequency;
  const double spin_at_yield = drive / k_r * frequency * std::sqrt(1.0 - cosine * cosine);
  CHECK(spin_after(steep, 0.0, 0.1, 100000).first ==
        Approx(spin_at_yield + (drive - limit) / inertia * (0.1 - at_yield)).epsilon(1e-3));  // k_r of the load m g
}

TEMPLATE_TEST_CASE("Rolling spring: accuracy", "", double, float) {
  using T = TestType;
  Random random(20240612);
  double worst = 0.0;
  for (int i = 0; i < cases(50000); ++i) {
    const PairProperties<T> wide = wide_pair<T>(random);
    const Vec3<T> normal(T(0), T(0), T(1));
    const RollingSpring<T> law{random.binary<T>(-6, 2)};
    const T stiffness = random.binary<T>(0, 20);
    const T x = random.binary<T>(-20, 4);
    const T y = random.binary<T>(-20, 4);
    const ContactKinematics<T> k{normal, T(1), {T(0), T(0), T(0)}, random.binary<T>(-20, 0), T(0), {x, y, T(0)}};
    const T load = random.binary<T>(0, 20);
    typename RollingSpring<T>::State state{};
    const Vec3<T> computed = law.respond(state, {wide, k, stiffness, load}).couple;
    typename RollingSpring<Binary200>::State state_200{};
    const auto wide_200 = wide.template cast<Binary200>();
    const auto k_200 = k.template cast<Binary200>();
    const Vec3<Binary200> exact = RollingSpring<Binary200>{Binary200(law.rolling_friction)}
                                      .respond(state_200, {wide_200, k_200, Binary200(stiffness), Binary200(load)})
                                      .couple;
    for (int c = 0; c < 2; ++c) {
      const Binary200 error = abs(Binary200(computed[c]) - exact[c]) / norm<Binary200>(exact);
      worst = std::max(worst, static_cast<double>(error / std::numeric_limits<T>::epsilon()));
    }
  }
  CHECK(worst <= 9.0);  // k_r 5 roundings, the turn 1, the product 1, the limit 2
}

TEST_CASE("Rolling spring: its parameter is checked") {
  CHECK_THROWS_WITH(checked(rolling(-0.5)),
                    Catch::Matchers::Equals("RollingSpring: rolling_friction is -0.5, must lie in [0, inf)"));
}

}  // namespace contactlaws::test

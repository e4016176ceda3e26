// The ready-made laws against the hill memo: its numbers, and its equations 12 to 18 written out once more.
#include "contactlaws/laws.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

/// Moves the top grain along the contact, normal +z, shear along +x.
template <class Law>
struct TwoGrains {
  Law law;
  PairProperties<double> pair = granite_pair<double>();
  double overlap = 1e-4;
  typename Law::State state{};

  auto shear_by(double distance, double dt = 1e-6) {
    const auto step = law.step(pair, {{0, 0, 1}, overlap, {distance / dt, 0, 0}, dt}, state);
    state = step.state;
    return step;
  }
};

using Vector = std::array<long double, 3>;
long double inner(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The hill law as the memo's Section 1.6 puts it, step by step. The shear force follows the contact plane by projection,
/// at its old length.
struct MemoHill {
  long double k_n, k_s, alpha_n, alpha_s, mu, psi, r_o;
  int moisture = 0;
  Vector shear = {0, 0, 0};

  MemoHill(const PairProperties<double>& pair, const HillProperties<double>& p)
      : k_n(4.0L / 3.0L * pair.effective_young * std::sqrt(static_cast<long double>(pair.effective_radius))),
        k_s(8.0L * pair.effective_shear * std::sqrt(static_cast<long double>(pair.effective_radius))),
        alpha_n(p.damping_constant * std::sqrt(pair.effective_mass * k_n)),
        alpha_s(p.damping_constant * std::sqrt(pair.effective_mass * k_s)),
        mu(p.friction),
        psi(p.suction),
        r_o(pair.min_radius) {}

  static void limit(Vector& force, long double strength, bool& slips) {
    const long double size = std::sqrt(inner(force, force));
    if (size <= strength) return;
    for (long double& f : force) f *= strength / size;
    slips = true;
  }

  Vector step(const Vector& n, long double o, const Vector& v, long double dt, bool& slips) {
    const long double pi = std::acos(-1.0L), gap = -o;
    long double f_m = 0;  // (12)
    if (moisture == 2) {
      const long double f_max = psi * pi * r_o * r_o;
      if (gap <= 0) {
        f_m = f_max;
      } else if (gap < 2 * r_o) {
        f_m = f_max * std::exp(-gap / (2 * r_o));
      } else {
        moisture = 1;
      }
    }
    slips = false;
    long double f_n = 0;
    Vector f_s = {0, 0, 0};
    if (o > 0) {
      const long double v_n = inner(v, n);
      f_n = k_n * std::pow(o, 1.5L) - alpha_n * std::pow(o, 0.25L) * v_n;  // (13)
      const long double strength = mu * std::max(f_n, 0.0L);               // (14)
      const long double length = std::sqrt(inner(shear, shear)), out = inner(shear, n);
      for (std::size_t i = 0; i < 3; ++i) shear[i] -= out * n[i];
      const long double projected = std::sqrt(inner(shear, shear));
      Vector v_s;
      for (std::size_t i = 0; i < 3; ++i) {
        if (projected > 0) shear[i] *= length / projected;
        v_s[i] = v[i] - v_n * n[i];
        shear[i] -= k_s * std::sqrt(o) * v_s[i] * dt;  // (15)
      }
      limit(shear, strength, slips);                                                                  // (16)
      for (std::size_t i = 0; i < 3; ++i) f_s[i] = shear[i] - alpha_s * std::pow(o, 0.25L) * v_s[i];  // (17)
      limit(f_s, strength, slips);                                                                    // (18)
    } else {
      shear = {0, 0, 0};
    }
    for (std::size_t i = 0; i < 3; ++i) f_s[i] += (f_n - f_m) * n[i];
    return f_s;
  }
};

Vector precise(const Vec3<double>& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

TEST_CASE("The hill law follows the memo's equations 12 to 18 along random paths") {
  HillProperties<double> properties;
  properties.friction = 0.4;
  properties.suction = 2e5;
  properties.damping_constant = 0.3;
  const Hill<double> law = hill(properties);
  Random random;
  double worst = 0.0;
  int slipped = 0, stuck = 0, ruptured = 0;
  for (int path = 0; path < cases(1000); ++path) {
    const PairProperties<double> pair = granite_pair<double>();
    MemoHill memo(pair, properties);
    Hill<double>::State state{};
    if (random.chance(0.5)) {
      Hill<double>::make_wet(state, 0.0, 0.0);
      memo.moisture = 2;
    }
    Vec3<double> normal = random.direction();
    double largest = 0.0, difference = 0.0;
    for (int i = 0; i < 100; ++i) {
      normal = (normal + random.uniform(0, 0.1) * random.direction()).normalized();
      const double overlap = random.chance(0.03)   ? -random.log_uniform(1e-6, 3e-2)
                             : random.chance(0.01) ? 0.0
                                                   : random.log_uniform(1e-6, 2e-4);
      const Vec3<double> velocity = random.log_uniform(1e-2, 20.0) * random.direction();
      const double dt = random.log_uniform(1e-8, 1e-6);
      const auto step = law.step(pair, {normal, overlap, velocity, dt}, state);
      state = step.state;
      bool slips = false;
      const Vector expected = memo.step(precise(normal), overlap, precise(velocity), dt, slips);
      CHECK(step.sliding == slips);
      CHECK(state.moisture == memo.moisture);
      CHECK(step.active == (overlap >= 0 || memo.moisture == 2));
      for (std::size_t c = 0; c < 3; ++c) {
        difference = std::max(difference, static_cast<double>(std::abs(step.force[static_cast<int>(c)] - expected[c])));
        largest = std::max(largest, static_cast<double>(std::abs(expected[c])));
      }
      (slips ? slipped : stuck) += overlap > 0;
      ruptured += memo.moisture == 1;
    }
    worst = std::max(worst, difference / largest);
  }
  CHECK(worst <= 1e-13);  // relative to the largest force of the path, over 100 steps of some 20 roundings each
  CHECK(std::min(slipped, stuck) > cases(1000));  // the paths do go through every branch
  CHECK(ruptured > 0);
}

// The numbers are printed to 12 digits in the restored physics, and the memo's own to 5.
TEST_CASE("Two grains, hill law: normal force, then 99.0 um of shear") {
  TwoGrains<DryHill<double>> grains{test::dry_hill<double>(0.4, 0.0)};
  const auto slipping = grains.shear_by(99.0e-6);
  CHECK(slipping.normal_elastic == Approx(1083.30463206).epsilon(1e-11));
  CHECK(slipping.force.x() == Approx(-433.321852826).epsilon(1e-11));
  CHECK(slipping.sliding);

  TwoGrains<DryHill<double>> rough{test::dry_hill<double>(10.0, 0.0)};
  double x = 0.0;
  for (int i = 0; i < 100; ++i) x = rough.shear_by(99.0e-6 / 100).force.x();
  CHECK(x == Approx(-1478.27164521).epsilon(1e-11));
}

TEST_CASE("Two grains, linear law: normal force, then 99.0 um of shear") {
  const LinearFriction<double> law{{29e9}, {}, {{1.0}, 0.4}, {}};
  TwoGrains<LinearFriction<double>> grains{law};
  const auto slipping = grains.shear_by(99.0e-6);
  CHECK(slipping.normal_elastic == Approx(18221.2373908).epsilon(1e-11));
  CHECK(slipping.force.x() == Approx(-7288.49495633).epsilon(1e-11));

  TwoGrains<LinearFriction<double>> rough{{{29e9}, {}, {{1.0}, 10.0}, {}}};
  CHECK(rough.shear_by(99.0e-6).force.x() == Approx(-18039.0250169).epsilon(1e-11));
}

TEST_CASE("Two grains, hill law with dashpots: moving, then stopped") {
  TwoGrains<DryHill<double>> grains{test::dry_hill<double>(1000.0, 0.07)};
  const auto pressed = grains.law.step(grains.pair, {{0, 0, 1}, 2e-4, {0, 0, -100.0}, 1e-6}, {});
  CHECK(pressed.normal_force == Approx(3960.44634634).epsilon(1e-11));
  const auto rest = grains.law.step(grains.pair, {{0, 0, 1}, 2e-4, {0, 0, 0}, 1e-6}, pressed.state);
  CHECK(rest.normal_force == Approx(3064.04820570).epsilon(1e-11));

  for (int i = 0; i < 99; ++i) grains.shear_by(1e-6);
  CHECK(grains.shear_by(4.95e-6).force.x() ==
        Approx(-1595.99115427).epsilon(1e-11));  // 1000 rad/s on an arm of 4.95 mm
  CHECK(grains.shear_by(0.0).force.x() == Approx(-1552.18522748).epsilon(1e-11));
}

TEST_CASE("Linear and hill law cross over: stiffnesses at 12.574 mm, forces at 28.291 mm of overlap") {
  const LinearFriction<double> linear{{29e9}, {}, {{1.0}, 0.4}, {}};
  const DryHill<double> hertz = test::dry_hill<double>(0.4, 0.0);
  const PairProperties<double> pair = granite_pair<double>();
  // Printed to half a micrometre: 4e-5 of the overlap, and half of that in the stiffness, which goes with its root.
  CHECK(hertz.stiffness(pair, 12.574e-3, {}).normal ==
        Approx(linear.stiffness(pair, 12.574e-3, {}).normal).epsilon(2e-5));
  const auto force = [&pair](const auto& law, double overlap) {
    return law.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, 1e-6}, {}).normal_elastic;
  };
  CHECK(force(hertz, 28.291e-3) == Approx(force(linear, 28.291e-3)).epsilon(2e-5));
}

TEST_CASE("Wet grains at rest: suction is balanced at an overlap of 5.946 um") {
  const Hill<double> law = test::hill<double>(0.4, 2e5, 0.0);
  const PairProperties<double> pair = granite_pair<double>();
  Hill<double>::State wet{};
  Hill<double>::make_wet(wet, 5.946e-6, 0.0);
  const auto step = law.step(pair, {{0, 0, 1}, 5.946e-6, {0, 0, 0}, 1e-6}, wet);
  CHECK(step.bridge_force == Approx(15.70796).epsilon(1e-6));               // 7 printed digits
  CHECK(step.normal_elastic == Approx(step.bridge_force).epsilon(1.5e-4));  // 3/2 of the overlap's last digit
}

TEST_CASE("Doubling the overlap keeps a force history and multiplies a displacement history by sqrt(2)") {
  const auto ratio = [](const auto& law) {
    TwoGrains<std::decay_t<decltype(law)>> grains{law};
    const double before = grains.shear_by(1e-5).force.x();
    grains.overlap *= 2.0;
    return grains.shear_by(0.0).force.x() / before;
  };
  using Displacement = ContactLaw<Hertz<double>, NoDashpots<double>, ShearDisplacement<double>>;
  CHECK(ratio(test::dry_hill<double>(10.0, 0.0)) == 1.0);
  CHECK(ratio(Displacement{{}, {}, {{}, 10.0}, {}}) == Approx(std::sqrt(2.0)).epsilon(1e-15));
}

TEST_CASE("Makers name the parameter out of range, with value, unit and range") {
  using Catch::Matchers::Equals;
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(test::hill<double>(-0.5, 0.0, 0.0), Equals("ShearForce: friction is -0.5, must lie in [0, inf)"));
  CHECK_THROWS_WITH(test::hill<double>(nan, 0.0, 0.0), Equals("ShearForce: friction is nan, must lie in [0, inf)"));
  CHECK_THROWS_WITH(test::dry_hill<double>(inf), Equals("ShearForce: friction is inf, must lie in [0, inf)"));
  CHECK_THROWS_WITH(test::hill<double>(0.4, -1.0, 0.0),
                    Equals("SuctionBridge: suction is -1 Pa, must lie in [0, inf)"));
  CHECK_THROWS_WITH(test::hill<double>(0.4, nan, 0.0),
                    Equals("SuctionBridge: suction is nan Pa, must lie in [0, inf)"));
  CHECK_THROWS_WITH(test::dry_hill<double>(0.4, -0.25),
                    Equals("Dashpots: damping_constant is -0.25, must lie in [0, inf)"));
  CHECK_NOTHROW(test::hill<double>(0.0, 0.0, 0.0));
  CHECK_NOTHROW(test::hill<double>(1e9, 1e9, 2.0));  // damping_constant above 1: a low restitution

  LinearFrictionProperties<double> linear;
  CHECK_THROWS_WITH(linear_friction(linear), Equals("LinearModulus: modulus is 0 Pa, must lie in (0, inf)"));
  linear.modulus = 5e8;
  linear.stiffness_ratio = -1.0;
  CHECK_THROWS_WITH(linear_friction(linear), Equals("ShearForce: ratio is -1, must lie in (0, inf)"));
  LinearSpringDashpotProperties<double> spring;
  CHECK_THROWS_WITH(linear_spring_dashpot(spring),
                    Equals("LinearSpring: normal_stiffness is 0 N/m, must lie in (0, inf)"));
  RoughBallastProperties<double> ballast;
  ballast.fractal_dimension = 2.13;
  CHECK_THROWS_WITH(rough_ballast(ballast), Equals("RoughSurface: roughness is 0 m, must lie in (0, inf)"));
}

TEST_CASE("Makers give the parameters to the slots") {
  HillProperties<double> of_hill;
  of_hill.friction = 0.4;
  of_hill.suction = 2e5;
  of_hill.damping_constant = 0.3;
  const Hill<double, Tension::clipped> wet = hill<Tension::clipped>(of_hill);
  CHECK(wet.shear.friction == 0.4);
  CHECK(wet.bridge.suction == 2e5);
  CHECK(wet.damping.damping_constant == 0.3);
  LinearSpringDashpotProperties<double> spring;
  spring.normal_stiffness = 1e6;
  spring.friction = 0.5;
  spring.stiffness_ratio = 0.6;
  spring.damping_constant = 0.1;
  const LinearSpringDashpot<double> linear = linear_spring_dashpot(spring);
  CHECK(linear.normal.normal_stiffness == 1e6);
  CHECK(linear.shear.friction == 0.5);
  CHECK(linear.shear.ratio == 0.6);
  CHECK(linear.damping.damping_constant == 0.1);
  RoughBallastProperties<double> ballast;
  ballast.fractal_dimension = 2.13;
  ballast.roughness = 26.1e-6;
  ballast.friction = 0.7;
  const RoughBallast<double> rough = rough_ballast(ballast);
  CHECK(rough.normal.transition_overlap == Approx(132.70776e-6).epsilon(1e-7));  // the paper's surface, 8 digits
  CHECK(rough.shear.friction == 0.7);
}

TEST_CASE("Parameters are set by name, of a law and of a maker's properties") {
  using Catch::Matchers::Equals;
  Hill<double> wet;
  set_parameter(wet, "suction", 2e5);
  set_parameter(wet, "friction", 0.4);
  CHECK(wet.bridge.suction == 2e5);
  CHECK(wet.shear.friction == 0.4);
  CHECK_THROWS_WITH(set_parameter(wet, "fricton", 0.4), Equals("no parameter 'fricton'; there are: damping_constant, "
                                                               "friction, suction, decay_length, rupture_gap"));
  SmoothHertz<double> smooth;
  CHECK_THROWS_WITH(set_parameter(smooth, "friction", 0.4), Equals("no parameter 'friction'; there is none"));
  CHECK_THROWS_WITH(set_parameter(smooth, "friction", 0.4, "young, poisson"),
                    Equals("no parameter 'friction'; there are: young, poisson"));
  RoughBallastProperties<double> ballast;
  const char* names[] = {"fractal_dimension", "roughness", "friction", "stiffness_ratio"};
  const double values[] = {2.13, 26.1e-6, 0.7, 0.9};
  for (int i = 0; i < 4; ++i) set_parameter(ballast, names[i], values[i]);
  CHECK(rough_ballast(ballast).normal.transition_overlap == Approx(132.70776e-6).epsilon(1e-7));
  CHECK(rough_ballast(ballast).shear.friction == 0.7);
  CHECK(rough_ballast(ballast).shear.ratio == 0.9);
}

/// What a host sets by name besides a law's parameters.
struct LawAndMaterial {
  DryHillProperties<double> law;
  ElasticMaterial<double> material;
  auto slots() { return std::tie(law, material); }
};
TEST_CASE("Parameters are set by name in a host's own group of them") {
  using Catch::Matchers::Equals;
  LawAndMaterial all{};
  set_parameter(all, "friction", 0.4);
  set_parameter(all, "young", 29e9);
  CHECK(all.law.friction == 0.4);
  CHECK(all.material.young == 29e9);
  CHECK_THROWS_WITH(set_parameter(all, "mu", 0.4), Equals("no parameter 'mu'; there are: friction, damping_constant, "
                                                          "young, poisson, density"));
}

TEST_CASE("A law says which of its slots' parameters is out of range") {
  using Catch::Matchers::Equals;
  LinearSpringDashpot<double> law{{1e6}, {0.1}, {{0.5}, 0.4}, {}};
  CHECK_NOTHROW(checked(law));
  law.shear.ratio = -1.0;
  CHECK_THROWS_WITH(checked(law), Equals("ShearForce: ratio is -1, must lie in (0, inf)"));
  law = {{0.0}, {0.1}, {{0.5}, 0.4}, {}};
  CHECK_THROWS_WITH(checked(law), Equals("LinearSpring: normal_stiffness is 0 N/m, must lie in (0, inf)"));
  law = {{1e6}, {-0.5}, {{0.5}, 0.4}, {}};
  CHECK_THROWS_WITH(checked(law), Equals("Dashpots: damping_constant is -0.5, must lie in [0, inf)"));
  Hill<double> wet;
  wet.bridge.rupture_gap = 0.0;
  CHECK_THROWS_WITH(checked(wet), Equals("SuctionBridge: rupture_gap is 0, must lie in (0, inf)"));
  wet.bridge.rupture_gap = 2.0;
  wet.bridge.decay_length = -2.0;
  CHECK_THROWS_WITH(checked(wet), Equals("SuctionBridge: decay_length is -2, must lie in (0, inf)"));
}

}  // namespace contactlaws::test

#include "contactlaws/damping/restitution.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Restitution of a head-on impact, by integrating m* dv/dt = F with the law's own force (Runge-Kutta, fourth order).
/// Steps shrink towards touch, where o^(1/4) has no derivatives.
template <class Law>
double impact(const Law& law, const PairProperties<double>& pair, double speed, double duration) {
  struct Motion {
    double overlap, separating;
  };
  const auto rate = [&](const Motion& m) {
    const auto step = law.step(pair, {{0, 0, 1}, m.overlap, {0, 0, m.separating}, 1.0}, {});
    return Motion{-m.separating, step.normal_force / pair.effective_mass};
  };
  const auto ahead = [](const Motion& m, const Motion& r, double dt) {
    return Motion{m.overlap + dt * r.overlap, m.separating + dt * r.separating};
  };
  const double touch = 1e-15 * speed * duration;
  Motion m{touch, -speed};
  while (m.overlap >= touch) {
    const double dt = std::min(2e-4 * duration, 0.02 * m.overlap / std::abs(m.separating) + 1e-18 * duration);
    const Motion a = rate(m), b = rate(ahead(m, a, dt / 2)), c = rate(ahead(m, b, dt / 2)), d = rate(ahead(m, c, dt));
    m.overlap += dt / 6 * (a.overlap + 2 * b.overlap + 2 * c.overlap + d.overlap);
    m.separating += dt / 6 * (a.separating + 2 * b.separating + 2 * c.separating + d.separating);
  }
  return m.separating / speed;
}

template <Tension tension>
void impacts_realise(double asked) {
  const PairProperties<double> pair = granite_pair<double>();
  for (const double speed : {1e-3, 4.0}) {
    INFO("asked " << asked << " at " << speed << " m/s, " << (tension == Tension::clipped ? "clipped" : "allowed"));
    const DryHill<double, tension> hertz{{}, {damping_constant(asked, Spring::hertz, tension)}, {{}, 0.0}, {}};
    const double deepest = std::pow(
        15 * pair.effective_mass * speed * speed / (16 * pair.effective_young * std::sqrt(pair.effective_radius)), 0.4);
    CHECK(impact(hertz, pair, speed, 3 * deepest / speed) == Approx(asked).epsilon(1e-6));

    LinearSpringDashpot<double, tension> linear{
        {1e6}, {damping_constant(asked, Spring::linear, tension)}, {{1}, 0}, {}};
    CHECK(impact(linear, pair, speed, 3.14 * std::sqrt(pair.effective_mass / 1e6)) == Approx(asked).epsilon(1e-6));
  }
}

}  // namespace

TEST_CASE("Restitution: an impact realises what was asked for, at any speed") {
  for (const double asked : {0.05, 0.1, 0.135, 0.3, 0.5, 0.7, 0.9, 0.98, 1.0}) {
    impacts_realise<Tension::allowed>(asked);
    impacts_realise<Tension::clipped>(asked);
  }
}

TEST_CASE("Restitution: the closed form where tension is allowed") {
  for (const double e : {0.05, 0.5, 0.98}) {
    const double log_e = std::log(e), pi = 3.14159265358979324;
    const double ratio = -log_e / std::sqrt(log_e * log_e + pi * pi);
    CHECK(damping_constant(e, Spring::hertz, Tension::allowed) == Approx(std::sqrt(5.0) * ratio).epsilon(1e-15));
    CHECK(damping_constant(e, Spring::linear, Tension::allowed) == Approx(2.0 * ratio).epsilon(1e-15));
  }
}

TEST_CASE("Restitution: what the formula for tension gives where tension is clipped") {
  const double asked[] = {0.1, 0.3, 0.5, 0.7, 0.9}, gives[] = {0.2527, 0.3971, 0.5503, 0.7182, 0.9020};
  for (int i = 0; i < 5; ++i) {
    const double alpha = damping_constant(asked[i], Spring::hertz, Tension::allowed);
    CHECK(restitution(alpha, Spring::hertz, Tension::clipped) == Approx(gives[i]).margin(0.5e-4));  // 4 printed digits
  }
}

TEST_CASE("Restitution: critical damping where tension is clipped gives exp(-2), smoothly from either side") {
  CHECK(restitution(2.0, Spring::linear, Tension::clipped) == Approx(std::exp(-2.0)).epsilon(1e-15));
  // z acos(z)/sqrt(1-z^2) = 1 - 2(1-z)/3 + ..., so e = exp(-2)(1 + 4/3 (1-z))
  for (const double below : {1e-3, 1e-8, -1e-8, -1e-3})
    CHECK(restitution_of_damping_ratio(1.0 - below, Tension::clipped) ==
          Approx(std::exp(-2.0) * (1.0 + 4.0 / 3.0 * below)).epsilon(1e-15 + 2.0 * below * below));
  CHECK(restitution(2.0, Spring::linear, Tension::allowed) == 0.0);  // never parts
  CHECK(restitution(3.0, Spring::linear, Tension::allowed) == 0.0);
  CHECK(restitution(20.0, Spring::linear, Tension::clipped) > 0.0);  // 400 times its critical force, and still parts
}

TEST_CASE("Restitution: without loss there is no damping, exactly") {
  for (const Tension tension : {Tension::allowed, Tension::clipped})
    for (const Spring spring : {Spring::hertz, Spring::linear}) {
      const double alpha = damping_constant(1.0, spring, tension);
      CHECK(alpha == 0.0);
      CHECK_FALSE(std::signbit(alpha));
      CHECK(restitution(0.0, spring, tension) == 1.0);
    }
}

TEST_CASE("Restitution: there and back") {
  Random random;
  for (int i = 0; i < cases(5000); ++i) {
    const double e = random.chance(0.5) ? random.log_uniform(1e-300, 1.0) : 1.0 - random.log_uniform(1e-16, 0.9);
    for (const Tension tension : {Tension::allowed, Tension::clipped})
      for (const Spring spring : {Spring::hertz, Spring::linear}) {
        const double alpha = damping_constant(e, spring, tension);
        const double ratio = spring == Spring::hertz ? alpha / std::sqrt(5.0) : alpha / 2.0;
        // e = exp(-d(z)): its relative error is d = |ln e| times that of d, some 8 eps; and where tension is allowed
        // d = pi z/sqrt(1-z^2), which multiplies that of z by 1/(1-z^2).
        const double condition = tension == Tension::allowed ? 1.0 / ((1.0 - ratio) * (1.0 + ratio)) : 1.0;
        if (condition > 1e3) continue;  // e < 1e-43: z is 1 to three digits and holds no more of e
        const double tolerance = eps * (4.0 + 16.0 * -std::log(e) * condition);
        CHECK(std::abs(restitution(alpha, spring, tension) / e - 1.0) <= tolerance);
      }
  }
}

TEMPLATE_TEST_CASE("Restitution: accuracy of the damping ratio", "", double, float) {
  using T = TestType;
  Random random;
  Worst allowed("damping ratio, tension allowed" + precision_name<T>()),
      clipped("damping ratio, tension clipped" + precision_name<T>());
  const auto judge = [&](T e) {
    const auto error = [e](Tension tension) {
      return ulps(damping_ratio_of_restitution<T>(e, tension),
                  damping_ratio_of_restitution<Binary200>(Binary200(e), tension));
    };
    allowed.see(error(Tension::allowed), e);
    // Far beyond critical damping z grows as 1/sqrt(e), so that ULPs of ln e count for as much as its size.
    const double without_tension = error(Tension::clipped);
    if (e >= T(0.1)) clipped.see(without_tension, e);
    CHECK(without_tension <= 4.0 - 2.0 * std::log(static_cast<double>(e)));
  };
  for (int i = 0; i < cases(500); ++i) {
    judge(static_cast<T>(random.uniform(0.0, 1.0)));
    judge(static_cast<T>(random.log_uniform(sizeof(T) == 4 ? 1e-37 : 1e-300, 1.0)));
    judge(T(1) - static_cast<T>(random.log_uniform(sizeof(T) == 4 ? 1e-7 : 1e-15, 0.5)));
    judge(static_cast<T>(std::exp(-2.0) * (1.0 + random.uniform(-3e-3, 3e-3))));  // about critical damping
  }
  CHECK(allowed.error() <= 3.0);  // what the header promises
  CHECK(clipped.error() <= 8.0);
}

TEST_CASE("Restitution: 200 bits agree with an independent solution of the clipped impact") {
  // acos and acosh as Boost has them, and bisection instead of Newton.
  for (const double asked : {0.01, 0.1, 0.1353, 0.14, 0.5, 0.99}) {
    const auto decrement_of = [](const Binary200& z) {
      return z < 1 ? Binary200(2 * z * acos(z) / sqrt(1 - z * z)) : Binary200(2 * z * acosh(z) / sqrt(z * z - 1));
    };
    Binary200 low = 1e-9, high = 1e9;
    const Binary200 decrement = -log(Binary200(asked));
    for (int i = 0; i < 260; ++i) {
      const Binary200 middle = (low + high) / 2;
      (decrement_of(middle) < decrement ? low : high) = middle;
    }
    const Binary200 ours = damping_ratio_of_restitution<Binary200>(Binary200(asked), Tension::clipped);
    INFO(asked);
    CHECK(static_cast<double>(abs(ours / low - 1)) < 1e-50);  // 200 bits are 60 digits
  }
}

TEST_CASE("Restitution: a law's own dashpots and spring") {
  CHECK(damping_constant<DryHill<double>>(0.5) == damping_constant(0.5, Spring::hertz, Tension::allowed));
  CHECK(damping_constant<DryHill<double, Tension::clipped>>(0.5) ==
        damping_constant(0.5, Spring::hertz, Tension::clipped));
  CHECK(damping_constant<WetGrains<double>>(0.5) == damping_constant(0.5, Spring::hertz, Tension::clipped));
  CHECK(damping_constant<CohesivePowder<double>>(0.5) == damping_constant(0.5, Spring::hertz, Tension::allowed));
  CHECK(damping_constant<LinearSpringDashpot<double>>(0.5) == damping_constant(0.5, Spring::linear, Tension::allowed));
}

TEST_CASE("Restitution: out of (0, 1] it is refused by name") {
  using Catch::Matchers::Equals;
  const auto refuses = [](double e, const std::string& value) {
    for (const Tension tension : {Tension::allowed, Tension::clipped})
      CHECK_THROWS_WITH(damping_constant(e, Spring::hertz, tension),
                        Equals("Dashpots: restitution is " + value + ", must lie in (0, 1]"));
  };
  refuses(0.0, "0");
  refuses(-0.5, "-0.5");
  refuses(1.1, "1.1");
  refuses(std::numeric_limits<double>::infinity(), "inf");
  refuses(std::numeric_limits<double>::quiet_NaN(), "nan");
}

}  // namespace contactlaws::test

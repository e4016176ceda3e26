// Rolling and twisting: the laws beside RollingSpring.
#include "catch.hpp"
#include "contactlaws/contactlaws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using V = Vec3<double>;
template <class Rolling>
using Law = ContactLaw<Hertz<double>, NoDashpots<double>, Frictionless<double>, Dry<double>, Rolling>;

/// The memo's grains, R* = 3 mm, 0.1 mm deep, normal +z.
const PairProperties<double> pair = granite_pair<double>();
constexpr double overlap = 1e-4, force = 1083.30463206478, radius = 3e-3;
constexpr double normal_stiffness = 1.5 * force / overlap, shear_stiffness = 1.49320368203524e9 * 1e-2;

template <class Rolling>
auto step(const Rolling& rolling, const V& spin, double dt = 1.0, const typename Law<Rolling>::State& state = {}) {
  return Law<Rolling>{{}, {}, {}, {}, rolling}.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, spin}, state);
}

}  // namespace

TEST_CASE("Constant torque: mu_r R* F against rolling, whatever its speed; nothing at rest or against twisting") {
  const RollingTorque<double> law{0.1};
  for (const double speed : {1e-6, 1.0, 1e6}) {
    const auto s = step(law, {3 * speed, -4 * speed, 7.0}, 1e-3);
    CHECK(s.couple.x() == Approx(-0.6 * 0.1 * radius * force).epsilon(1e-13));
    CHECK(s.couple.y() == Approx(0.8 * 0.1 * radius * force).epsilon(1e-13));
    CHECK(s.couple.z() == 0.0);
    CHECK(s.friction_work == Approx(0.1 * radius * force * 5 * speed * 1e-3).epsilon(1e-13));
  }
  CHECK(step(law, {0, 0, 7.0}).couple == V(0, 0, 0));
}

TEST_CASE("Constant torque: a ball that rolls on a plane stops after v0/(5/7 mu_r g)") {
  const double r = 5e-3, g = 9.81, mu_r = 0.05, v0 = 0.01, m = sphere_mass(r, 2650.0), inertia = 1.4 * m * r * r;
  const ElasticMaterial<double> granite{29e9, 0.15, 2650.0};
  const PairProperties<double> on_plane = pair_properties(plane(granite), sphere(granite, r));
  const double deep =
      std::pow(m * g / (4.0 / 3.0 * on_plane.effective_young * std::sqrt(on_plane.effective_radius)), 2.0 / 3.0);
  const Law<RollingTorque<double>> law{{}, {}, {}, {}, {mu_r}};
  const double stop = v0 / (5.0 / 7.0 * mu_r * g);
  const int steps = 10000;
  double spin = v0 / r;
  int stopped = 0;
  for (int i = 1; i <= steps && stopped == 0; ++i) {
    const double dt = 1.1 * stop / steps;
    spin += law.step(on_plane, {{0, 0, 1}, deep, {0, 0, 0}, dt, 0.0, {0, spin, 0}}, {}).couple.y() / inertia * dt;
    if (spin <= 0.0) stopped = i;
  }
  CHECK(1.1 * stopped / steps == Approx(1.0).margin(2e-4));  // to a step
}

TEST_CASE("Rolling spring and dashpot: three stiffnesses; the dashpot acts below the limit") {
  const double mass = 1.07038549697309e-3, angle = 1e-5;
  const auto check = [&](const auto& law, double k) {
    CHECK(law.stiffness(pair, normal_stiffness) == Approx(k).epsilon(1e-13));
    const auto s = step(law, {angle / 1e-3, 0, 5.0}, 1e-3);
    const double c = 0.3 * std::sqrt(mass * radius * radius * k);
    CHECK(s.couple.x() == Approx(-k * angle - c * angle / 1e-3).epsilon(1e-12));
    CHECK(s.couple.z() == 0.0);
    CHECK(s.dashpot_work == Approx(c * angle * angle / 1e-3).epsilon(1e-12));
    CHECK(s.state.rolling_couple[0] == Approx(-k * angle).epsilon(1e-13));
    const auto far = step(law, {0, 1e3, 0}, 1e-3);
    CHECK(far.couple.y() == Approx(-0.2 * radius * force).epsilon(1e-13));
    CHECK(far.dashpot_work == 0.0);
    CHECK(step(law, {0, 1e3, 0}, 0.0, far.state).couple == far.couple);
  };
  check(RollingSpringDashpot<double>{{}, 0.2, 0.3}, 2.25 * normal_stiffness * std::pow(0.2 * radius, 2));
  RollingSpringDashpot<double, ShearRolling<double>> of_shear{{mindlin_ratio(pair)}, 0.2, 0.3};
  check(of_shear, shear_stiffness * radius * radius);
  check(RollingSpringDashpot<double, GivenRolling<double>>{{7.0}, 0.2, 0.3}, 7.0);
  // Without a dashpot it is RollingSpring, bit for bit.
  const auto with = step(RollingSpringDashpot<double>{{}, 0.2, 0.0}, {1e-4, 2e-4, 0});
  CHECK(with.couple == step(RollingSpring<double>{0.2}, {1e-4, 2e-4, 0}).couple);
}

TEST_CASE("Rolling dashpot: a ball that rocks decays by exp(-alpha_r w t/2 m* R*^2/I)") {
  // I w'' + c w' + k w = 0: amplitude ratio of two crossings at rest, exp(-c T/(2 I)).
  const double k = 7.0, mass = 1.07038549697309e-3, inertia = mass * radius * radius, alpha = 0.2;
  const Law<RollingSpringDashpot<double, GivenRolling<double>>> law{{}, {}, {}, {}, {{k}, 10.0, alpha}};
  const double damped = std::sqrt(k / inertia * (1.0 - alpha * alpha / 4.0)), duration = 2 * 3.14159265358979 / damped;
  constexpr int steps = 20000;
  decltype(law)::State state{};
  double spin = 1e-3;
  for (int i = 0; i < steps; ++i) {
    const double dt = duration / steps;
    const auto s = law.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, {spin, 0, 0}}, state);
    state = s.state;
    spin += s.couple.x() / inertia * dt;
  }
  CHECK(spin / 1e-3 == Approx(std::exp(-alpha / 2 * std::sqrt(k / inertia) * duration)).epsilon(2e-3));  // w dt = 3e-4
}

TEST_CASE("Twisting: k_s a^2/2 to 2/3 mu a F; a spinning ball stops after I w0/L") {
  const TwistingSpring<double> law{0.4};
  const double a = std::sqrt(radius * overlap), k = shear_stiffness * a * a / 2, limit = 2.0 / 3.0 * 0.4 * a * force;
  CHECK(law.stiffness(pair, normal_stiffness) == Approx(k).epsilon(1e-13));
  const auto s = step(law, {0.3, -0.2, 1e-5});
  CHECK(s.couple.x() == 0.0);
  CHECK(s.couple.z() == Approx(-k * 1e-5).epsilon(1e-13));
  CHECK(s.friction_work == 0.0);
  CHECK(Law<TwistingSpring<double>>{{}, {}, {}, {}, law}.stored_energy(pair, overlap, s.state) -
            hertz_energy(pair, overlap) ==
        Approx(k * 1e-10 / 2).epsilon(1e-6));
  const auto far = step(law, {0, 0, 10.0});
  CHECK(far.couple.z() == Approx(-limit).epsilon(1e-13));
  CHECK(far.friction_work == Approx(limit * (10.0 - limit / k)).epsilon(1e-12));
  CHECK(step(law, {0, 0, -1e-5}, 1.0, far.state).couple.z() == Approx(-limit + k * 1e-5).epsilon(1e-12));

  // A ball in the socket of this contact: the spring yields at the angle L/k, until then half of its impulse is missing: 2e-4.
  const double inertia = 1e-6, spin0 = 5e3, stop = inertia * spin0 / limit;
  const Law<TwistingSpring<double>> whole{{}, {}, {}, {}, law};
  Law<TwistingSpring<double>>::State state{};
  double spin = spin0;
  constexpr int steps = 100000;
  for (int i = 0; i < steps; ++i) {
    const double dt = 0.9 * stop / steps;
    const auto at = whole.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, {0, 0, spin}}, state);
    state = at.state;
    spin += at.couple.z() / inertia * dt;
  }
  const double late = limit / k / (2 * spin0);
  CHECK(spin / spin0 == Approx(0.1 + late / stop).margin(2e-5));  // half a step
}

TEST_CASE("Twisting spring and dashpot: half of the sliding dashpot times a^2; friction limits the sum") {
  // Marshall (2009), as LAMMPS documents twisting marshall: k_t = k_s a^2/2, eta_t = eta_s a^2/2, L = 2/3 mu a F, of the sliding
  // spring and dashpot.
  const double a = std::sqrt(radius * overlap), alpha = 0.3, angle = 1e-5, dt = 1e-3;
  const double k = shear_stiffness * a * a / 2, limit = 2.0 / 3.0 * 0.4 * a * force;
  const double sliding = Dashpots<double>{alpha}.coefficients(pair.effective_mass, 1.0, shear_stiffness).shear;
  const double c = sliding * a * a / 2;
  const TwistingSpringDashpot<double> law{{0.4, alpha}};
  const auto s = step(law, {0.3, -0.2, angle / dt}, dt);
  CHECK(s.couple.x() == 0.0);
  CHECK(s.couple.z() == Approx(-k * angle - c * angle / dt).epsilon(1e-12));
  CHECK(s.state.twisting_couple == Approx(-k * angle).epsilon(1e-13));
  CHECK(s.dashpot_work == Approx(c * angle * angle / dt).epsilon(1e-12));
  CHECK(s.friction_work == 0.0);
  CHECK(step(law, {0, 0, -angle / dt}, dt).couple == V(-s.couple));

  // The spring bears less than the limit, the sum does not: the dashpot bears the rest.
  const auto fast = step(law, {0, 0, angle / 1e-10}, 1e-10);
  CHECK(fast.couple.z() == Approx(-limit).epsilon(1e-13));
  CHECK(fast.state.twisting_couple == Approx(-k * angle).epsilon(1e-13));
  CHECK(fast.dashpot_work == Approx((limit - k * angle) * angle).epsilon(1e-12));
  // Both at the limit: all heat is friction's.
  const auto far = step(law, {0, 0, 10.0});
  CHECK(far.couple.z() == Approx(-limit).epsilon(1e-13));
  CHECK(far.friction_work == Approx(limit * (10.0 - limit / k)).epsilon(1e-12));
  CHECK(far.dashpot_work == 0.0);
  CHECK(step(law, {0, 0, 10.0}, 0.0, far.state).couple == far.couple);
  // Without a dashpot it is TwistingSpring, bit for bit.
  const auto without = step(TwistingSpringDashpot<double>{{0.4, 0.0}}, {0, 0, 2e-4});
  CHECK(without.couple == step(TwistingSpring<double>{0.4}, {0, 0, 2e-4}).couple);

  const auto given = step(TwistingSpringDashpot<double, GivenTwisting<double>>{{7.0, 1e-4, 0.2}}, {1.0, 0, 1e-3});
  CHECK(given.couple.z() == Approx(-7.0 * 1e-3 - 0.2 * 1e-3).epsilon(1e-13));
  const auto given_far = step(TwistingSpringDashpot<double, GivenTwisting<double>>{{7.0, 1e-4, 0.2}}, {0, 0, 1.0});
  CHECK(given_far.couple.z() == Approx(-1e-4 * force).epsilon(1e-13));
}

TEST_CASE("Twisting dashpot: a ball that twists to and fro decays by exp(-c T/2 I)") {
  // I w'' + c w' + k w = 0 over one period T = 2 pi / sqrt(k/I - (c/2 I)^2).
  const double k = 7.0, c = 1e-5, inertia = 1e-9;
  const double damped = std::sqrt(k / inertia - std::pow(c / (2 * inertia), 2)),
               duration = 2 * 3.14159265358979 / damped;
  const Law<TwistingSpringDashpot<double, GivenTwisting<double>>> law{{}, {}, {}, {}, {{k, 1.0, c}}};
  decltype(law)::State state{};
  double spin = 1e-3;
  constexpr int steps = 20000;
  for (int i = 0; i < steps; ++i) {
    const double dt = duration / steps;
    const auto s = law.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, {0, 0, spin}}, state);
    state = s.state;
    spin += s.couple.z() / inertia * dt;
  }
  CHECK(spin / 1e-3 ==
        Approx(std::exp(-c / (2 * inertia) * duration)).epsilon(2e-3));  // first order: a step is 3e-4 of 1/w
}

TEST_CASE("Twisting spring and dashpot: the work is stored or becomes heat") {
  const Law<TwistingSpringDashpot<double>> law{{}, {}, {}, {}, {{0.4, 0.3}}};
  // Slips in part of each half period: the amplitude is thrice the angle at which the spring yields.
  const double a = std::sqrt(radius * overlap), yield = 0.4 * force / (1.5 * shear_stiffness * a / 2), period = 1e-3;
  const auto off = [&](int steps) {
    decltype(law)::State state{};
    double work = 0.0, heat = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double dt = period / steps, t = (i + 0.5) / steps;
      const double spin = 3 * yield * 6.28318530717958648 / period * std::cos(6.28318530717958648 * t);
      const auto s = law.step(pair, {{0, 0, 1}, overlap, {0, 0, 0}, dt, 0.0, {0, 0, spin}}, state);
      CHECK(s.friction_work >= 0.0);
      CHECK(s.dashpot_work >= 0.0);
      work -= s.couple.z() * spin * dt;
      heat += s.friction_work + s.dashpot_work;
      state = s.state;
    }
    const double stored = law.stored_energy(pair, overlap, state) - hertz_energy(pair, overlap);
    return std::pair(std::abs(work - stored - heat), heat);
  };
  const auto [coarse, heat] = off(1000);
  const double fine = off(2000).first;
  // The couple at the end of a step differs from its mean by half of what the step adds, 1/1000 of 2 pi 3 yields: 1 %.
  CHECK(coarse <= 1e-2 * heat);
  CHECK(fine <= 0.55 * coarse);  // first order
}

TEST_CASE("Rolling and twisting together are the sum of both") {
  const RollAndTwist<double, RollingSpring<double>> both{{0.2}, {0.4}};
  const V spin(1e-4, -2e-4, 3e-5);
  const auto sum = step(both, spin);
  const auto rolled = step(RollingSpring<double>{0.2}, spin);
  const auto twisted = step(TwistingSpring<double>{0.4}, spin);
  CHECK(sum.couple == V(rolled.couple + twisted.couple));
  CHECK(Law<RollAndTwist<double, RollingSpring<double>>>::state_size == 4);
}

TEMPLATE_TEST_CASE("Rolling and twisting: accuracy", "", double, float) {
  using T = TestType;
  Random random(5);
  double torque = 0.0, twisting = 0.0, damped = 0.0;
  for (int i = 0; i < cases(20000); ++i) {
    const T r = random.binary<T>(-10, 2), e = random.binary<T>(10, 20), g = random.binary<T>(10, 20);
    const PairProperties<T> any{r, e, g, T(1), r, r};
    const T x = random.binary<T>(-20, 4), y = random.binary<T>(-20, 4), z = random.binary<T>(-20, 4);
    const T kn = e * r * random.binary<T>(-8, -2), load = random.binary<T>(0, 10);
    const ContactKinematics<T> k{{T(0), T(0), T(1)}, T(1), {T(0), T(0), T(0)}, T(1), T(0), {x, y, z}};
    const auto any_200 = any.template cast<Binary200>();
    const auto k_200 = k.template cast<Binary200>();
    const RollingTorque<T> rolls{random.binary<T>(-6, 0)};
    typename RollingTorque<T>::State none{};
    RollingTorque<Binary200>::State none_200{};
    const Vec3<T> m = rolls.respond(none, {any, k, kn, load}).couple;
    const Vec3<Binary200> m_200 = RollingTorque<Binary200>{Binary200(rolls.rolling_friction)}
                                      .respond(none_200, {any_200, k_200, Binary200(kn), Binary200(load)})
                                      .couple;
    torque = std::max({torque, ulps(m.x(), m_200.x()), ulps(m.y(), m_200.y())});
    const TwistingSpring<T> twists{random.binary<T>(-6, 20)};
    typename TwistingSpring<T>::State state{};
    TwistingSpring<Binary200>::State state_200{};
    const T t = twists.respond(state, {any, k, kn, load}).couple.z();
    twisting = std::max(twisting, ulps(t, TwistingSpring<Binary200>{Binary200(twists.twisting_friction)}
                                              .respond(state_200, {any_200, k_200, Binary200(kn), Binary200(load)})
                                              .couple.z()));
    // From no history spring and dashpot have one sign.
    const TwistingSpringDashpot<T> damps{{random.binary<T>(0, 20), random.binary<T>(-6, 0)}};
    typename TwistingSpring<T>::State fresh{};
    TwistingSpring<Binary200>::State fresh_200{};
    const TwistingSpringDashpot<Binary200> damps_200{
        {Binary200(damps.twisting_friction), Binary200(damps.twisting_damping)}};
    const T d = damps.respond(fresh, {any, k, kn, load}).couple.z();
    damped = std::max(
        damped, ulps(d, damps_200.respond(fresh_200, {any_200, k_200, Binary200(kn), Binary200(load)}).couple.z()));
  }
  std::cout << "twisting with dashpot" << precision_name<T>() << ' ' << damped << " ULP\n";
  std::cout << "rolling torque" << precision_name<T>() << ' ' << torque << " ULP, twisting " << twisting << " ULP\n";
  CHECK(torque <= 4.0);  // what the headers promise
  CHECK(twisting <= 6.0);
  CHECK(damped <= 8.0);
}

}  // namespace contactlaws::test

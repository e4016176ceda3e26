#include "contactlaws/normal/jkr.hpp"

#include <functional>

#include "catch.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

/// The memo's grains, of 1 MPa instead of 29 GPa: R* = 3 mm; w = 0.05 J/m^2.
PairProperties<double> soft_pair() {
  PairProperties<double> pair = granite_pair<double>();
  pair.effective_young = 1e6;
  pair.effective_shear = 0.25e6;
  return pair;
}
const PairProperties<double> pair = soft_pair();
constexpr double w = 0.05;
const double pi_w_radius = 3.14159265358979 * w * 3e-3;
const double pull_off = 1.5 * pi_w_radius;
const double pull_off_gap = 0.75 * std::cbrt(std::pow(3.14159265358979 * w / 1e6, 2.0) * 3e-3);  // 3.155e-6 m
/// The area of the hysteresis loop over (w^5 R*^4 / E*^2)^(1/3): the two heats, 0.4 and 0.6 4^(4/3) pi w h^2.
const double loop_factor =
    (0.4 + 0.6 * std::pow(4.0, 4.0 / 3.0)) * 3.14159265358979 * std::pow(3.14159265358979 / 8, 2.0 / 3.0);
const double loop = loop_factor * std::cbrt(std::pow(w, 5.0) * std::pow(3e-3, 4.0) / 1e12);

using Bare = ContactLaw<Jkr<double>>;
Bare bare() {
  Bare law;
  law.normal.work_of_adhesion = w;
  return law;
}

ContactKinematics<double> moving(double overlap, double separating = 0.0, double slip = 0.0) {
  return {{0.0, 0.0, 1.0}, overlap, {slip, 0.0, separating}, 1e-6};
}
Bare::State held() {
  Bare::State state{};
  state.in_contact = 1.0;
  return state;
}
double force_at(double overlap) { return bare().step(pair, moving(overlap), held()).normal_force; }

/// The integral of f over [low, high] by Gauss's rule of three points in 1000 parts.
double integral(const std::function<double(double)>& f, double low, double high) {
  double sum = 0.0;
  const double part = (high - low) / 1000;
  for (int i = 0; i < 1000; ++i) {
    const double middle = low + (i + 0.5) * part, reach = part / 2 * std::sqrt(0.6);
    sum += part * (5 * f(middle - reach) + 8 * f(middle) + 5 * f(middle + reach)) / 18;
  }
  return sum;
}
/// The work of the force between two overlaps. In u, o = -gap + u^2, the force is smooth at pull-off.
double work(double from, double to) {
  const double start = std::sqrt(std::max(0.0, from + pull_off_gap)), end = std::sqrt(to + pull_off_gap);
  return integral([](double u) { return 2 * u * force_at(u * u - pull_off_gap); }, start, end);
}

}  // namespace

TEST_CASE("JKR: touches at zero overlap with -8/9 F_c, pulls F_c at most, lets go at -5/9 F_c") {
  const Bare law = bare();
  CHECK(law.normal.pull_off_force(pair) == Approx(pull_off).epsilon(1e-13));
  CHECK(law.normal.pull_off_radius(pair) == Approx(std::cbrt(pi_w_radius * 3e-3 / 8e6)).epsilon(1e-13));
  CHECK(law.interaction_range(pair) == Approx(pull_off_gap).epsilon(1e-13));
  CHECK(law.interaction_range(pair) >= 0.75 * std::cbrt(std::pow(pi<double>() * w / 1e6, 2.0) * 3e-3));
  // A new contact is open up to touch, and then holds beyond it.
  CHECK(law.step(pair, moving(0.0), {}).force.z() == 0.0);
  CHECK(law.step(pair, moving(-1e-9), {}).force.z() == 0.0);
  CHECK_FALSE(law.step(pair, moving(-1e-9), {}).active);
  const auto touching = law.step(pair, moving(1e-18), {});
  CHECK(touching.normal_force == Approx(-8.0 / 9.0 * pull_off).epsilon(1e-9));
  CHECK(touching.state.in_contact == 1.0);
  CHECK(force_at(0.0) == Approx(-8.0 / 9.0 * pull_off).epsilon(1e-13));
  CHECK(law.step(pair, moving(-1e-9), touching.state).active);
  CHECK(force_at(-pull_off_gap * (1 - 1e-12)) == Approx(-5.0 / 9.0 * pull_off).epsilon(1e-5));
  // With y = sqrt(a/h), o = h^2/R* (y^4 - 4 y) and F = pi w R* (y^6/6 - y^3), the least at y^3 = 3.
  const double least = -pull_off_gap / 3 * std::cbrt(3.0);
  CHECK(force_at(least) == Approx(-pull_off).epsilon(1e-13));
  CHECK(force_at(0.9 * least) > -pull_off);
  CHECK(force_at(1.1 * least) > -pull_off);
  // The contact that has let go is new.
  const auto open = law.step(pair, moving(-pull_off_gap * (1 + 1e-12)), touching.state);
  CHECK(open.state.in_contact == 0.0);
  CHECK_FALSE(open.active);
  CHECK(open.force.z() == 0.0);
}

TEMPLATE_TEST_CASE("JKR: accuracy, from pull-off to overlaps of a million ranges", "", double, float) {
  using T = TestType;
  Random random(20240611);
  constexpr double eps = std::numeric_limits<T>::epsilon();
  Worst force("JKR force" + precision_name<T>()), stiffness("JKR stiffness" + precision_name<T>()),
      energy("JKR energy" + precision_name<T>()), beyond("JKR force beyond touch" + precision_name<T>());
  double off_equation = 0.0;
  for (int i = 0; i < cases(4000); ++i) {
    const T radius = random.binary<T>(-20, 2);
    const T young = random.binary<T>(20, 38);
    const PairProperties<T> any{radius, young, T(1), T(1), T(1), T(1)};
    const Jkr<T> law{random.binary<T>(-12, 2)};
    const T range = law.range(any);
    const bool apart = random.chance(0.5);
    const double ratio = apart ? -(1 - random.log_uniform(1e-12, 1)) : random.log_uniform(1e-6, 1e6);
    const T overlap = static_cast<T>(ratio * static_cast<double>(range));
    typename Jkr<T>::State state{T(1)};
    typename Jkr<Binary200>::State state_200{1};
    const auto any_200 = any.template cast<Binary200>();
    const Jkr<Binary200> exactly{Binary200(law.work_of_adhesion)};
    const Binary200 o(overlap), &E = any_200.effective_young, &R = any_200.effective_radius;
    if (!law.touches(state, any, overlap) || !exactly.touches(state_200, any_200, o)) continue;
    const auto computed = law.respond(state, any, overlap);
    const auto exact = exactly.respond(state_200, any_200, o);

    // The published equations, in the contact radius.
    const Binary200& a = exact.contact_radius;
    const Binary200 stretch = sqrt(2 * pi<Binary200>() * exactly.work_of_adhesion * a / E), flat = a * a / R;
    const Binary200 push = 4 * E * a * a * a / (3 * R);
    const Binary200 pull = sqrt(8 * pi<Binary200>() * exactly.work_of_adhesion * E * a * a * a);
    const Binary200 slope = (2 * flat - stretch / 2) / a;  // do/da
    const auto off = [&](const Binary200& difference, const Binary200& size) {
      off_equation = std::max(off_equation, static_cast<double>(abs(difference) / size));
    };
    off(flat - stretch - o, flat);
    off(exact.force - (push - pull), push + pull);
    const Binary200 tangent = exactly.tangent(state_200, any_200, o);
    off(tangent * slope - (4 * E * a * a / R - Binary200(3) / 2 * pull / a), push / a);

    const Binary200 larger = maximum<Binary200>(push, pull);
    const double error = static_cast<double>(abs(Binary200(computed.force) - exact.force) / larger) / eps;
    if (apart) {
      const double of_range = static_cast<double>(abs(tangent) * Binary200(range) / larger);
      beyond.see(error / (6 + 4 * of_range), any.effective_radius, young, law.work_of_adhesion, overlap);
    } else {
      force.see(error, radius, young, law.work_of_adhesion, overlap);
      stiffness.see(static_cast<double>(abs(Binary200(law.tangent(state, any, overlap)) - tangent) / (2 * E * a)) / eps,
                    radius, young, law.work_of_adhesion, overlap);
      const Binary200 parts = E * a * (flat * flat * 8 / 15 + flat * stretch * 4 / 3 + stretch * stretch / 2);
      energy.see(static_cast<double>(
                     abs(Binary200(law.energy(state, any, overlap)) - exactly.energy(state_200, any_200, o)) / parts) /
                     eps,
                 radius, young, law.work_of_adhesion, overlap);
    }
  }
  CHECK(off_equation <= 1e-50);  // digits of the 60, near pull-off less those of the slope
  CHECK(force.error() <= 3.0);
  CHECK(stiffness.error() <= 3.0);
  CHECK(energy.error() <= 5.0);
  CHECK(beyond.error() <= 1.0);
}

TEST_CASE("JKR: without adhesion it is Hertz's law, bit for bit") {
  Random random(7);
  const Jkr<double> none{0.0};
  for (int i = 0; i < cases(1000); ++i) {
    const auto any = wide_pair<double>(random);
    const double overlap = random.binary<double>(-40, 4);
    Jkr<double>::State state{};
    const auto one = none.respond(state, any, overlap);
    const auto hertz = hertz_response<double>(any, overlap);
    CHECK(one.force == hertz.force);
    CHECK(one.stiffness == hertz.stiffness);
    CHECK(none.tangent(state, any, overlap) == hertz.stiffness);
    CHECK(one.secant == hertz.secant);
    CHECK(one.adhesion == 0.0);
    CHECK(none.energy(state, any, overlap) == Approx(hertz_energy<double>(any, overlap)).epsilon(1e-14));
    CHECK_FALSE(none.touches(state, any, -overlap));
  }
  CHECK(none.range(pair) == 0.0);
  // A weak one is close to it, without overflow of a ratio.
  const Jkr<double> weak{1e-200};
  Jkr<double>::State state{};
  CHECK(weak.respond(state, pair, 1e-4).force == Approx(hertz_response<double>(pair, 1e-4).force).epsilon(1e-14));
}

TEST_CASE("JKR: work of separation, hysteresis loop and stored energy by quadrature") {
  const Jkr<double> law{w};
  const auto energy = [&](double overlap) { return law.energy(held(), pair, overlap); };
  const double at_pull_off = -pull_off_gap * (1 - 1e-15);
  CHECK(loop_factor == Approx(7.09).epsilon(7e-4));  // as Thornton & Ning (1998) print it
  CHECK(-work(-pull_off_gap, 0.0) == Approx(loop).epsilon(1e-9));
  CHECK(energy(at_pull_off) - energy(0.0) == Approx(-work(-pull_off_gap, 0.0)).epsilon(1e-9));
  for (const double deep : {-0.9 * pull_off_gap, -1e-6, 1e-6, 1e-5, 1e-3})
    CHECK(energy(deep) - energy(0.0) == Approx(-work(deep, 0.0)).epsilon(1e-9));
  // Free surfaces have none: touching releases 3.81 pi w h^2, letting go 0.4.
  const double h = law.pull_off_radius(pair), unit = 3.14159265358979 * w * h * h;
  CHECK(energy(0.0) == Approx(-0.6 * std::pow(4.0, 4.0 / 3.0) * unit).epsilon(1e-13));
  CHECK(energy(at_pull_off) == Approx(0.4 * unit).epsilon(1e-6));
  CHECK(law.energy({}, pair, -1e-9) == 0.0);

  // Quasi-statically in and out: the ledger finds the area of the loop.
  const Bare whole = bare();
  EnergyLedger<double> ledger;
  Bare::State state{};
  const int steps = 40000;
  const double far = 1.5 * pull_off_gap, step_length = 2 * far / steps;
  for (int i = 0; i < 2 * steps; ++i) {
    const bool approaches = i < steps;
    const double overlap = approaches ? -far + (i + 1) * step_length : far - (i + 1 - steps) * step_length;
    const ContactKinematics<double> k{{0, 0, 1}, overlap, {0, 0, approaches ? -step_length : step_length}, 1.0};
    const auto step = whole.step(pair, k, state);
    ledger.enter(whole, pair, k, step);
    state = step.state;
  }
  CHECK(ledger.stored == 0.0);
  CHECK(ledger.dissipated() == Approx(loop).epsilon(3e-4));  // half a step of 2.4e-10 m at each jump
}

TEST_CASE("JKR: the tangent is the slope of the force, negative near pull-off; the time step takes 2 E* a") {
  const Bare law = bare();
  for (const double overlap : {-0.99 * pull_off_gap, -0.5 * pull_off_gap, -1e-9, 1e-9, 1e-6, 1e-4}) {
    const double step = 1e-5 * (overlap + pull_off_gap);
    Jkr<double>::State state{1.0};
    const auto response = law.normal.respond(state, pair, overlap);
    const double slope = (force_at(overlap + step) - force_at(overlap - step)) / (2 * step);
    const double tangent = law.normal.tangent(state, pair, overlap);
    CHECK(std::abs(tangent - slope) <= 1e-8 * response.max_tangent);
    CHECK(tangent < response.max_tangent);
    CHECK(response.stiffness == response.max_tangent);
    CHECK(law.stiffness(pair, overlap, held()).normal == 2e6 * response.contact_radius);
  }
  Jkr<double>::State state{1.0};
  CHECK(law.normal.tangent(state, pair, -0.99 * pull_off_gap) < 0.0);
  CHECK(law.stiffness(pair, -1e-9, {}).normal == 0.0);

  // What needs a positive stiffness has one there.
  ContactLaw<Jkr<double>, NoDashpots<double>, ShearForce<double, ConstantRatio<double>>, Dry<double>,
             RollingSpring<double>>
      whole{{w}, {}, {{0.5}, {0.4}}, {}, {0.2}};
  decltype(whole)::State near{};
  near.in_contact = 1.0;
  auto motion = moving(-0.99 * pull_off_gap, 0.0, 1.0);
  motion.relative_spin = {0.0, 1.0, 0.0};
  const auto step = whole.step(pair, motion, near);
  CHECK(step.force.x() < 0.0);
  CHECK(step.couple.y() < 0.0);
  CHECK(whole.stored_energy(pair, motion.overlap, step.state) > whole.stored_energy(pair, motion.overlap, near));
}

TEST_CASE("Adhesion: what friction multiplies, by name") {
  const auto strength = [](auto normal, double overlap) {
    ContactLaw<decltype(normal), NoDashpots<double>, ShearForce<double>> law{normal, {}, {{}, {0.4}}, {}, {}};
    const auto step = law.step(pair, moving(overlap, 0.0, 1e9), {});
    return std::make_pair(-step.force.x() / 0.4, step.normal_force);
  };
  using Rule = AdhesiveFriction;
  for (const double overlap : {1e-7, 1e-5, 1e-4}) {
    const auto [jkr, force] = strength(Jkr<double>{w}, overlap);
    CHECK(jkr == Approx(force + 2 * pull_off).epsilon(1e-12));
    CHECK(strength(Jkr<double, Rule::thornton_dmt>{w}, overlap).first == Approx(force + pull_off).epsilon(1e-12));
    CHECK(strength(Jkr<double, Rule::none>{w}, overlap).first == Approx(std::max(force, 0.0)).epsilon(1e-12));
    CHECK(strength(Jkr<double, Rule::none>{w}, overlap).second == force);
    const double hertz = hertz_response<double>(pair, overlap).force, pull = pull_off * 4 / 3;
    CHECK(strength(Dmt<double>{w}, overlap).first == Approx(hertz).margin(1e-14 * pull));
    CHECK(strength(Dmt<double, Rule::thornton_jkr>{w}, overlap).first == Approx(hertz + pull).epsilon(1e-12));
    CHECK(strength(Dmt<double, Rule::none>{w}, overlap).first == Approx(std::max(hertz - pull, 0.0)).epsilon(1e-11));
  }
}

TEST_CASE(
    "Adhesion: dashpots scale with Hertz's secant, finite where force or overlap vanish; clipped, they pull F_c at "
    "most") {
  ContactLaw<Jkr<double>, Dashpots<double>> law{{w}, {0.3}, {}, {}, {}};
  decltype(law)::State state{};
  state.in_contact = 1.0;
  const double h = law.normal.pull_off_radius(pair);
  // With y = sqrt(a/h): o = 0 at y^3 = 4; F = 0 at y^3 = 6, where o = h^2/R* (y^4 - 4 y).
  const double balance = h * h / 3e-3 * 2 * std::cbrt(6.0);
  const std::pair<double, double> places[] = {{0.0, 4.0}, {1e-30, 4.0}, {-1e-30, 4.0}, {balance, 6.0}};
  for (const auto& [overlap, cube] : places) {
    const auto still = law.step(pair, moving(overlap), state), closing = law.step(pair, moving(overlap, -0.01), state);
    const double secant = 4.0 / 3.0 * 1e6 * h * std::pow(cube, 2.0 / 3.0);
    CHECK(closing.normal_force - still.normal_force ==
          Approx(0.01 * 0.3 * std::sqrt(pair.effective_mass * secant)).epsilon(1e-11));
  }
  const ContactLaw<Jkr<double, AdhesiveFriction::none>, Dashpots<double, Tension::clipped>> clipped{
      {w}, {0.3}, {}, {}, {}};
  CHECK(clipped.step(pair, moving(1e-5, 1e3), {}).normal_force == Approx(-pull_off).epsilon(1e-13));
  const ContactLaw<Dmt<double, AdhesiveFriction::none>, Dashpots<double, Tension::clipped>> stiff{
      {w}, {0.3}, {}, {}, {}};
  CHECK(stiff.step(pair, moving(1e-5, 1e3), {}).normal_force == Approx(-pull_off * 4 / 3).epsilon(1e-13));
  CHECK(std::isfinite(stiff.step(pair, moving(1e-300, 1.0), {}).normal_force));
}

TEST_CASE("JKR: below the sticking speed an impact sticks, above it loses the work of separation") {
  // (Thornton & Ning 1998): v_s^2 = 14.18 / m* (w^5 R*^4 / E*^2)^(1/3).
  const Bare law = bare();
  const double mass = pair.effective_mass, sticking = std::sqrt(2 * loop / mass);
  const double dt = 2e-4 * std::sqrt(mass / (2e6 * law.normal.pull_off_radius(pair)));
  /// The speed of separation; 0 for an impact that turns back before pull-off.
  const auto rebound = [&](double speed) {
    double overlap = 0.0, closing = speed, force = 0.0;
    Bare::State state{};
    bool turned = false;
    for (;;) {
      closing -= force / mass * dt / 2;
      overlap += closing * dt;
      const auto step = law.step(pair, moving(overlap, -closing), state);
      state = step.state;
      force = step.normal_force;
      closing -= force / mass * dt / 2;
      turned = turned || closing < 0.0;
      if (!step.active) return -closing;
      if (turned && closing > 0.0) return 0.0;
    }
  };
  CHECK(rebound(0.99 * sticking) == 0.0);
  CHECK(rebound(1.01 * sticking) ==
        Approx(std::sqrt(1.01 * 1.01 - 1) * sticking).epsilon(1e-2));  // the force jumps within a step
  CHECK(rebound(3 * sticking) == Approx(std::sqrt(8.0) * sticking).epsilon(1e-4));
}

TEST_CASE("CohesivePowder: its slots take the properties, which are checked") {
  CohesivePowderProperties<double> properties;
  properties.work_of_adhesion = w;
  properties.friction = 0.4;
  properties.rolling_friction = 0.1;
  properties.damping_constant = 0.2;
  const auto law = cohesive_powder(properties);
  CHECK(law.normal.work_of_adhesion == w);
  CHECK(law.shear.friction == 0.4);
  CHECK(law.rolling.rolling_friction == 0.1);
  CHECK(law.damping.damping_constant == 0.2);
  CHECK(decltype(law)::state_size == 7);
  // At touch nothing presses but the adhesion: 10/9 F_c hold against sliding and rolling.
  auto motion = moving(1e-18, 0.0, 1e9);
  motion.relative_spin = {0.0, 1e9, 0.0};
  const auto step = law.step(pair, motion, {});
  CHECK(step.force.x() == Approx(-0.4 * 10.0 / 9.0 * pull_off).epsilon(1e-8));
  CHECK(step.couple.y() == Approx(-0.1 * 3e-3 * 10.0 / 9.0 * pull_off).epsilon(1e-8));
  properties.work_of_adhesion = -1.0;
  CHECK_THROWS_WITH(cohesive_powder(properties),
                    Catch::Matchers::Equals("Jkr: work_of_adhesion is -1 J/m^2, must lie in [0, inf)"));
}

}  // namespace contactlaws::test

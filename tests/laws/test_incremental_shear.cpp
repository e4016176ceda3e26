#include "contactlaws/tangential/incremental_shear.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

template <class Shear>
using Undamped = ContactLaw<Hertz<double>, NoDashpots<double>, Shear>;

/// The granite grains, normal +z, sheared along +x by a law with friction mu.
template <class Shear>
struct Sheared {
  Undamped<Shear> law{{}, {}, {{}, 0.0}, {}};
  PairProperties<double> pair = granite_pair<double>();
  typename Undamped<Shear>::State state{};

  explicit Sheared(double mu) { law.shear.friction = mu; }

  /// Shear force opposite to the motion [N].
  double move(double overlap, double distance) {
    const double dt = 1e-6;
    const auto step = law.step(pair, {{0, 0, 1}, overlap, {distance / dt, 0, 0}, dt}, state);
    state = step.state;
    return -step.force.x();
  }
};

}  // namespace

TEST_CASE("Shear: stiffness 8 G* a, and its ratio to the normal one") {
  const PairProperties<double> pair = granite_pair<double>();
  const HertzResponse<double> normal = hertz_response(pair, 1e-4);
  // k_s o^(1/2), k_s printed to 15 digits
  CHECK(Mindlin<double>{}.stiffness(pair, normal) == Approx(1.49320368203524e9 * 0.01).epsilon(1e-14));
  CHECK(ConstantRatio<double>{0.25}.stiffness(pair, normal) == 0.25 * normal.stiffness);
  CHECK(mindlin_ratio(pair) == Approx(2.0 * (1.0 - 0.15) / (2.0 - 0.15)).epsilon(1e-15));  // one material

  // Aluminium oxide on an aluminium wall, to 10 digits
  const ElasticMaterial<double> oxide{380e9, 0.23, 4000}, aluminium{70e9, 0.25, 2700};
  const PairProperties<double> wall = pair_properties(sphere(oxide, 2.5e-3), plane(aluminium));
  CHECK(Mindlin<double>{}.stiffness(wall, hertz_response(wall, 1e-4)) == Approx(5.408444289e9 * 0.01).epsilon(1e-9));
}

// One path, four laws that all go by the name of Hertz-Mindlin: o = 0.1 mm, 99.0 um of shear, back off to 0.05 mm, return.
// The numbers are those of the codes that use each law, to 9 or 10 digits.
TEMPLATE_TEST_CASE("Shear: four histories agree while the overlap does not change", "", ShearForce<double>,
                   ShearForceRescaled<double>, ShearDisplacement<double>, ShearDisplacementRescaled<double>) {
  CHECK(Sheared<TestType>(10.0).move(1e-4, 99.0e-6) == Approx(1478.27164521).epsilon(1e-11));
  CHECK(Sheared<TestType>(0.4).move(1e-4, 99.0e-6) == Approx(433.321852826).epsilon(1e-11));

  // The history of a sliding contact is limited by friction: going back unloads it at once.
  Sheared<TestType> reversed(0.4);
  reversed.move(1e-4, 99.0e-6);
  CHECK(reversed.move(1e-4, -1e-6) == Approx(433.321852826 - 1.49320368203524e7 * 1e-6).epsilon(1e-11));

  Sheared<TestType> slowly(0.4);
  double force = 0.0, slip = 0.0;
  for (int i = 1; i <= 9900; ++i) {
    force = slowly.move(1e-4, 1e-8);
    if (slip == 0.0 && force > 433.32185) slip = i * 1e-8;
  }
  CHECK(force == Approx(433.321852826).epsilon(1e-11));
  CHECK(slip == Approx(29.02e-6).margin(0.011e-6));  // printed digit and step
}

TEST_CASE("Shear: the four histories differ after unloading to half the overlap and back") {
  const auto path = [](auto sheared, double unloaded, double reloaded) {
    sheared.move(1e-4, 99.0e-6);
    CHECK(sheared.move(0.5e-4, 0.0) == Approx(unloaded).epsilon(1e-8));
    CHECK(sheared.move(1e-4, 0.0) == Approx(reloaded).epsilon(1e-8));
  };
  path(Sheared<ShearForce<double>>(10.0), 1478.27164, 1478.27164);
  path(Sheared<ShearForceRescaled<double>>(10.0), 1045.29590, 1045.29590);
  path(Sheared<ShearDisplacement<double>>(10.0), 1045.29590, 1478.27164);
  path(Sheared<ShearDisplacementRescaled<double>>(10.0), 739.135823, 1045.29590);
}

TEST_CASE("Shear, fault: with a displacement history the force changes with the radius though nothing shears") {
  // A known trait of the two displacement laws, and of no other: the force laws keep, or lower by the stiffness once.
  const double start = 1e-4, deeper = 2.25e-4;  // 1.5 times the radius of the contact
  const auto grown = [&](auto sheared) {
    const double before = sheared.move(start, 1e-5);
    return sheared.move(deeper, 0.0) / before;
  };
  const auto shrunk = [&](auto sheared) {
    const double before = sheared.move(deeper, 1e-5);
    return sheared.move(start, 0.0) / before;
  };
  CHECK(grown(Sheared<ShearForce<double>>(1e3)) == 1.0);
  CHECK(grown(Sheared<ShearForceRescaled<double>>(1e3)) == 1.0);
  CHECK(grown(Sheared<ShearDisplacement<double>>(1e3)) == Approx(1.5).epsilon(1e-14));
  CHECK(grown(Sheared<ShearDisplacementRescaled<double>>(1e3)) == Approx(1.5).epsilon(1e-14));
  CHECK(shrunk(Sheared<ShearForce<double>>(1e3)) == 1.0);
  CHECK(shrunk(Sheared<ShearForceRescaled<double>>(1e3)) ==
        Approx(1.0 / 1.5).epsilon(1e-14));  // the radius, not its square
  CHECK(shrunk(Sheared<ShearDisplacement<double>>(1e3)) == Approx(1.0 / 1.5).epsilon(1e-14));
  CHECK(shrunk(Sheared<ShearDisplacementRescaled<double>>(1e3)) == Approx(1.0 / 2.25).epsilon(1e-14));
}

TEST_CASE("Shear: friction limits spring and dashpot together, after the spring alone") {
  const PairProperties<double> pair = granite_pair<double>();
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.5);
  const double overlap = 1e-4, strength = 0.4 * 1083.30463206478;
  const auto slide = [&](double distance, double dt, const DryHill<double>::State& state) {
    return law.step(pair, {{0, 0, 1}, overlap, {distance / dt, 0, 0}, dt}, state);
  };
  // A micrometre sticks (15 N), but not at 100 m/s: the spring keeps its 15 N, the sum is cut.
  const auto fast = slide(1e-6, 1e-8, {});
  CHECK(fast.sliding);
  CHECK(fast.force.x() == Approx(-strength).epsilon(1e-14));
  CHECK(fast.state.shear[0] == Approx(-1.49320368203524e9 * 0.01 * 1e-6).epsilon(1e-14));
  // So far that the spring slips: both are cut, and the history keeps what friction bears.
  const auto far = slide(1e-4, 1e-3, {});
  CHECK(far.sliding);
  CHECK(far.state.shear[0] == Approx(-strength).epsilon(1e-14));
  // At rest nothing slips any more.
  const auto rest = slide(0.0, 1e-3, far.state);
  CHECK(rest.force.x() == Approx(-strength).epsilon(1e-14));
}

TEST_CASE("Shear, fault: Coulomb limit when damping makes the normal force negative") {
  const PairProperties<double> pair = granite_pair<double>();
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.5);
  const auto pressed = law.step(pair, {{0, 0, 1}, 1e-6, {1.0, 0, 0}, 1e-6}, {});
  REQUIRE(pressed.force.x() < 0.0);
  const auto pulled = law.step(pair, {{0, 0, 1}, 1e-6, {1.0, 0, 5.0}, 1e-6}, pressed.state);
  REQUIRE(pulled.normal_force < 0.0);
  CHECK(pulled.force.x() == 0.0);  // nothing presses, so nothing resists; it must not turn round
  CHECK(pulled.sliding);
  CHECK(pulled.state.shear[0] == 0.0);
}

TEST_CASE("Shear: friction counts the surface force, not the pull of a bridge") {
  const PairProperties<double> pair = granite_pair<double>();
  const Hill<double> law = test::hill<double>(0.4, 2e5, 0.0);
  Hill<double>::State wet{};
  Hill<double>::make_wet(wet, 0.0, 0.0);
  const auto step = law.step(pair, {{0, 0, 1}, 5.946e-6, {100.0, 0, 0}, 1e-6}, wet);
  CHECK(step.force.x() == Approx(-0.4 * step.normal_force).epsilon(1e-15));
}

using ForceOnSpring = ShearForce<double, ConstantRatio<double>>;
using DisplacementOnSpring = ShearDisplacement<double, ConstantRatio<double>>;

TEMPLATE_TEST_CASE("Shear: the friction limit from 1e-300 to 1e300 N, and from mu 0 to 1e9", "", ForceOnSpring,
                   DisplacementOnSpring) {
  const PairProperties<double> pair = granite_pair<double>();
  const Vec3<double> along = Vec3<double>(0.6, 0.8, 0.0);
  for (const double force : {1e-300, 1e-200, 1e-160, 1e-100, 1.0, 1e100, 1e154, 1e200, 1e300}) {
    const double overlap = 1e-4;
    const auto law = [&](double mu) {
      return ContactLaw<LinearSpring<double>, NoDashpots<double>, TestType>{{force / overlap}, {}, {{1.0}, mu}, {}};
    };
    // A slip of ten overlaps: 10 F unlimited.
    const ContactKinematics<double> slip{{0, 0, 1}, overlap, 10 * overlap * along, 1.0};
    const auto limited = law(0.5).step(pair, slip, {});
    CHECK(limited.sliding);
    // 1e-300 has no more than 54 denormal bits below it; 4 roundings
    CHECK((limited.force - limited.normal_force * slip.normal + 0.5 * force * along).norm() <= 1e-15 * force);
    const auto smooth = law(0.0).step(pair, slip, {});
    CHECK(smooth.sliding);
    CHECK(smooth.force.x() == 0.0);
    CHECK(smooth.force.y() == 0.0);
    const auto rough = law(1e9).step(pair, slip, {});
    CHECK_FALSE(rough.sliding);
    CHECK((rough.force - rough.normal_force * slip.normal + 10 * force * along).norm() <= 1e-14 * force);
    CHECK_FALSE(law(0.5).step(pair, {{0, 0, 1}, overlap, 0.4 * overlap * along, 1.0}, {}).sliding);
  }
}

TEMPLATE_TEST_CASE("Shear: accuracy of the friction limit", "", double, float) {
  using T = TestType;
  Random random;
  Worst factor("friction limit" + precision_name<T>());
  // Down to the normal numbers: a denormal magnitude has too few digits to divide by.
  const int least = std::numeric_limits<T>::min_exponent, most = std::numeric_limits<T>::max_exponent - 2;
  for (int i = 0; i < cases(100000); ++i) {
    const int scale = least + static_cast<int>(random.engine() % static_cast<unsigned>(most - least));
    const auto component = [&] {
      const T x = random.binary<T>(std::max(scale - 30, smallest_exponent<T>), scale);
      return random.chance(0.5) ? x : T(-x);
    };
    const Vec3<T> force(component(), component(), random.binary<T>(scale, scale));
    const T strength = random.binary<T>(std::max(scale - 10, least), scale);
    const auto computed = detail::length_limit<T>(force, strength, strength);
    const Vec3<Binary200> precisely(Binary200(force.x()), Binary200(force.y()), Binary200(force.z()));
    const auto exact = detail::length_limit<Binary200>(precisely, Binary200(strength), Binary200(strength));
    factor.see(ulps(computed.factor, exact.factor), force.x(), force.y(), force.z(), strength);
    if (detail::surely_within<T>(force, strength)) CHECK_FALSE(computed.exceeded);
  }
  CHECK(factor.error() <= 4.0);  // a norm (3 squares, a root, a scaling) and a quotient
}

TEST_CASE("Shear: a contact that opens is reset, whatever its history") {
  const auto is_reset = [](auto sheared) {
    sheared.move(1e-4, 1e-5);
    sheared.move(-1e-9, 1e-5);
    CHECK(sheared.move(1e-4, 0.0) == 0.0);
  };
  is_reset(Sheared<ShearForce<double>>(0.4));
  is_reset(Sheared<ShearForceRescaled<double>>(0.4));
  is_reset(Sheared<ShearDisplacement<double>>(0.4));
  is_reset(Sheared<ShearDisplacementRescaled<double>>(0.4));
}

namespace {

/// A mass held on a contact by a constant load of half the friction limit: how far it creeps per million steps, as a share of
/// the elastic slip T/k_s.
template <class T>
double creep() {
  const ElasticMaterial<T> rock{T(29e9), T(0.15), T(2650)};
  const PairProperties<T> on_plane = pair_properties(plane(rock), sphere(rock, T(5e-3)));
  const DryHill<T> law = test::dry_hill<T>(0.4, 0.3);
  const T overlap = T(1e-6);
  const HertzResponse<T> normal = hertz_response<T>(on_plane, overlap);
  const double stiffness = double(Mindlin<T>{}.stiffness(on_plane, normal)), mass = double(on_plane.effective_mass);
  const double load = 0.5 * 0.4 * double(normal.force), dt = 0.05 * std::sqrt(mass / stiffness);
  const double viscosity = 0.2 * std::sqrt(mass * stiffness);
  typename DryHill<T>::State state{};
  double speed = 0.0, slip = 0.0, before = 0.0;
  for (int i = 1; i <= 2000000; ++i) {
    const auto step = law.step(on_plane, {{T(0), T(0), T(1)}, overlap, {T(speed), T(0), T(0)}, T(dt)}, state);
    state = step.state;
    speed += dt * (load * std::min(1.0, i / 200000.0) + double(step.force.x()) - viscosity * speed) / mass;
    slip += speed * dt;
    if (i == 1000000) before = slip;
  }
  return (slip - before) * stiffness / load;
}

}  // namespace

TEST_CASE("Shear: under a constant load a contact holds in double, and creeps in float as the header says") {
  if (sanitized) return;                     // takes them minutes
  CHECK(std::abs(creep<double>()) <= 1e-9);  // increments down to 1e-16 of the history count
  const double in_float = creep<float>();
  CHECK(in_float > 0.0);
  CHECK(in_float <= 0.04);
}

TEST_CASE(
    "Shear: static friction holds up to mu_s, kinetic friction slides at mu, and a contact sticks again below that") {
  using Static = ShearForce<double, Mindlin<double>, rotation::ProjectRestore<double>, StaticKinetic<double>>;
  Sheared<Static> contact(0.3);
  contact.law.shear.static_friction = 0.5;
  const double force = 1083.30463206478, stiffness = 1.49320368203524e7;  // the memo's, at 0.1 mm
  const double stuck = 0.45 * force / stiffness;
  CHECK(contact.move(1e-4, stuck) == Approx(0.45 * force).epsilon(1e-13));                   // above mu, below mu_s
  CHECK(contact.move(1e-4, 0.1 * force / stiffness) == Approx(0.3 * force).epsilon(1e-13));  // beyond mu_s: falls to mu
  CHECK(contact.move(1e-4, 0.01 * force / stiffness) == Approx(0.3 * force).epsilon(1e-13));   // slides on
  CHECK(contact.move(1e-4, -0.1 * force / stiffness) == Approx(0.2 * force).epsilon(1e-13));   // back: sticks
  CHECK(contact.move(1e-4, 0.25 * force / stiffness) == Approx(0.45 * force).epsilon(1e-13));  // and holds up to mu_s
}

}  // namespace contactlaws::test

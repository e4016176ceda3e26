#include "contactlaws/bridge/capillary_bridge.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"
#include "reference/capillary_bridge.hpp"

namespace contactlaws::test {
namespace {

using Exact = CapillaryBridge<double>;
using AtTouch = CapillaryBridge<double, YoungLaplace, Wets::at_touch>;
using Willett = CapillaryBridge<double, WillettClosed>;
using Toroid = CapillaryBridge<double, Rabinovich>;
constexpr double two_pi = 6.28318530717958648;

/// Two spheres of these radii [m]; the bridge reads nothing else.
PairProperties<double> spheres(double radius1, double radius2) {
  return sphere_sphere_pair<double>({1.0, 1.0}, radius1, radius2, 1.0);
}
const PairProperties<double> unit_spheres = spheres(1.0, 1.0);

/// The pull of a bridge across a gap, 0 where it ruptures.
template <class Bridge>
double pull(const Bridge& bridge, double gap, const PairProperties<double>& pair = unit_spheres) {
  typename Bridge::State state{bridge.bridge_volume};
  return bridge.respond(state, pair, -gap).force;
}
template <class Bridge>
double energy(const Bridge& bridge, double gap) {
  return bridge.energy(typename Bridge::State{bridge.bridge_volume}, unit_spheres, -gap);
}

/// The largest pull over all gaps of the reference, of each contact angle and volume.
double largest_pull(const reference::Bridge& of) {
  double most = 0.0;
  for (const reference::Bridge& b : reference::bridges)
    if (b.angle == of.angle && b.volume == of.volume) most = std::max(most, b.force);
  return most;
}

/// The reference has gaps of 0.999 of the rupture gap, and that itself.
enum class Gaps { below_rupture, at_rupture };

struct Errors {
  double low = 0.0, high = 0.0;  ///< of the force, in the largest force of the bridge

  void see(double error) {
    low = std::min(low, error);
    high = std::max(high, error);
  }
};
/// Of a rule's force, up to a contact angle [rad].
template <class Rule>
Errors errors_of(double widest, Gaps gaps = Gaps::below_rupture) {
  Errors errors;
  for (const reference::Bridge& b : reference::bridges) {
    if (b.angle > widest || (b.gap > 0.9995 * b.rupture_gap) != (gaps == Gaps::at_rupture)) continue;
    Rule rule;
    rule.prepare(b.angle);
    const double found = two_pi * rule.force(std::pow(b.volume, 1.0 / 6.0), b.gap, std::sqrt(4.0 / two_pi * b.volume));
    errors.see((found - b.force) / largest_pull(b));
  }
  return errors;
}

}  // namespace

TEST_CASE("Capillary bridge: the exact force within 0.06 % of the largest, over the domain, and 0.1 % at rupture") {
  const Errors errors = errors_of<YoungLaplace<double>>(2.0);
  CHECK(errors.low >= -6e-4);
  CHECK(errors.high <= 6e-4);
  CHECK(errors.high - errors.low >= 1e-4);  // the reference is not the code under test
  // There an error of the rupture gap of 5e-6 counts by its root.
  const Errors last = errors_of<YoungLaplace<double>>(2.0, Gaps::at_rupture);
  CHECK(last.low >= -1e-3);
  CHECK(last.high <= 1e-3);
}

TEST_CASE("Capillary bridge: the exact rupture gap, beyond which the equation has no solution") {
  double worst = 0.0, of_lian = 0.0;
  for (const reference::Bridge& b : reference::bridges) {
    const Exact bridge = Exact::of(1.0, b.angle, b.volume);
    worst = std::max(worst, std::abs(bridge.range(unit_spheres) / b.rupture_gap - 1.0));
    const double lian = Willett::of(1.0, b.angle, b.volume).range(unit_spheres);
    CHECK(lian == Approx((1.0 + b.angle / 2.0) * std::cbrt(b.volume)).epsilon(1e-13));
    of_lian = std::max(of_lian, std::abs(lian / b.rupture_gap - 1.0));
  }
  CHECK(worst <= 5e-6);
  CHECK(of_lian <= 0.14);
  CHECK(of_lian >= 0.12);
}

TEST_CASE("Capillary bridge: the energy is the surface energy that pulling it to rupture takes") {
  double worst = 0.0;
  for (const reference::Bridge& b : reference::bridges) {
    const double at_touch = energy(Exact::of(1.0, b.angle, b.volume), 0.0);
    worst = std::max(worst, std::abs((energy(Exact::of(1.0, b.angle, b.volume), b.gap) - b.energy) / at_touch));
  }
  CHECK(worst <= 2e-3);
  CHECK(worst > 1e-7);
}

TEMPLATE_TEST_CASE("Capillary bridge: the energy is the integral of the force", "", Exact, Willett, Toroid) {
  for (const double angle : {0.0, 0.3, 1.0})
    for (const double volume : {1e-7, 1e-5, 1e-3, 0.1, 0.5}) {
      const TestType bridge = TestType::of(0.07, angle, volume);
      const double rupture = bridge.range(unit_spheres);
      // By w of gap = rupture (1 - w^2), in which the force is smooth: Gauss, five points on each of 400 pieces.
      const double points[] = {-0.906179845938664, -0.538469310105683, 0.0, 0.538469310105683, 0.906179845938664};
      const double weights[] = {0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                0.236926885056189};
      const int pieces = 400;
      double work = 0.0;
      for (int i = 0; i < pieces; ++i)
        for (int k = 0; k < 5; ++k) {
          const double w = (i + 0.5 + points[k] / 2.0) / pieces;
          work += weights[k] / 2.0 / pieces * pull(bridge, rupture * (1.0 - w * w)) * 2.0 * w * rupture;
        }
      INFO(angle << " rad, " << volume);
      CHECK(-energy(bridge, 0.0) == Approx(work).epsilon(1e-10));
      CHECK(energy(bridge, -0.01) == Approx(energy(bridge, 0.0) - 0.01 * pull(bridge, 0.0)).epsilon(1e-13));
      CHECK(energy(bridge, rupture) == 0.0);
      // And between two gaps.
      const double h = 0.3 * rupture, d = 1e-4 * rupture;
      CHECK((energy(bridge, h + d) - energy(bridge, h - d)) / (2.0 * d) == Approx(pull(bridge, h)).epsilon(1e-6));
    }
}

TEST_CASE("Capillary bridge: the closed forms as their papers print them") {
  for (const double volume : {1e-6, 1e-3, 0.05})
    for (const double gap : {0.001, 0.01, 0.05}) {
      const double angle = 0.4;
      if (gap >= (1.0 + angle / 2.0) * std::cbrt(volume)) continue;
      // Rabinovich et al. (2005), Eqs 19 and 20.
      const double d = gap / 2.0 * (-1.0 + std::sqrt(1.0 + 2.0 * volume / (two_pi / 2.0 * gap * gap)));
      CHECK(pull(Toroid::of(0.07, angle, volume), gap) ==
            Approx(two_pi * 0.07 * std::cos(angle) / (1.0 + gap / (2.0 * d))).epsilon(1e-12));
      // Willett et al. (2000), Eq. 12, with half the gap for S.
      const double s = gap / 2.0 / std::sqrt(volume);
      CHECK(pull(Willett::of(0.07, angle, volume), gap) ==
            Approx(two_pi * 0.07 * std::cos(angle) / (1.0 + 2.1 * s + 10.0 * s * s)).epsilon(1e-12));
    }
}

TEST_CASE("Capillary bridge: the errors of the closed forms that their header states") {
  const double twenty = 0.35, all = 2.0;
  const auto within = [](const Errors& errors, double low, double high) {
    CHECK(errors.low >= low);
    CHECK(errors.low <= low + 0.02);
    CHECK(errors.high <= high);
    CHECK(errors.high >= high - 0.02);
  };
  within(errors_of<WillettClosed<double>>(all), -0.34, 0.94);
  within(errors_of<WillettClosed<double>>(twenty), -0.09, 0.31);
  within(errors_of<Rabinovich<double>>(all), -0.35, 0.94);
  within(errors_of<Rabinovich<double>>(twenty), -0.10, 0.31);
}

TEST_CASE("Capillary bridge: a small bridge pulls with 2 pi R gamma cos(theta), and all of them alike while touching") {
  const Exact bridge = Exact::of(0.07, 0.5, 1e-5);
  CHECK(pull(bridge, 0.0) == Approx(two_pi * 0.07 * std::cos(0.5)).epsilon(0.04));  // V^(1/4) = 0.056 is not small yet
  CHECK(pull(bridge, -0.01) == pull(bridge, 0.0));
  CHECK(pull(bridge, 1e-150) == Approx(pull(bridge, 0.0)).epsilon(1e-14));
  CHECK(pull(Toroid::of(0.07, 0.5, 1e-5), 0.0) == Approx(two_pi * 0.07 * std::cos(0.5)).epsilon(1e-15));
}

TEST_CASE("Capillary bridge: unlike spheres and a plane by Derjaguin's radius") {
  const Exact bridge = Exact::of(0.07, 0.3, 1e-12);
  const double gap = 2e-5, radius = 2.0 / (1.0 / 1e-3 + 1.0 / 3e-3);
  CHECK(pull(bridge, gap, spheres(1e-3, 3e-3)) == Approx(pull(bridge, gap, spheres(radius, radius))).epsilon(1e-13));
  const PairProperties<double> on_plane = plane_sphere_pair<double>({1.0, 1.0}, 1e-3, 1.0);
  CHECK(pull(bridge, gap, on_plane) == Approx(pull(bridge, gap, spheres(2e-3, 2e-3))).epsilon(1e-13));
  // A force scales with gamma R, a bridge with R.
  const Exact large = Exact::of(0.14, 0.3, 1.0);
  CHECK(pull(large, gap * 1e4, spheres(10.0, 10.0)) ==
        Approx(pull(bridge, gap, spheres(1e-3, 1e-3)) * 2e4).epsilon(1e-12));
}

TEST_CASE("Capillary bridge: the host pours, the bridge ruptures once, and its volume comes back") {
  const Exact bridge = Exact::of(0.07, 0.3, 1e-3);
  Exact::State state;
  CHECK_FALSE(Exact::is_wet(state));
  CHECK(bridge.respond(state, unit_spheres, 0.01).force == 0.0);

  state.bridge_volume = 4e-4;  // less than a full bridge
  const double rupture = bridge.rupture_gap(unit_spheres, 4e-4);
  CHECK(rupture < bridge.range(unit_spheres));
  const auto before = bridge.respond(state, unit_spheres, -rupture * (1.0 - 1e-14));
  CHECK(before.intact);
  CHECK(before.force > 0.0);
  CHECK(state.bridge_volume == 4e-4);
  CHECK(state.returned_volume == 0.0);
  const auto at = bridge.respond(state, unit_spheres, -rupture);
  CHECK_FALSE(at.intact);
  CHECK(at.force == 0.0);
  for (const double gap : {rupture, rupture / 2, 0.0, -1e-3}) {  // back in touch: dry
    CHECK(bridge.respond(state, unit_spheres, -gap).force == 0.0);
    CHECK(state.bridge_volume == 0.0);
    CHECK(state.returned_volume == 4e-4);
  }
  state.bridge_volume = 5e-4;  // a second one, before the host has taken the first
  bridge.respond(state, unit_spheres, -1.0);
  CHECK(state.returned_volume == Approx(9e-4).epsilon(1e-15));

  state = {1.0, 0.0};  // more than a bridge holds
  bridge.respond(state, unit_spheres, 0.0);
  CHECK(state.bridge_volume == 1e-3);
  Exact::make_wet(state = {}, -0.02, 0.01);
  CHECK(state.bridge_volume == 0.0);  // too far
  Exact::make_wet(state, -0.02, 0.02);
  CHECK(bridge.respond(state, unit_spheres, -0.02).force == pull(bridge, 0.02));
  CHECK(state.bridge_volume == 1e-3);
  Exact::make_dry(state);
  CHECK_FALSE(Exact::is_wet(state));
  CHECK(Exact::of(0.07, 0.3, 0.0).range(unit_spheres) == 0.0);
}

TEST_CASE("Capillary bridge: one that forms at touch takes its liquid, and gives it back each time it ruptures") {
  const AtTouch bridge = AtTouch::of(0.07, 0.3, 1e-3);
  AtTouch::State state;
  const auto at = [&](double gap) { return bridge.respond(state, unit_spheres, -gap).force; };
  const double rupture = bridge.range(unit_spheres);
  for (int touch = 0; touch < 3; ++touch) {
    CHECK(at(rupture / 2) == 0.0);
    CHECK(at(0.0) > 0.0);
    CHECK(state.bridge_volume == 1e-3);
    CHECK(state.returned_volume == -1e-3);
    CHECK(at(rupture / 2) > 0.0);
    CHECK(state.bridge_volume + state.returned_volume == 0.0);
    CHECK(at(rupture) == 0.0);
    CHECK(state.bridge_volume == 0.0);
    CHECK(state.returned_volume == 0.0);
  }
}

TEST_CASE("Capillary bridge: along random paths no liquid is lost or made") {
  const AtTouch bridge = AtTouch::of(0.07, 0.3, 0x1p-10);
  AtTouch::State state;
  Random random;
  double poured = 0.0;
  int ruptures = 0;
  for (int i = 0; i < 2000; ++i) {
    if (state.bridge_volume == 0.0 && random.chance(0.1)) {
      state.bridge_volume = 0x1p-12;
      poured += 0x1p-12;
    }
    const double before = state.bridge_volume;
    bridge.respond(state, unit_spheres, -random.uniform(-0.02, 0.2));
    ruptures += before > 0.0 && state.bridge_volume == 0.0;
    REQUIRE(state.bridge_volume + state.returned_volume == poured);
  }
  CHECK(ruptures > 100);
}

TEST_CASE("Capillary bridge: an angle that is changed counts, prepared or not") {
  Exact changed = Exact::of(0.07, 0.3, 1e-3);
  changed.contact_angle = 0.8;
  CHECK(pull(changed, 0.05) == pull(Exact::of(0.07, 0.8, 1e-3), 0.05));
  Exact by_hand;
  by_hand.surface_tension = 0.07;
  by_hand.bridge_volume = 1e-3;
  CHECK(pull(by_hand, 0.05) == pull(Exact::of(0.07, 0.0, 1e-3), 0.05));
}

TEST_CASE("Capillary bridge: beyond the domain the force stays positive and falls, and the rupture gap grows") {
  for (const double angle : {0.0, 0.5, 1.0}) {
    double last = 0.0;
    for (double volume = 1e-12; volume < 1.0; volume *= 2.0) {
      const Exact bridge = Exact::of(1.0, angle, volume);
      const double rupture = bridge.range(unit_spheres);
      CHECK(rupture > last);
      last = rupture;
      if (volume < 1e-5)
        for (int i = 0; i < 50; ++i)
          CHECK(pull(bridge, rupture * i / 50) > pull(bridge, std::min(rupture * (i + 1) / 50, rupture * 0.9999)));
      CHECK(pull(bridge, rupture * 0.9999) > 0.0);
    }
  }
}

TEMPLATE_TEST_CASE("Capillary bridge: rounding", "", double, float) {
  using T = TestType;
  Random random;
  Worst force("capillary force, in that at touch" + precision_name<T>());
  for (int i = 0; i < cases(3000); ++i) {
    const T angle = static_cast<T>(random.uniform(0.0, 1.047)), tension = random.binary<T>(-10, 10);
    const T radius = random.binary<T>(-15, 5);
    const T volume = static_cast<T>(random.log_uniform(1e-5, 0.1)) * radius * radius * radius;
    const CapillaryBridge<T> bridge = CapillaryBridge<T>::of(tension, angle, volume);
    const PairProperties<T> pair = sphere_sphere_pair<T>({T(1), T(1)}, radius, radius, T(1));
    const T gap = static_cast<T>(random.uniform(-0.1, 0.9)) * bridge.range(pair);
    typename CapillaryBridge<T>::State state{volume};
    const T computed = bridge.respond(state, pair, -gap).force;
    const auto exactly = slot_cast<Binary200>(bridge);
    CapillaryBridge<Binary200>::State exact_state{Binary200(volume)};
    const auto exact_pair = pair.template cast<Binary200>();
    const Binary200 exact = exactly.respond(exact_state, exact_pair, Binary200(-gap)).force;
    const Binary200 at_touch = exactly.respond(exact_state, exact_pair, Binary200(0)).force;
    const Binary200 error = abs(Binary200(computed) - exact) / at_touch / std::numeric_limits<T>::epsilon();
    force.see(static_cast<double>(error), angle, volume, gap);
  }
  CHECK(force.error() <= 10.0);  // what the header promises
}

TEST_CASE("Wet grains: a law by its properties, which form a bridge at touch") {
  WetGrainsProperties<double> properties;
  properties.friction = 0.4;
  properties.surface_tension = 0.072;
  properties.contact_angle = 0.3;
  properties.bridge_volume = 1e-9;
  const auto law = wet_grains(properties);
  const PairProperties<double> pair = granite_pair<double>();
  const double range = law.interaction_range(pair);
  const auto at = [&](double overlap, const WetGrains<double>::State& state) {
    return law.step(pair, {{0.0, 0.0, 1.0}, overlap, {0.0, 0.0, 0.0}, 1e-6}, state);
  };
  CHECK_FALSE(at(-range / 2, {}).active);
  const auto touching = at(0.0, {});
  // R = 2 R* = 6 mm; V/R^3 = 0.005, at which the exact force is a tenth below that of a small bridge.
  CHECK(touching.bridge_force == Approx(two_pi * 6e-3 * 0.072 * std::cos(0.3) * 0.9).epsilon(0.01));
  CHECK(touching.force.z() == -touching.bridge_force);  // towards body 1
  CHECK(touching.state.bridge_volume == 1e-9);
  const auto apart = at(-range / 2, touching.state);
  CHECK(apart.active);
  CHECK(apart.bridge_force > 0.0);
  const auto after = at(-range, apart.state);
  CHECK_FALSE(after.active);
  CHECK(after.state.returned_volume == 0.0);  // taken at touch, and given back
  properties.contact_angle = 1.2;
  CHECK_THROWS_WITH(wet_grains(properties),
                    Catch::Matchers::Equals("CapillaryBridge: contact_angle is 1.2 rad, must lie in [0, 1.0472]"));
}

}  // namespace contactlaws::test

#include "contactlaws/bridge/suction_bridge.hpp"
#include "make_laws.hpp"

#include "catch.hpp"
#include "contactlaws/laws.hpp"
#include "oracle.hpp"
#include "random.hpp"

namespace contactlaws::test {
namespace {

using Bridge = SuctionBridge<double>;
constexpr double min_radius = 5e-3;  // of the granite grains

Bridge::State wet() {
  Bridge::State state;
  Bridge::make_wet(state, 0.0, 0.0);
  return state;
}

double pull(const Bridge& bridge, double gap) {
  Bridge::State state = wet();
  return bridge.respond(state, granite_pair<double>(), -gap).force;
}

}  // namespace

TEST_CASE("Bridge: the memo's grains, 200 kPa on 5 mm, pull with 15.70796 N") {
  const Bridge bridge{2e5, 2.0, 2.0};
  CHECK(bridge.largest_force(granite_pair<double>()) == Approx(15.7079632679490).epsilon(1e-14));  // 5 pi
  CHECK(bridge.range(granite_pair<double>()) == 2.0 * min_radius);
}

TEST_CASE("Bridge: constant while touching, continuous at touch, decaying over a length of 2 R_o") {
  const Bridge bridge{2e5, 2.0, 2.0};
  const double most = bridge.largest_force(granite_pair<double>());
  CHECK(pull(bridge, -1e-4) == most);
  CHECK(pull(bridge, 0.0) == most);
  CHECK(pull(bridge, 1e-300) == most);
  CHECK(pull(bridge, 1e-12) == Approx(most).epsilon(1e-9));
  for (const double x : {0.1, 0.5, 1.0, 1.5, 1.999})  // gaps in R_o
    CHECK(pull(bridge, x * min_radius) == Approx(most * std::exp(-x / 2.0)).epsilon(1e-14));
}

TEST_CASE("Bridge: ruptures at its rupture gap, once, and forms again only when wetted") {
  const Bridge bridge{2e5, 2.0, 2.0};
  const PairProperties<double> pair = granite_pair<double>();
  const double rupture = bridge.range(pair);
  Bridge::State state = wet();
  const auto before = bridge.respond(state, pair, -std::nextafter(rupture, 0.0));
  CHECK(before.intact);
  CHECK(before.force == Approx(15.7079632679490 / 2.71828182845905).epsilon(1e-13));
  CHECK(state.moisture == 2.0);
  const auto at = bridge.respond(state, pair, -rupture);
  CHECK_FALSE(at.intact);
  CHECK(at.force == 0.0);
  CHECK(state.moisture == 1.0);
  for (const double gap : {rupture / 2, 0.0, -1e-5}) {  // back in touch: dry
    CHECK(bridge.respond(state, pair, -gap).force == 0.0);
    CHECK(state.moisture == 1.0);
  }
  Bridge::make_wet(state, 1e-5, 0.0);
  CHECK(bridge.respond(state, pair, 1e-5).force == bridge.largest_force(pair));
}

TEST_CASE("Bridge: decay and rupture are parameters in multiples of the smaller radius") {
  const Bridge bridge{2e5, 0.5, 3.0};
  CHECK(pull(bridge, 1.25 * min_radius) == Approx(5 * 3.14159265358979324 * std::exp(-2.5)).epsilon(1e-14));
  CHECK(pull(bridge, 2.999 * min_radius) > 0.0);
  CHECK(pull(bridge, 3.0 * min_radius) == 0.0);
}

TEST_CASE("Bridge: make_wet wets within the moisture gap, make_dry dries, and neither touches the forces") {
  Hill<double>::State state{};
  state.shear = {1.0, 2.0, 3.0};
  Hill<double>::make_wet(state, -2.5e-3, 2.4e-3);
  CHECK(state.moisture == 0.0);  // too far
  Hill<double>::make_wet(state, -2.5e-3, 2.5e-3);
  CHECK(state.moisture == 2.0);
  Hill<double>::make_wet(state, -1.0, 2.5e-3);
  CHECK(state.moisture == 2.0);  // wet stays wet
  Hill<double>::make_dry(state);
  CHECK(state.moisture == 0.0);
  CHECK(state.shear == std::array<double, 3>{1.0, 2.0, 3.0});
}

TEST_CASE("Bridge: energy is the work to rupture, in closed form and as the integral of the force") {
  const Bridge bridge{2e5, 0.7, 1.8};
  const PairProperties<double> pair = granite_pair<double>();
  const double rupture = bridge.range(pair), decay = 0.7 * min_radius;
  const double closed_form = bridge.largest_force(pair) * decay * (1.0 - std::exp(-rupture / decay));
  const int n = 10000;  // Simpson: (rupture/decay)^4 / (180 n^4) = 1e-17 of the integral; rounding is what is left
  double work = 0.0;
  for (int i = 0; i < n; ++i) {
    const double from = rupture * i / n, to = rupture * (i + 1) / n;
    const double last = i + 1 == n ? bridge.largest_force(pair) * std::exp(-rupture / decay) : pull(bridge, to);
    work += (pull(bridge, from) + 4.0 * pull(bridge, (from + to) / 2) + last) * (to - from) / 6.0;
  }
  CHECK(work == Approx(closed_form).epsilon(1e-12));
  CHECK(-bridge.energy(wet(), pair, 0.0) == Approx(closed_form).epsilon(1e-14));
  CHECK(-bridge.energy(wet(), pair, 1e-4) == Approx(closed_form + bridge.largest_force(pair) * 1e-4).epsilon(1e-14));
  CHECK(bridge.energy(wet(), pair, -rupture) == 0.0);
  CHECK(bridge.energy(Bridge::State{}, pair, 0.0) == 0.0);
}

TEST_CASE("Bridge: a contact is active until its bridge ruptures, at the interaction range") {
  const Hill<double> law = test::hill<double>(0.4, 2e5, 0.0);
  const PairProperties<double> pair = granite_pair<double>();
  Hill<double>::State state{};
  Hill<double>::make_wet(state, 0.0, 0.0);
  const double range = law.interaction_range(pair);
  CHECK(range == 0.01);
  const auto at = [&](double gap) { return law.step(pair, {{1, 0, 0}, -gap, {0, 0, 0}, 1e-6}, state); };
  CHECK(at(0.999 * range).active);
  CHECK(at(0.999 * range).force.x() < 0.0);  // on body 2, towards body 1
  CHECK_FALSE(at(range).active);
  CHECK(test::dry_hill<double>(0.4, 0.0).interaction_range(pair) == 0.0);
}

TEMPLATE_TEST_CASE("Bridge: accuracy", "", double, float) {
  using T = TestType;
  Random random;
  Worst force("bridge force" + precision_name<T>());
  for (int i = 0; i < cases(50000); ++i) {
    const PairProperties<T> pair = wide_pair<T>(random);
    const T rupture = random.binary<T>(-3, 3), decay = rupture * random.binary<T>(-3, 3);
    const SuctionBridge<T> bridge{random.binary<T>(-10, 30), decay, rupture};
    const T gap = static_cast<T>(random.uniform(-0.2, 1.0)) * rupture * pair.min_radius;
    typename SuctionBridge<T>::State state{T(2)};
    SuctionBridge<Binary200>::State exact_state{Binary200(2)};
    const T computed = bridge.respond(state, pair, -gap).force;
    const Binary200 exact =
        slot_cast<Binary200>(bridge).respond(exact_state, pair.template cast<Binary200>(), Binary200(-gap)).force;
    if (computed == T(0) || exact == 0) continue;  // at the very gap of rupture
    // exp(-x) multiplies the roundings of x by x.
    const T x = gap / (decay * pair.min_radius);
    if (x < T(1)) force.see(ulps(computed, exact), bridge.suction, pair.min_radius, decay, gap);
    CHECK(ulps(computed, exact) <= 5.0 + 2.0 * static_cast<double>(maximum<T>(x, T(0))));
  }
  CHECK(force.error() <= 5.0);  // what the header promises
}

}  // namespace contactlaws::test

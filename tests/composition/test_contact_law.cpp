// What ContactLaw itself promises to hosts: states as plain values, slots that cost nothing, questions without effects.
#include "contactlaws/contact_law.hpp"
#include "make_laws.hpp"

#include <set>
#include <string>

#include "catch.hpp"
#include "properties/law_list.hpp"
#include "random.hpp"

namespace contactlaws::test {

TEST_CASE("A state is plain values: as many as the law lists, trivially copied, virgin when value-initialised") {
  visit_laws([](const char* name, std::size_t history, const auto& law) {
    INFO(name);
    using Law = std::decay_t<decltype(law)>;
    using State = typename Law::State;
    CHECK(Law::state_size == history);
    static_assert(std::is_trivially_copyable_v<State>);
    static_assert(std::is_empty_v<State> == (Law::state_size == 0));
    static_assert(Law::state_size == 0 || sizeof(State) == Law::state_size * sizeof(double));
    static_assert(sizeof(typename Law::template Rebind<float>::State) ==
                  (Law::state_size == 0 ? 1 : Law::state_size * sizeof(float)));
    State virgin{};
    double values[Law::state_size + 1];
    Law::store(virgin, values);
    for (std::size_t i = 0; i < Law::state_size; ++i) CHECK(values[i] == 0.0);
  });
}

TEST_CASE("A state is stored as T[N] and comes back the same") {
  visit_laws([](const char* name, std::size_t, const auto& law) {
    INFO(name);
    using Law = std::decay_t<decltype(law)>;
    double values[Law::state_size + 1], again[Law::state_size + 1];
    for (std::size_t i = 0; i <= Law::state_size; ++i) values[i] = 1.5 * static_cast<double>(i) + 0.25;
    typename Law::State state = Law::load(values);
    again[Law::state_size] = -7.0;
    Law::store(state, again);
    CHECK(again[Law::state_size] == -7.0);  // not a value more
    for (std::size_t i = 0; i < Law::state_size; ++i) CHECK(again[i] == values[i]);
  });
}

TEST_CASE("Each value of a state has a name of its own, a unit and a sign under exchange of the bodies") {
  visit_laws([](const char* name, std::size_t, const auto& law) {
    INFO(name);
    using Law = std::decay_t<decltype(law)>;
    std::set<std::string> names;
    for (const StateValue& value : Law::state_values()) {
      CHECK(names.insert(value.name).second);
      CHECK(std::string(value.unit) != "");
      CHECK(std::abs(value.exchange_sign) == 1);
    }
  });
}

TEST_CASE("Fault: the sign under exchange of scalars") {
  // Hosts that negate the whole history when a pair changes owner break moisture, stiffness and plastic overlap.
  const auto sign_of = [](const auto& law, const std::string& name) {
    using Law = std::decay_t<decltype(law)>;
    for (std::size_t i = 0; i < Law::state_size; ++i)
      if (Law::state_values()[i].name == name) return Law::exchange_sign(i);
    return 0;
  };
  CHECK(sign_of(Hill<double>{}, "moisture") == +1);
  CHECK(sign_of(Hill<double>{}, "shear_x") == -1);
  CHECK(sign_of(Hill<double>{}, "shear_z") == -1);
  CHECK(sign_of(RoughBallast<double>{}, "largest_overlap") == +1);
  using Turning = ContactLaw<Hertz<double>, NoDashpots<double>,
                             ShearForceRescaled<double, Mindlin<double>, rotation::Rotate<double>>>;
  CHECK(sign_of(Turning{}, "last_stiffness") == +1);
  CHECK(sign_of(Turning{}, "last_normal_y") == -1);
}

TEST_CASE("A state with its bodies exchanged: vectors that point from body 1 to 2 turn round, scalars stay") {
  using Law =
      ContactLaw<PohrtPopovElastoPlastic<double>, NoDashpots<double>, ShearForceRescaled<double, ConstantRatio<double>>,
                 SuctionBridge<double>, RollingSpring<double>>;
  double values[Law::state_size] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  Law::exchange_bodies(values);
  const double expected[] = {1, -2, -3, -4, 5, 6, -7, -8, -9};  // o_m, F_s, k_before, moisture, M
  for (std::size_t i = 0; i < Law::state_size; ++i) CHECK(values[i] == expected[i]);
  SmoothHertz<double>::exchange_bodies(nullptr);
}

TEST_CASE("A slot left out costs nothing") {
  static_assert(std::is_empty_v<Hertz<double>> && std::is_empty_v<NoDashpots<double>> &&
                std::is_empty_v<Frictionless<double>> && std::is_empty_v<Dry<double>> &&
                std::is_empty_v<Mindlin<double>>);
  static_assert(std::is_empty_v<SmoothHertz<double>::State>);
  static_assert(sizeof(DryHill<double>::State) == 3 * sizeof(double));
  static_assert(sizeof(Hill<double>::State) == 4 * sizeof(double));
  static_assert(sizeof(Hill<float>::State) == 4 * sizeof(float));
  static_assert(sizeof(ShearForce<double>) == sizeof(double));    // friction alone
  static_assert(sizeof(Dashpots<double>) == 2 * sizeof(double));  // no room for a ratio that is not used
  static_assert(sizeof(DryHill<double, Tension::allowed, ShearDashpot::in_ratio>::State) == 3 * sizeof(double));
  static_assert(SmoothHertz<double>::state_values().empty());
  CHECK(Dry<double>::parameters().empty());
  CHECK(Frictionless<double>::parameters().empty());
  CHECK(NoDashpots<double>::parameters().empty());
}

TEST_CASE("A law goes to another scalar and back with all its parameters") {
  visit_laws([](const char* name, std::size_t, const auto& law) {
    INFO(name);
    using Law = std::decay_t<decltype(law)>;
    Law full = law;  // with no parameter at 0, where one that is left out would be too
    const auto fill = [](auto& slot) {
      for (const auto& p : std::decay_t<decltype(slot)>::parameters())
        if (slot.*p.member == 0.0) slot.*p.member = 0.3;
    };
    std::apply([&fill](auto&... slot) { (fill(slot), ...); }, full.slots());
    const Law back = full.template cast<long double>().template cast<double>();
    const auto same = [](const auto& a, const auto& b) {
      for (const auto& p : std::decay_t<decltype(a)>::parameters()) {
        INFO(p.name);
        CHECK(a.*p.member == b.*p.member);
      }
    };
    same(back.normal, full.normal);
    same(back.damping, full.damping);
    same(back.shear, full.shear);
    same(back.bridge, full.bridge);
    same(back.rolling, full.rolling);
  });
}

TEST_CASE("Pair and kinematics go to another scalar and back") {
  const PairProperties<double> pair{1, 2, 3, 4, 5, 6};
  const PairProperties<double> same = pair.cast<long double>().cast<double>();
  CHECK(same.effective_radius == 1);
  CHECK(same.effective_young == 2);
  CHECK(same.effective_shear == 3);
  CHECK(same.effective_mass == 4);
  CHECK(same.min_radius == 5);
  CHECK(same.length == 6);
  const ContactKinematics<double> k{{1, 2, 3}, 4, {5, 6, 7}, 8, 9};
  const ContactKinematics<double> again = k.cast<float>().cast<double>();
  CHECK(again.normal == k.normal);
  CHECK(again.overlap == 4);
  CHECK(again.velocity == k.velocity);
  CHECK(again.dt == 8);
  CHECK(again.normal_spin == 9);
}

TEST_CASE("Fault: a query advances the history") {
  // A host's set-up pass computes the forces once before the first step, and others do so between steps.
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.07);
  const PairProperties<double> pair = granite_pair<double>();
  const ContactKinematics<double> k{{0, 0, 1}, 1e-4, {1.0, 0, 0}, 1e-6};
  DryHill<double>::State once{}, asked{};
  for (int i = 0; i < 10; ++i) {
    once = law.step(pair, k, once).state;
    for (int question = 0; question < 3; ++question) law.step(pair, k, asked);
    asked = law.step(pair, k, asked).state;
  }
  CHECK(asked.shear == once.shear);
}

TEST_CASE("Fault: the interaction range of a law ends at touch") {
  const PairProperties<double> pair = granite_pair<double>();
  visit_laws([&pair](const char* name, std::size_t, const auto& law) {
    INFO(name);
    using Bridge = std::decay_t<decltype(law.bridge)>;
    double range = 0.0;
    if constexpr (std::is_same_v<Bridge, SuctionBridge<double>>) {
      range = 0.01;  // 2 R_o
    } else if constexpr (Bridge::acts) {
      range = law.bridge.range(pair);  // its rupture gap: test_capillary_bridge
      CHECK(range > 0.0);
    }
    if constexpr (std::decay_t<decltype(law)>::adheres) range = std::max(range, law.normal.range(pair));
    CHECK(law.interaction_range(pair) == range);
  });
}

TEST_CASE("Stored energy is that of the springs and the bridge") {
  const PairProperties<double> pair = granite_pair<double>();
  const Hill<double> law = test::hill<double>(10.0, 2e5, 0.0);
  const double overlap = 1e-4, slip = 1e-6, k_n = 1.08330463206478e9, k_s = 1.49320368203524e7;
  Hill<double>::State state{};
  Hill<double>::make_wet(state, overlap, 0.0);
  state = law.step(pair, {{0, 0, 1}, overlap, {slip, 0, 0}, 1.0}, state).state;
  const double normal = 0.4 * k_n * std::pow(overlap, 2.5), shear = k_s * slip * slip / 2;
  const double bridge = -15.7079632679490 * (overlap + 0.01 * (1 - std::exp(-1.0)));
  CHECK(law.stored_energy(pair, overlap, state) == Approx(normal + shear + bridge).epsilon(1e-13));
  Hill<double>::make_dry(state);
  CHECK(law.stored_energy(pair, overlap, state) == Approx(normal + shear).epsilon(1e-13));
  CHECK(law.stored_energy(pair, 0.0, {}) == 0.0);
  CHECK(law.stored_energy(pair, -1e-3, {}) == 0.0);
}

}  // namespace contactlaws::test

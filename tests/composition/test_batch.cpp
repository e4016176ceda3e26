// SPDX-License-Identifier: MIT
// A batch gives what the scalar kernel gives: to the bit for laws of + - * / sqrt where the compiler contracts nothing
// (this file is built with -ffp-contract=off, for the plain instruction set and for this machine's), and for laws with
// powers to the error of the pack's pow and exp. No lane, tail, alignment or neighbour changes a result.
#include "contactlaws/batch.hpp"

#include <cstring>
#include <numeric>
#include <vector>

#include "bench/contacts.hpp"
#include "catch.hpp"
#include "contactlaws/scalars/xsimd.hpp"

using namespace contactlaws;

namespace {

/// Contacts in a host's arrays, each array at an odd place in memory.
template <class Law>
struct Host {
  using T = typename Law::Scalar;
  using Column = std::vector<T>;

  explicit Host(const std::vector<bench::Contact>& contacts) : count(contacts.size()) {
    const auto put = [&](Column& column, const auto& value_of) {
      column.assign(1, T(0));
      for (const bench::Contact& c : contacts) column.push_back(static_cast<T>(value_of(c)));
    };
    put(radius, [](const auto& c) { return c.pair.effective_radius; });
    put(young, [](const auto& c) { return c.pair.effective_young; });
    put(shear, [](const auto& c) { return c.pair.effective_shear; });
    put(mass, [](const auto& c) { return c.pair.effective_mass; });
    put(min_radius, [](const auto& c) { return c.pair.min_radius; });
    put(length, [](const auto& c) { return c.pair.length; });
    put(overlap, [](const auto& c) { return c.there.overlap; });
    for (int axis = 0; axis < 3; ++axis) {
      put(normal[static_cast<std::size_t>(axis)], [axis](const auto& c) { return c.there.normal[axis]; });
      put(velocity[static_cast<std::size_t>(axis)], [axis](const auto& c) { return c.there.velocity[axis]; });
    }
    for (std::size_t i = 0; i < Law::state_size; ++i) {
      const bool is_moisture = std::strcmp(Law::state_values()[i].name, "moisture") == 0;
      put(state[i], [is_moisture](const auto& c) { return is_moisture && c.wet ? 2.0 : 0.0; });
    }
    for (Column& f : force) f.assign(count + 1, T(-1));
  }

  ContactBatch<Law> batch(T dt) {
    ContactBatch<Law> b;
    b.count = count;
    b.pair = {&radius[1], &young[1], &shear[1], &mass[1], &min_radius[1], &length[1]};
    b.overlap = &overlap[1];
    b.dt = dt;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      b.normal[axis] = &normal[axis][1];
      b.velocity[axis] = &velocity[axis][1];
      b.force[axis] = &force[axis][1];
    }
    for (std::size_t i = 0; i < Law::state_size; ++i) b.state[i] = b.next[i] = &state[i][1];
    return b;
  }

  /// The same contacts by the scalar kernel.
  void step_one_by_one(const Law& law, T dt) {
    for (std::size_t c = 1; c <= count; ++c) step_contact(law, dt, c);
  }
  void step_contact(const Law& law, T dt, std::size_t c) {
    const auto vector = [c](const std::array<Column, 3>& v) { return Vec3<T>(v[0][c], v[1][c], v[2][c]); };
    std::array<T, Law::state_size> values{};
    for (std::size_t i = 0; i < Law::state_size; ++i) values[i] = state[i][c];
    const auto step = law.step({radius[c], young[c], shear[c], mass[c], min_radius[c], length[c]},
                               {vector(normal), overlap[c], vector(velocity), dt}, Law::load(values.data()));
    Law::store(step.state, values.data());
    for (std::size_t i = 0; i < Law::state_size; ++i) state[i][c] = values[i];
    for (std::size_t axis = 0; axis < 3; ++axis) force[axis][c] = step.force[static_cast<int>(axis)];
  }

  std::size_t count;
  Column radius, young, shear, mass, min_radius, length, overlap;
  std::array<Column, 3> normal, velocity, force;
  std::array<Column, Law::state_size> state;
};

/// A bit of everything: contacts that stick, slide, are open, are bridged.
std::vector<bench::Contact> mixed(std::size_t count) { return bench::make_contacts(count, {0.3, 0.3, 0.5, 0.0}); }

/// Largest difference of two hosts' results, relative to the largest force component of each contact.
template <class Law>
double largest_difference(const Host<Law>& a, const Host<Law>& b) {
  double largest = 0.0;
  for (std::size_t c = 1; c <= a.count; ++c) {
    double scale = 0.0, difference = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scale = std::max(scale, std::abs(static_cast<double>(a.force[axis][c])));
      difference = std::max(difference, std::abs(static_cast<double>(a.force[axis][c] - b.force[axis][c])));
    }
    if (difference > 0.0) largest = std::max(largest, difference / scale);
  }
  return largest;
}

using H = Hertz<double>;
using D = Dashpots<double>;
using M = Mindlin<double>;
using Turning = ContactLaw<H, D, ShearForce<double, M, rotation::Rotate<double>>>;
using Projected = ContactLaw<H, D, ShearDisplacementRescaled<double, M, rotation::Project<double>>>;
using Rough = ContactLaw<PohrtPopov<double>, D, ShearForceRescaled<double, ConstantRatio<double>>>;

}  // namespace

TEMPLATE_TEST_CASE("Batch and scalar kernel give the same bits", "", SmoothHertz<double>, LinearFriction<double>,
                   LinearSpringDashpot<double>, DryHill<double>, (DryHill<double, Tension::clipped>), DryHill<float>,
                   bench::DryHillInRatio, bench::DryHillInRatio::Rebind<float>, Turning, Projected) {
  using T = typename TestType::Scalar;
  const TestType law = bench::granite<typename TestType::template Rebind<double>>().template cast<T>();
  const auto count = static_cast<std::size_t>(GENERATE(0, 1, 2, 7, 8, 9, 16, 31, 100));
  Host<TestType> batched(mixed(count)), single(mixed(count));
  for (int pass = 0; pass < 5; ++pass) {
    evaluate(law, batched.batch(T(1e-7)));
    single.step_one_by_one(law, T(1e-7));
  }
  CHECK(batched.force == single.force);
  CHECK(batched.state == single.state);
}

TEMPLATE_TEST_CASE("Laws with powers agree to the error of the pack's pow and exp", "", Hill<double>, Hill<float>,
                   RoughBallast<double>, Rough) {
  using T = typename TestType::Scalar;
  const TestType law = bench::granite<typename TestType::template Rebind<double>>().template cast<T>();
  Host<TestType> batched(mixed(1000)), single(mixed(1000));
  for (int pass = 0; pass < 5; ++pass) {
    evaluate(law, batched.batch(T(1e-7)));
    single.step_one_by_one(law, T(1e-7));
  }
  // xsimd's exp is good to 2 ULP, and a pack's power to 3 + 4 |(p - 1) log x| eps: here p = 1.5 and |log x| up to 9, and F
  // grows as the 1.5th power of it.
  CHECK(largest_difference(batched, single) <= 32 * static_cast<double>(std::numeric_limits<T>::epsilon()));
}

TEST_CASE("A contact's result depends neither on its place nor on its neighbours") {
  using Law =
      ContactLaw<PohrtPopovElastoPlastic<double>, D, ShearForce<double, ConstantRatio<double>>, SuctionBridge<double>>;
  const Law law = bench::granite<Law>();
  const std::vector<bench::Contact> contacts = mixed(37);
  Host<Law> all(contacts);
  evaluate(law, all.batch(1e-7));
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    Host<Law> alone({contacts[c]});
    evaluate(law, alone.batch(1e-7));
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(alone.force[axis][1] == all.force[axis][c + 1]);
    for (std::size_t i = 0; i < Law::state_size; ++i) CHECK(alone.state[i][1] == all.state[i][c + 1]);
  }
}

TEST_CASE("One number for all is the same as an array of it; nothing beyond the arrays is touched") {
  using Law = DryHill<double>;
  const Law law = bench::granite<Law>();
  Host<Law> array(mixed(13)), number(mixed(13));
  evaluate(law, array.batch(1e-7));
  ContactBatch<Law> b = number.batch(1e-7);
  b.pair.effective_young = number.young[1];
  b.pair.effective_shear = number.shear[1];
  evaluate(law, b);
  CHECK(array.force == number.force);
  CHECK(number.force[0][0] == -1.0);
}

TEMPLATE_TEST_CASE("A law's parameters may differ from contact to contact", "", DryHill<double>, DryHill<float>,
                   bench::DryHillInRatio) {
  using Law = TestType;
  using T = typename Law::Scalar;
  const Law law = bench::granite<typename Law::template Rebind<double>>().template cast<T>();
  Host<Law> together(mixed(29)), one_by_one(mixed(29));
  constexpr bool in_ratio = std::is_same_v<Law, bench::DryHillInRatio>;
  std::vector<T> frictions, dampings, ratios;
  for (std::size_t c = 0; c < together.count; ++c) {
    frictions.push_back(T(c % 5) / T(10));
    dampings.push_back(T(c % 3) / T(20));
    ratios.push_back(T(1) + T(c % 4) / T(10));
  }
  auto laws = law.template cast<Column<T>>();
  laws.shear.friction = frictions.data();
  if constexpr (in_ratio) laws.damping.dashpot_ratio = ratios.data();
  for (int pass = 0; pass < 3; ++pass) {
    laws.damping.damping_constant = pass == 0 ? Column<T>(dampings[1]) : Column<T>(dampings.data());
    evaluate(laws, together.batch(T(1e-7)));
    for (std::size_t c = 0; c < one_by_one.count; ++c) {
      Law own = law;
      own.shear.friction = frictions[c];
      if constexpr (in_ratio) own.damping.dashpot_ratio = ratios[c];
      own.damping.damping_constant = pass == 0 ? dampings[1] : dampings[c];
      one_by_one.step_contact(own, T(1e-7), c + 1);
    }
  }
  CHECK(together.force == one_by_one.force);
  CHECK(together.state == one_by_one.state);
}

TEST_CASE("The next state may go elsewhere, and the state before stays") {
  using Law = DryHill<double>;
  const Law law = bench::granite<Law>();
  Host<Law> in_place(mixed(11)), apart(mixed(11));
  evaluate(law, in_place.batch(1e-7));
  const auto before = apart.state;
  auto elsewhere = apart.state;
  ContactBatch<Law> b = apart.batch(1e-7);
  for (std::size_t i = 0; i < Law::state_size; ++i) b.next[i] = &elsewhere[i][1];
  evaluate(law, b);
  CHECK(apart.state == before);
  CHECK(elsewhere == in_place.state);
}

TEST_CASE("The spin about the normal reaches the kernel") {
  const Turning law = bench::granite<Turning>();
  Host<Turning> host(mixed(13));
  evaluate(law, host.batch(1e-7));  // so that there is a shear to turn
  const Host<Turning> before = host;
  const double spin = 1e6;  // a tenth of a radian in a step
  ContactBatch<Turning> b = host.batch(1e-7);
  b.normal_spin = spin;
  evaluate<Turning, double>(law, b);  // one lane wide: a pack's sine has other digits
  for (std::size_t c = 1; c <= host.count; ++c) {
    const auto vector = [c](const auto& v) { return Vec3<double>(v[0][c], v[1][c], v[2][c]); };
    std::array<double, Turning::state_size> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = before.state[i][c];
    const PairProperties<double> pair{before.radius[c], before.young[c],      before.shear[c],
                                      before.mass[c],   before.min_radius[c], before.length[c]};
    const auto step = law.step(pair, {vector(before.normal), before.overlap[c], vector(before.velocity), 1e-7, spin},
                               Turning::load(values.data()));
    CHECK(vector(host.force) == step.force);
  }
}

TEST_CASE("Without packs a batch is one lane wide") {
  using Law = DryHill<double>;
  const Law law = bench::granite<Law>();
  Host<Law> packs(mixed(21)), lanes(mixed(21));
  evaluate(law, packs.batch(1e-7));
  evaluate<Law, double>(law, lanes.batch(1e-7));
  CHECK(packs.force == lanes.force);
}

// The rule for NaN (contact_law.hpp): a NaN in what a contact reads gives a NaN force or couple, never a number; what it does
// not read has no effect, in batches too.
#include <limits>

#include "catch.hpp"
#include "contactlaws/batch.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "make_laws.hpp"
#include "properties/paths.hpp"

namespace contactlaws::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Calls visit(name, number) for each number of the kinematics that may be NaN by mistake.
template <class Visit>
void visit_inputs(ContactKinematics<double>& k, const Visit& visit) {
  visit("overlap", k.overlap);
  visit("dt", k.dt);
  visit("normal_spin", k.normal_spin);
  for (int i = 0; i < 3; ++i) visit("normal", k.normal[i]);
  for (int i = 0; i < 3; ++i) visit("velocity", k.velocity[i]);
  for (int i = 0; i < 3; ++i) visit("relative_spin", k.relative_spin[i]);
}

template <class Step>
bool is_nan(const Step& step) {
  return !step.force.allFinite() || !step.couple.allFinite();
}

}  // namespace

TEST_CASE("What changes the force when it changes gives a NaN force when it is NaN, for every law") {
  int read = 0, unread = 0;
  for (const auto& law : all_laws<double>()) {
    Random random = random_for("nan", law->name);
    for (int i = 0; i < cases(50); ++i) {
      const Path path = random_path(random, 6);
      auto state = start(*law, path);
      for (const ContactKinematics<double>& kinematics : path.steps) {
        const auto step = law->step(path.pair, kinematics, state);
        // A number is read if a change of it changes the result.
        const auto try_value = [&](const char* name, double& value, const auto& result) {
          const double kept = value;
          value = 0.5 * kept + 1e-9 * std::abs(kept);
          const auto changed = result();
          const bool reads = changed.force != step.force || changed.couple != step.couple;
          value = nan;
          const auto with_nan = result();
          value = kept;
          if (kept == 0.0) return;
          INFO(law->name << ": " << name << " at overlap " << kinematics.overlap);
          if (reads) CHECK(is_nan(with_nan));
          (reads ? read : unread) += 1;
        };
        ContactKinematics<double> k = kinematics;
        visit_inputs(k, [&](const char* name, double& value) {
          try_value(name, value, [&] { return law->step(path.pair, k, state); });
        });
        auto before = state;
        for (std::size_t v = 0; v < law->state_size(); ++v)
          try_value(law->state_values[v].name, before[v], [&] { return law->step(path.pair, kinematics, before); });
        state = step.state;
      }
    }
  }
  CHECK(read > cases(1000));
  CHECK(unread > cases(1000));
}

TEST_CASE("The faults of old: a wet contact, a clipped dashpot and a largest overlap say so when they are NaN") {
  const PairProperties<double> pair = granite_pair<double>();
  const Hill<double> wet = hill<double>(0.4, 2e5, 0.1);
  Hill<double>::State bridged{};
  Hill<double>::make_wet(bridged, 0.0, 0.0);
  CHECK(std::isnan(wet.step(pair, {{0, 0, 1}, nan, {0, 0, 0}, 1e-6}, bridged).force.z()));
  bridged.moisture = nan;
  CHECK(std::isnan(wet.step(pair, {{0, 0, 1}, -1e-6, {0, 0, 0}, 1e-6}, bridged).force.z()));

  DryHillProperties<double> properties;
  properties.damping_constant = 0.1;
  const auto clipped = contactlaws::dry_hill<Tension::clipped>(properties);
  CHECK(std::isnan(clipped.step(pair, {{0, 0, 1}, 1e-6, {0, 0, nan}, 1e-6}, {}).force.z()));

  const ContactLaw<PohrtPopovElastoPlastic<double>> rough{PohrtPopovElastoPlastic<double>::of({2.13, 26.1e-6})};
  decltype(rough)::State pressed{};
  pressed.largest_overlap = nan;
  CHECK(std::isnan(rough.step(pair, {{0, 0, 1}, 1e-6, {0, 0, 0}, 1e-6}, pressed).force.z()));
}

TEST_CASE("A NaN of an open contact stays in its lane, and has no effect there") {
  const DryHill<double> law = test::dry_hill<double>(0.4, 0.1);
  const PairProperties<double> pair = granite_pair<double>();
  const double inf = std::numeric_limits<double>::infinity();
  // Every other contact is open, with a velocity and a history that are no numbers: each pack has both kinds.
  constexpr std::size_t count = 16;
  std::array<double, count> overlap, across, along, result[3], history[3], next[3];
  for (std::size_t i = 0; i < count; ++i) {
    const bool open = i % 2 == 1;
    overlap[i] = open ? -1e-6 : 1e-5;
    across[i] = open ? nan : 0.01;
    along[i] = open ? inf : -0.02;
    for (auto& values : history) values[i] = open ? nan : 0.5;
  }
  ContactBatch<DryHill<double>> batch;
  batch.count = count;
  batch.pair = pair.map<Column<double>>([](double x) { return Column<double>(x); });
  batch.normal = {0.0, 0.0, 1.0};
  batch.overlap = overlap.data();
  batch.velocity = {across.data(), 0.0, along.data()};
  batch.dt = 1e-6;
  for (std::size_t i = 0; i < 3; ++i) {
    batch.state[i] = history[i].data();
    batch.next[i] = next[i].data();
    batch.force[i] = result[i].data();
  }
  evaluate(law, batch);
  for (std::size_t i = 0; i < count; ++i) {
    DryHill<double>::State state{};
    state.shear = {history[0][i], history[1][i], history[2][i]};
    const auto step = law.step(pair, {{0, 0, 1}, overlap[i], {across[i], 0.0, along[i]}, 1e-6}, state);
    INFO("contact " << i);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(result[c][i] == step.force[static_cast<int>(c)]);
      CHECK(next[c][i] == step.state.shear[c]);
    }
    if (i % 2 == 1) CHECK(result[2][i] == 0.0);
  }
}

}  // namespace contactlaws::test

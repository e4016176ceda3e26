// A law along paths that bytes describe:   fuzz_laws --law=DryHill CORPUS
// Names of laws are those of tests/law_properties.hpp, with _ for blanks. An input is a path of `steps` steps, whatever its
// length. One in eight is wild: any finite numbers, of which only is asked that nothing undefined happens.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "contact.hpp"
#include "contactlaws/scalars/xsimd.hpp"
#include "law_properties.hpp"

namespace fuzz {

namespace {

constexpr std::size_t steps = 64;
/// Below it [N] strength/trial, by which a trial force (here up to 2^130 N) is shortened, has lost digits or is zero.
constexpr double smallest_strength = 0x1p-890;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz_laws: violated: %s\n", what);
  std::abort();
}

bool finite(const Vector& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }

template <class Law>
using Values = std::array<double, Law::state_size>;

template <std::size_t N>
bool same_bits(const std::array<double, N>& a, const std::array<double, N>& b) {
  for (std::size_t i = 0; i < N; ++i)
    if (std::memcmp(&a[i], &b[i], sizeof(double)) != 0) return false;
  return true;
}

/// A path with what the law made of it, step by step.
template <class Law>
struct Driven {
  std::array<Motion, steps> motion;
  std::array<Values<Law>, steps> before, after;
  std::array<Vector, steps> force;
};

/// Whether a pack has the bits of one contact: + - * / sqrt are the same in both; pow, exp, sin and cos are not.
template <class Law>
bool has_equal_packs(const Law& law, const Driven<Law>& path) {
  bool equal = !test::has_bridge<Law>;
  for (const auto& p : decltype(law.normal)::parameters()) equal = equal && std::string(p.name) != "transition_overlap";
  return equal &&
         std::all_of(path.motion.begin(), path.motion.end(), [](const Motion& m) { return m.normal_spin == 0.0; });
}

/// The first `count` steps once more as a batch, from arrays of exactly that length, so that reading beyond is seen.
template <class Law>
void step_as_batch(const Law& law, const PairProperties<double>& pair, const Driven<Law>& path, std::size_t count) {
  const auto column = [&](const auto& value_of) {
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i) values[i] = value_of(i);
    return values;
  };
  std::array<std::vector<double>, 3> normal, velocity, force;
  std::array<std::vector<double>, Law::state_size> state;
  const std::vector<double> overlap = column([&](std::size_t i) { return path.motion[i].overlap; });
  const std::vector<double> dt = column([&](std::size_t i) { return path.motion[i].dt; });
  const std::vector<double> spin = column([&](std::size_t i) { return path.motion[i].normal_spin; });
  ContactBatch<Law> batch;
  batch.count = count;
  batch.pair = {pair.effective_radius, pair.effective_young, pair.effective_shear,
                pair.effective_mass,   pair.min_radius,      pair.length};
  batch.overlap = overlap.data();
  batch.dt = dt.data();
  batch.normal_spin = spin.data();
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    normal[a] = column([&](std::size_t i) { return path.motion[i].normal[axis]; });
    velocity[a] = column([&](std::size_t i) { return path.motion[i].velocity[axis]; });
    force[a].resize(count);
    batch.normal[a] = normal[a].data();
    batch.velocity[a] = velocity[a].data();
    batch.force[a] = force[a].data();
  }
  for (std::size_t j = 0; j < Law::state_size; ++j) {
    state[j] = column([&](std::size_t i) { return path.before[i][j]; });
    batch.state[j] = batch.next[j] = state[j].data();
  }
  evaluate(law, batch);
  if (!has_equal_packs(law, path)) return;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector seen(force[0][i], force[1][i], force[2][i]);
    expect(seen == path.force[i], "a pack gives the force of one contact");
    for (std::size_t j = 0; j < Law::state_size; ++j)
      expect(state[j][i] == path.after[i][j], "a pack gives the state of one contact");
  }
}

/// What holds of any step within the domain.
template <class Law>
void expect_physics(const Law& law, const PairProperties<double>& pair, const Motion& motion,
                    const Step<double, typename Law::State>& step, const Values<Law>& next) {
  expect(finite(step.force), "a finite force");
  for (const double value : next) expect(std::isfinite(value), "a finite state");
  expect(step.normal_elastic >= 0.0 && std::isfinite(step.normal_elastic), "springs push, finitely");
  expect(step.bridge_force >= 0.0 && std::isfinite(step.bridge_force), "bridges pull, finitely");
  constexpr bool pulls = std::is_same_v<decltype(Law::damping), Dashpots<double, Tension::allowed>>;
  expect(pulls || step.normal_force >= 0.0, "no tension unless allowed");
  if (!(motion.overlap > 0.0)) {
    expect(step.normal_elastic == 0.0 && step.normal_force == 0.0 && !step.sliding,
           "an open contact does not push or slide");
    expect(-motion.overlap < law.interaction_range(pair) || motion.overlap == 0.0 || step.bridge_force == 0.0,
           "nothing acts beyond the interaction range");
  }

  double strength = 0.0;
  if constexpr (test::has_shear<Law>) strength = law.shear.friction * positive_part(step.normal_force);
  if (strength > 0.0 && strength < smallest_strength) return;
  // 8 roundings of forces of this size, as in tests/scalar_properties.hpp, and of the smallest number.
  const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * test::force_scale(step) +
                          8.0 * std::numeric_limits<double>::denorm_min();
  const Vector shear = step.force - motion.normal * (step.normal_force - step.bridge_force);
  expect(norm<double>(shear) <= strength + rounding, "friction bounds the shear force");
}

/// What holds of any step at all, and of the questions that go with it.
template <class Law>
void expect_purity(const Law& law, const PairProperties<double>& pair, const Motion& motion, const Values<Law>& before,
                   const Values<Law>& after, const Vector& force, bool wild) {
  const typename Law::State next = Law::load(after.data());
  Values<Law> again{};
  Law::store(next, again.data());
  expect(same_bits(after, again), "a state comes back as it was stored");
  const ContactStiffness<double> stiffness = law.stiffness(pair, motion.overlap, next);
  const double energy = law.stored_energy(pair, motion.overlap, next);
  const auto second = law.step(pair, motion, Law::load(before.data()));
  Law::store(second.state, again.data());
  expect(same_bits(after, again) && std::memcmp(force.data(), second.force.data(), 3 * sizeof(double)) == 0,
         "asked twice, the same answer twice");
  if (wild) return;
  expect(stiffness.normal >= 0.0 && stiffness.shear >= 0.0 && std::isfinite(stiffness.normal + stiffness.shear),
         "a finite stiffness");
  expect(std::isfinite(energy), "a finite energy");
}

template <class Law>
void drive(const Law& prototype, const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const bool wild = bytes.one_in(8);
  const PairProperties<double> pair = drawn_pair(bytes);
  const Law law{drawn(prototype.normal, bytes), drawn(prototype.damping, bytes), drawn(prototype.shear, bytes),
                drawn(prototype.bridge, bytes)};
  Mover mover(pair, bytes, wild);
  Driven<Law> path;
  Values<Law> now{};
  for (std::size_t i = 0; i < steps; ++i) {
    const Motion& motion = path.motion[i] = mover.next();
    typename Law::State state = Law::load(now.data());
    if constexpr (test::has_bridge<Law>) {
      if (bytes.one_in(8)) Law::make_wet(state, motion.overlap, bytes.magnitude(-50, 10));
      if (bytes.one_in(32)) Law::make_dry(state);
    }
    Law::store(state, path.before[i].data());
    const auto step = law.step(pair, motion, state);
    Law::store(step.state, now.data());
    path.after[i] = now;
    path.force[i] = step.force;
    if (!wild) expect_physics(law, pair, motion, step, now);
  }
  expect_purity(law, pair, path.motion.back(), path.before.back(), path.after.back(), path.force.back(), wild);
  // Beyond 2^63 the packs' own exp and sin convert what no integer holds, so wild paths are not for them.
  if (!wild && bytes.one_in(4)) step_as_batch(law, pair, path, static_cast<std::size_t>(bytes.between(0, steps)));
}

std::map<std::string, std::function<void(const std::uint8_t*, std::size_t)>> drivers() {
  std::map<std::string, std::function<void(const std::uint8_t*, std::size_t)>> all;
  test::visit_laws([&all](std::string name, std::size_t, const auto& law) {
    std::replace(name.begin(), name.end(), ' ', '_');
    all[name] = [law](const std::uint8_t* data, std::size_t size) { drive(law, data, size); };
  });
  return all;
}

std::function<void(const std::uint8_t*, std::size_t)> chosen;

}  // namespace

}  // namespace fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string option = "--law=";
  for (int i = 1; i < *argc; ++i) {
    const std::string argument = (*argv)[i];
    if (argument.compare(0, option.size(), option) != 0) continue;
    const auto drivers = fuzz::drivers();
    const auto found = drivers.find(argument.substr(option.size()));
    if (found != drivers.end()) fuzz::chosen = found->second;
  }
  if (fuzz::chosen) return 0;
  std::fprintf(stderr, "fuzz_laws: --law= must name one of\n");
  for (const auto& driver : fuzz::drivers()) std::printf("%s\n", driver.first.c_str());
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::chosen(data, size);
  return 0;
}

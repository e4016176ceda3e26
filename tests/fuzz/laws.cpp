// A law along paths that bytes describe:   fuzz_laws --law=DryHill CORPUS
// Names of laws are those of tests/properties/law_list.hpp, with _ for blanks. An input is a path of `steps` steps, whatever
// its length. One in eight is wild: any finite numbers, for which only undefined behaviour and impurity are faults.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "contact.hpp"
#include "properties/packs.hpp"
#include "properties/symmetries.hpp"

namespace fuzz {

namespace {

using Law = test::ErasedLaw<double>;
using Instant = test::Instant<double>;

constexpr std::size_t steps = 64;
/// Below it [N] strength/trial, by which a trial force (here up to 2^130 N) is shortened, has lost digits or is zero.
constexpr double smallest_strength = 0x1p-890;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz_laws: violated: %s\n", what);
  std::abort();
}

/// What holds of any step within the domain.
void expect_physics(const Law& law, const Instant& now) {
  const auto& step = now.step;
  expect(step.force.allFinite() && step.couple.allFinite(), "a finite force and couple");
  for (const double value : step.state) expect(std::isfinite(value), "a finite state");
  const bool holds = now.kinematics.overlap > 0.0 || step.normal_elastic != 0.0;
  const double adhesion = holds ? law.adhesion(now.pair, now.pair.effective_radius / 1000) : 0.0;
  expect(step.normal_elastic >= -adhesion && std::isfinite(step.normal_elastic), "springs push, finitely");
  expect(step.bridge_force >= 0.0 && std::isfinite(step.bridge_force), "bridges pull, finitely");
  expect(law.pulls || step.normal_force >= -adhesion, "no tension unless allowed");
  if (!holds)
    expect(test::wrong_when_open(law, now.pair, now.kinematics, step) == 0, "an open contact exerts its bridge's pull");
  const double strength = law.friction().largest * positive_part(step.normal_force + adhesion);
  if (strength > 0.0 && strength < smallest_strength) return;
  expect(test::friction_error(law, now.pair, now.kinematics, step) <= 8.0, "friction bounds the shear force");
  expect(test::changed_by_swap(law, now) == 0, "forces on swapped bodies are opposite");
}

/// What holds of any step at all, and of the queries that go with it.
void expect_purity(const Law& law, const Instant& now, bool wild) {
  const auto bits = [](const auto& step) {
    std::array<unsigned char, sizeof(step.force) + sizeof(step.state)> all;
    std::memcpy(all.data(), step.force.data(), sizeof(step.force));
    std::memcpy(all.data() + sizeof(step.force), step.state.data(), sizeof(step.state));
    return all;
  };
  const ContactStiffness<double> stiffness = law.stiffness(now.pair, now.kinematics.overlap, now.step.state);
  const double energy = law.stored_energy(now.pair, now.kinematics.overlap, now.step.state);
  expect(bits(law.step(now.pair, now.kinematics, now.state)) == bits(now.step), "the same input, the same output");
  if (wild) return;
  expect(stiffness.normal >= 0.0 && stiffness.shear >= 0.0 && std::isfinite(stiffness.normal + stiffness.shear),
         "a finite stiffness");
  expect(std::isfinite(energy), "a finite energy");
}

/// The same steps in the lanes of a pack.
void expect_equal_lanes(const Law& law, const test::ErasedLaw<xsimd::batch<double>>& packed,
                        const std::vector<Instant>& path) {
  constexpr std::size_t lanes = xsimd::batch<double>::size;
  const PairProperties<xsimd::batch<double>> pair = path[0].pair.cast<xsimd::batch<double>>();
  for (std::size_t first = 0; first + lanes <= path.size(); first += lanes) {
    std::vector<test::Path> by_lane;
    for (std::size_t i = 0; i < lanes; ++i) by_lane.push_back({path[0].pair, {path[first + i].kinematics}, false});
    auto state = packed.virgin();
    for (std::size_t v = 0; v < law.state_size(); ++v)
      state[v] = test::gather<double>([&](std::size_t i) { return path[first + i].state[v]; });
    const auto step = packed.step(pair, test::gather_step<double>(by_lane, 0), state);
    for (std::size_t i = 0; i < lanes; ++i) {
      const auto& alone = path[first + i].step;
      for (int axis = 0; axis < 3; ++axis)
        expect(test::lane<double>(step.force[axis], i) == alone.force[axis], "a pack gives the force of one contact");
      for (std::size_t v = 0; v < law.state_size(); ++v)
        expect(test::lane<double>(step.state[v], i) == alone.state[v], "a pack gives the state of one contact");
    }
  }
}

std::unique_ptr<Law> prototype;
std::unique_ptr<test::ErasedLaw<xsimd::batch<double>>> packed_prototype;  ///< none where lanes have other digits

void drive(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const bool wild = bytes.one_in(8);
  const PairProperties<double> pair = drawn_pair(bytes);
  const auto law = prototype->clone();
  draw_parameters(*law, bytes);
  Mover mover(pair, bytes, wild);
  std::vector<Instant> path;
  Instant now{pair, {}, law->virgin(), {}, 0.0};
  for (std::size_t i = 0; i < steps; ++i) {
    now.kinematics = mover.next();
    if (law->bridges) {
      if (bytes.one_in(8)) law->make_wet(now.state, now.kinematics.overlap, bytes.magnitude(-50, 10));
      if (bytes.one_in(32)) law->make_dry(now.state);
    }
    now.step = law->step(pair, now.kinematics, now.state);
    if (!wild) expect_physics(*law, now);
    path.push_back(now);
    now.state = now.step.state;
  }
  expect_purity(*law, path.back(), wild);
  // Beyond 2^63 the packs' own exp and sin convert what no integer holds, so wild paths are not for them.
  if (wild || !packed_prototype || !bytes.one_in(4)) return;
  const auto packed = packed_prototype->clone();
  const auto from = law->parameters();
  const auto to = packed->parameters();
  for (std::size_t i = 0; i < from.size(); ++i) *to[i].value = *from[i].value;
  expect_equal_lanes(*law, *packed, path);
}

std::string file_name(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

}  // namespace

}  // namespace fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace fuzz;
  auto laws = test::all_laws<double>();
  const std::string option = "--law=";
  for (int i = 1; i < *argc; ++i) {
    const std::string argument = (*argv)[i];
    if (argument.compare(0, option.size(), option) != 0) continue;
    for (auto& law : laws)
      if (law && file_name(law->name) == argument.substr(option.size())) prototype = std::move(law);
  }
  if (!prototype) {
    std::fprintf(stderr, "fuzz_laws: --law= must name one of\n");
    for (const auto& law : laws) std::printf("%s\n", file_name(law->name).c_str());
    std::exit(2);
  }
  for (auto& law : test::all_laws<xsimd::batch<double>>())
    if (law->name == prototype->name && test::has_equal_packs(*prototype)) packed_prototype = std::move(law);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::drive(data, size);
  return 0;
}

// A pack of contacts takes, in each lane, exactly the path of that contact alone.
#include <array>

#include "contactlaws/scalars/xsimd.hpp"
#include "law_properties.hpp"

namespace contactlaws::test {
namespace {

// A compiler that may fuse a multiplication and an addition need not do so in both texts.
#if defined(__FMA__)
constexpr bool fused = true;
#else
constexpr bool fused = false;
#endif

template <class Lane>
using Pack = xsimd::batch<Lane>;

/// One number of each lane as a pack.
template <class Lane, class Get>
Pack<Lane> gather(Get get) {
  alignas(64) std::array<Lane, Pack<Lane>::size> lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = get(i);
  return Pack<Lane>::load_aligned(lanes.data());
}

template <class Lane>
Lane lane(const Pack<Lane>& pack, std::size_t i) {
  alignas(64) std::array<Lane, Pack<Lane>::size> lanes;
  pack.store_aligned(lanes.data());
  return lanes[i];
}

template <class Lane>
bool lane(const xsimd::batch_bool<Lane>& mask, std::size_t i) {
  bool lanes[Pack<Lane>::size];
  mask.store_unaligned(lanes);
  return lanes[i];
}

template <class Lane>
ContactKinematics<Pack<Lane>> gather_step(const std::vector<Path>& paths, std::size_t step) {
  const auto pack = [&](auto member) {
    return gather<Lane>([&](std::size_t i) { return static_cast<Lane>(member(paths[i].steps[step])); });
  };
  const auto vector = [&](auto member) {
    return Vec3<Pack<Lane>>(pack([&](const auto& k) { return member(k).x(); }),
                            pack([&](const auto& k) { return member(k).y(); }),
                            pack([&](const auto& k) { return member(k).z(); }));
  };
  return {vector([](const auto& k) { return k.normal; }), pack([](const auto& k) { return k.overlap; }),
          vector([](const auto& k) { return k.velocity; }), pack([](const auto& k) { return k.dt; }),
          pack([](const auto& k) { return k.normal_spin; })};
}

template <class Lane>
PairProperties<Pack<Lane>> gather_pair(const std::vector<Path>& paths) {
  const auto pack = [&](double PairProperties<double>::*member) {
    return gather<Lane>([&](std::size_t i) { return static_cast<Lane>(paths[i].pair.*member); });
  };
  using Pair = PairProperties<double>;
  return {pack(&Pair::effective_radius), pack(&Pair::effective_young), pack(&Pair::effective_shear),
          pack(&Pair::effective_mass),   pack(&Pair::min_radius),      pack(&Pair::length)};
}

}  // namespace

TEMPLATE_TEST_CASE("a pack does lane by lane what one contact does", "", double, float) {
  using Lane = TestType;
  using T = Pack<Lane>;
  visit_laws([](const char* name, std::size_t, const auto& any_law) {
    INFO(name);
    const auto law = any_law.template cast<Lane>();
    const auto packed = any_law.template cast<T>();
    using Law = std::decay_t<decltype(law)>;
    using Packed = std::decay_t<decltype(packed)>;
    static_assert(noexcept(packed.step(std::declval<PairProperties<T>>(), std::declval<ContactKinematics<T>>(),
                                       std::declval<typename Packed::State>())));

    // The functions that a pack computes by formulas of its own; the rest is + - * / sqrt, the same in every text.
    const bool own_functions = has_bridge<Law> || Law::state_size >= 6 || std::string(name).find("Rough") == 0;
    const Lane tolerance = own_functions || fused ? 100 * std::numeric_limits<Lane>::epsilon() : Lane(0);

    Random random;
    for (int repeat = 0; repeat < cases(20); ++repeat) {
      constexpr std::size_t steps = 10;
      std::vector<Path> paths;
      for (std::size_t i = 0; i < T::size; ++i) paths.push_back(random_path(random, steps));
      for (auto& path : paths) path.wet = paths[0].wet;

      const PairProperties<T> pair = gather_pair<Lane>(paths);
      typename Packed::State state = start<Packed>(paths[0]);
      std::vector<typename Law::State> states(T::size, start<Law>(paths[0]));
      std::vector<Lane> largest(T::size, Lane(0));
      for (std::size_t s = 0; s < steps; ++s) {
        const auto kinematics = gather_step<Lane>(paths, s);
        const auto step = packed.step(pair, kinematics, state);
        const T energy = packed.stored_energy(pair, kinematics.overlap, step.state);
        for (std::size_t i = 0; i < T::size; ++i) {
          const auto lane_pair = paths[i].pair.template cast<Lane>();
          const auto lane_kinematics = paths[i].steps[s].template cast<Lane>();
          const auto alone = law.step(lane_pair, lane_kinematics, states[i]);
          largest[i] = std::max(largest[i], force_scale(alone));
          INFO("step " << s << " lane " << i);
          for (int c = 0; c < 3; ++c)
            CHECK(std::abs(lane<Lane>(step.force[c], i) - alone.force[c]) <= tolerance * largest[i]);
          CHECK(lane<Lane>(step.active, i) == alone.active);
          if (tolerance == 0) {
            CHECK(lane<Lane>(step.sliding, i) == alone.sliding);
            CHECK(lane<Lane>(energy, i) == law.stored_energy(lane_pair, lane_kinematics.overlap, alone.state));
            auto next = step.state;
            auto next_alone = alone.state;
            for (std::size_t v = 0; v < Law::state_size; ++v)
              CHECK(lane<Lane>(values_of<Packed>(next)[v], i) == values_of<Law>(next_alone)[v]);
          }
          states[i] = alone.state;
        }
        state = step.state;
      }
    }
  });
}

}  // namespace contactlaws::test

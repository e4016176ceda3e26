// A pack of contacts against the same contacts one at a time.
#pragma once

#include "contactlaws/scalars/xsimd.hpp"
#include "paths.hpp"

namespace contactlaws::test {

/// Whether a pack has the bits of one contact: + - * / sqrt are the same in both; pow, exp, sin and cos are not.
template <class T>
bool has_equal_packs(const ErasedLaw<T>& law) {
  const auto turns = [](const StateValue& value) { return value.name == std::string_view("last_normal_x"); };
  return !law.bridges && law.name.find("Rough") != 0 &&
         std::none_of(law.state_values.begin(), law.state_values.end(), turns);
}

/// One number of each lane as a pack.
template <class Lane, class Get>
xsimd::batch<Lane> gather(const Get& get) {
  std::array<Lane, xsimd::batch<Lane>::size> lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i) lanes[i] = static_cast<Lane>(get(i));
  return xsimd::batch<Lane>::load_unaligned(lanes.data());
}
template <class Lane>
Lane lane(const xsimd::batch<Lane>& pack, std::size_t i) {
  std::array<Lane, xsimd::batch<Lane>::size> lanes;
  pack.store_unaligned(lanes.data());
  return lanes[i];
}
template <class Lane>
bool lane(const xsimd::batch_bool<Lane>& mask, std::size_t i) {
  bool lanes[xsimd::batch<Lane>::size];
  mask.store_unaligned(lanes);
  return lanes[i];
}

template <class Lane>
ContactKinematics<xsimd::batch<Lane>> gather_step(const std::vector<Path>& paths, std::size_t step) {
  const auto pack = [&](const auto& member) {
    return gather<Lane>([&](std::size_t i) { return member(paths[i].steps[step]); });
  };
  const auto vector = [&](const auto& member) {
    const auto component = [&](int axis) { return pack([&](const auto& k) { return member(k)[axis]; }); };
    return Vec3<xsimd::batch<Lane>>(component(0), component(1), component(2));
  };
  return {vector([](const auto& k) { return k.normal; }),    pack([](const auto& k) { return k.overlap; }),
          vector([](const auto& k) { return k.velocity; }),  pack([](const auto& k) { return k.dt; }),
          pack([](const auto& k) { return k.normal_spin; }), vector([](const auto& k) { return k.relative_spin; })};
}
template <class Lane>
PairProperties<xsimd::batch<Lane>> gather_pair(const std::vector<Path>& paths) {
  const auto pack = [&](double PairProperties<double>::*member) {
    return gather<Lane>([&](std::size_t i) { return paths[i].pair.*member; });
  };
  using Pair = PairProperties<double>;
  return {pack(&Pair::effective_radius), pack(&Pair::effective_young), pack(&Pair::effective_shear),
          pack(&Pair::effective_mass),   pack(&Pair::min_radius),      pack(&Pair::length)};
}

struct PackErrors {
  double force = 0.0;  ///< [eps of the largest force of the contact so far]
  int active = 0;      ///< lanes that act where the contact alone does not, or the reverse
  int changed = 0;     ///< values of the state, the couple, the sliding or the energy that are not equal
};

/// Over one path a lane, of the same wetness.
template <class Lane>
PackErrors error_in_packs(const ErasedLaw<Lane>& law, const ErasedLaw<xsimd::batch<Lane>>& packed,
                          const std::vector<Path>& paths) {
  using Pack = xsimd::batch<Lane>;
  const PairProperties<Pack> pair = gather_pair<Lane>(paths);
  auto state = start(packed, paths[0]);
  std::vector<typename ErasedLaw<Lane>::State> states(Pack::size, start(law, paths[0]));
  std::vector<Lane> largest(Pack::size, Lane(0));
  PackErrors errors;
  for (std::size_t s = 0; s < paths[0].steps.size(); ++s) {
    const auto kinematics = gather_step<Lane>(paths, s);
    const auto step = packed.step(pair, kinematics, state);
    const Pack energy = packed.stored_energy(pair, kinematics.overlap, step.state);
    for (std::size_t i = 0; i < Pack::size; ++i) {
      const auto lane_pair = paths[i].pair.template cast<Lane>();
      const auto lane_kinematics = paths[i].steps[s].template cast<Lane>();
      const auto alone = law.step(lane_pair, lane_kinematics, states[i]);
      largest[i] = std::max(largest[i], force_scale(alone));
      for (int axis = 0; axis < 3; ++axis) {
        const Lane off = std::abs(lane<Lane>(step.force[axis], i) - alone.force[axis]);
        const double error = off == Lane(0) ? 0.0 : static_cast<double>(off / largest[i] / epsilon<Lane>());
        if (!(error <= errors.force)) errors.force = error;  // a NaN is seen
      }
      errors.active += lane<Lane>(step.active, i) != alone.active;
      errors.changed += lane<Lane>(step.sliding, i) != alone.sliding;
      errors.changed += lane<Lane>(energy, i) != law.stored_energy(lane_pair, lane_kinematics.overlap, alone.state);
      for (int axis = 0; axis < 3; ++axis) errors.changed += lane<Lane>(step.couple[axis], i) != alone.couple[axis];
      for (std::size_t v = 0; v < law.state_size(); ++v)
        errors.changed += lane<Lane>(step.state[v], i) != alone.state[v];
      states[i] = alone.state;
    }
    state = step.state;
  }
  return errors;
}

}  // namespace contactlaws::test

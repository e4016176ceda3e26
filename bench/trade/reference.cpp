// SPDX-License-Identifier: MIT
#include "reference.hpp"

#include "../../examples/contact_path/build_law.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/scalars/multiprecision.hpp"

namespace trade {

namespace {

using contact_path::AnyNormal;
using contact_path::LawSlots;
using T = Binary200;

template <class Law>
Reference solve_with(const Law& law, const LawSlots<T>& slots, const Scene& scene,
                     const std::function<void(double)>& progress) {
  typename Law::State first{};
  if constexpr (decltype(Law::bridge)::acts)
    if (slots.starts_wet) Law::make_wet(first, T(0), T(0));
  std::vector<typename Law::State> state(scene.contacts(), first);
  std::vector<contactlaws::EnergyLedger<T>> ledger(scene.contacts());
  Reference result;
  result.energy_scale.resize(scene.contacts());
  for (std::size_t c = 0; c < scene.contacts(); ++c)
    ledger[c].stored_at_start = law.stored_energy(slots.pair, scene.exact[c].overlap, first);
  for (std::size_t step = 0; step < scene.steps(); ++step) {
    progress(double(step) / double(scene.steps()));
    for (std::size_t c = 0; c < scene.contacts_at(step); ++c) {
      const ContactKinematics<T>& motion = scene.exact[scene.offset[step] + c];
      const auto answer = law.step(slots.pair, motion, state[c]);
      state[c] = answer.state;
      ledger[c].enter(law, slots.pair, motion, answer);
      result.energy_scale[c] = std::max(result.energy_scale[c], std::abs(static_cast<double>(ledger[c].work)));
      result.rows.push_back({answer.force.template cast<long double>(), static_cast<double>(answer.normal_elastic),
                             static_cast<double>(answer.normal_force), static_cast<double>(answer.bridge_force),
                             answer.sliding});
    }
  }
  for (const auto& l : ledger) result.dissipated.push_back(static_cast<double>(l.dissipated()));
  return result;
}

}  // namespace

Reference solve(const contact_path::LawDescription& description, const Scene& scene,
                const std::function<void(double)>& progress) {
  const LawSlots<T> slots = contact_path::build_law<T>(description);
  return std::visit(
      [&](const auto& damping, const auto& shear, const auto& bridge) {
        using Law = contactlaws::ContactLaw<AnyNormal<T>, std::decay_t<decltype(damping)>,
                                            std::decay_t<decltype(shear)>, std::decay_t<decltype(bridge)>>;
        return solve_with<Law>({slots.normal, damping, shear, bridge}, slots, scene, progress);
      },
      slots.damping, slots.shear, slots.bridge);
}

}  // namespace trade

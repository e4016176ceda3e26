// SPDX-License-Identifier: MIT
#include "reference.hpp"

#include "contact_path/any_law.hpp"
#include "contactlaws/energy.hpp"
#include "contactlaws/scalars/multiprecision.hpp"

namespace trade {

Reference solve(const contact_path::LawSpec& spec, const Trajectories& trajectories,
                const std::function<void(double)>& progress) {
  using T = Binary200;
  const contactlaws::PairProperties<T> pair = contact_path::build_pair<T>(spec);
  const auto law = contact_path::build_law<T>(spec, pair);
  const std::size_t contacts = trajectories.contacts();
  std::vector<std::vector<T>> state(contacts, law->first_state());
  std::vector<contactlaws::EnergyLedger<T>> ledger(contacts);
  Reference result;
  result.energy_scale.resize(contacts);
  for (std::size_t c = 0; c < contacts; ++c)
    ledger[c].stored_at_start = law->stored_energy(pair, trajectories.exact[c].overlap, state[c]);
  for (std::size_t step = 0; step < trajectories.steps(); ++step) {
    progress(double(step) / double(trajectories.steps()));
    for (std::size_t c = 0; c < trajectories.contacts_at(step); ++c) {
      const ContactKinematics<T>& motion = trajectories.exact[trajectories.offset[step] + c];
      const auto at = law->step(pair, motion, state[c]);
      state[c] = at.state;
      ledger[c].enter(*law, pair, motion, at);
      result.energy_scale[c] = std::max(result.energy_scale[c], std::abs(static_cast<double>(ledger[c].work)));
      result.rows.push_back({at.force.template cast<long double>(), static_cast<double>(at.normal_elastic),
                             static_cast<double>(at.normal_force), static_cast<double>(at.bridge_force), at.sliding});
    }
  }
  for (const auto& l : ledger) result.dissipated.push_back(static_cast<double>(l.dissipated()));
  return result;
}

}  // namespace trade

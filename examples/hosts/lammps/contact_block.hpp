// SPDX-License-Identifier: MIT
// Contacts of spheres that a host collects one by one in its loop over pairs, and steps together: on packs, or one by one.
#pragma once

#include <array>
#include <cstddef>

#include "contactlaws/batch.hpp"
#include "contactlaws/contactlaws.hpp"

namespace contactlaws {

/// Body 1 stands at the origin: `branch` and `velocity` are those of centre 2 relative to centre 1.
template <class Law>
struct ContactBlock {
  static constexpr std::size_t capacity = 64;  // the columns stay in the first-level cache
  using Column = std::array<double, capacity>;
  using Vectors = std::array<Column, 3>;

  std::size_t count = 0;
  Vectors branch;                             ///< x2 - x1 [m]
  Vectors velocity;                           ///< v2 - v1 [m/s]
  Vectors spin1, spin2;                       ///< [rad/s]
  Column radius1, radius2;                    ///< [m]
  Column mass1, mass2;                        ///< [kg]
  std::array<Column, Law::state_size> state;  ///< before and after the step
  Vectors force;                              ///< on body 2 [N]
  Vectors torque1, torque2;                   ///< about the centres [N m]
  Column active;                              ///< 1 where the bodies touch or a bridge holds, else 0
  Column friction_work, dashpot_work;         ///< heat of this step [J]

  /// Steps the collected contacts over dt [s].
  template <class Pack>
  void step(const Law& law, const EffectiveModuli<double>& moduli, double dt) noexcept {
    struct Input : SphereContact<Pack> {
      PairProperties<Pack> pair;
    };
    std::array<const double*, Law::state_size> before;
    std::array<double*, Law::state_size> after;
    for (std::size_t k = 0; k < state.size(); ++k) before[k] = after[k] = state[k].data();

    const auto gather = [&](const auto& range) {
      const auto column = [&range](const Column& c) { return range.load(c.data()); };
      const Pack zero(0.0), r1 = column(radius1), r2 = column(radius2);
      const Pack origin[3] = {zero, zero, zero};
      const Pack x[3] = {column(branch[0]), column(branch[1]), column(branch[2])};
      const Pack v[3] = {column(velocity[0]), column(velocity[1]), column(velocity[2])};
      const Pack w1[3] = {column(spin1[0]), column(spin1[1]), column(spin1[2])};
      const Pack w2[3] = {column(spin2[0]), column(spin2[1]), column(spin2[2])};
      return Input{sphere_contact<Pack>(origin, origin, w1, r1, x, v, w2, r2, Pack(dt)),
                   sphere_sphere_pair<Pack>({Pack(moduli.young), Pack(moduli.shear)}, r1, r2,
                                            effective_mass<Pack>(column(mass1), column(mass2)))};
    };
    const auto scatter = [&](const auto& range, const Input& input, const auto& step) {
      const auto store = [&range](Vectors& columns, const Vec3<Pack>& v) {
        for (int k = 0; k < 3; ++k) range.store(columns[std::size_t(k)].data(), v[k]);
      };
      const Torques<Pack> turning = torques<Pack>(input, step.force, step.couple);
      store(force, step.force);
      store(torque1, turning.on1);
      store(torque2, turning.on2);
      range.store(active.data(), select<Pack>(step.active, Pack(1.0), Pack(0.0)));
      range.store(friction_work.data(), step.friction_work);
      range.store(dashpot_work.data(), step.dashpot_work);
    };
    evaluate<Law, Pack>(law, 0, count, before, after, gather, scatter);
  }

  /// State of contact c after the step.
  typename Law::State state_of(std::size_t c) const noexcept {
    std::array<double, Law::state_size> values;
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = state[k][c];
    return Law::load(values.data());
  }
};

}  // namespace contactlaws

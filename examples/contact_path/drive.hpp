// SPDX-License-Identifier: MIT
// Drives one contact along an imposed motion, and writes what its law answers: a row a step.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "build_law.hpp"
#include "common/progress.hpp"
#include "contactlaws/energy.hpp"
#include "path_file.hpp"

namespace contact_path {

namespace detail {

using contactlaws::ContactKinematics;
using contactlaws::Vec3;

template <class Law>
class Drive {
 public:
  using T = typename Law::Scalar;

  Drive(const Law& law, const PairProperties<T>& pair, bool starts_wet, std::ostream& out)
      : law_(law), pair_(pair), names_(names_of(law)), out_(out) {
    if constexpr (acts)
      if (starts_wet) Law::make_wet(state_, T(0), T(0));
    out_.precision(17);
    out_ << "step,fx,fy,fz,fn_elastic,fn_total,slip,active,stored_energy,dissipated_energy";
    for (const StateValue& value : names_)
      if (is_used(value)) out_ << ',' << value.name;
    out_ << '\n';
  }

  void step(const PathStep<T>& now, const Place& place) {
    if (now.moisture_gap) wet(now, place);
    if (steps_ == 0 || now.moisture_gap) open_books(now.kinematics);
    const auto answer = law_.step(pair_, now.kinematics, state_);
    ledger_.enter(law_, pair_, now.kinematics, answer);
    state_ = answer.state;
    ++steps_;
    check(answer.force, place);

    const T total = answer.normal_force - answer.bridge_force;
    out_ << steps_ << ',' << answer.force.x() << ',' << answer.force.y() << ',' << answer.force.z() << ','
         << answer.normal_elastic << ',' << total << ',' << answer.sliding << ',' << answer.active << ','
         << ledger_.stored << ',' << ledger_.dissipated();
    std::array<T, Law::state_size> values;
    Law::store(state_, values.data());
    for (std::size_t i = 0; i < values.size(); ++i)
      if (is_used(names_[i])) out_ << ',' << values[i];
    out_ << '\n';
  }

 private:
  static constexpr bool acts = decltype(Law::bridge)::acts;

  static bool is_used(const StateValue& value) { return *value.name != '\0'; }

  static std::array<StateValue, Law::state_size> names_of(const Law& law) {
    const auto with_bridge = [](const auto& first) {
      return contactlaws::concatenate(first, decltype(Law::bridge)::state_values());
    };
    if constexpr (decltype(Law::shear)::acts) {
      return with_bridge(contactlaws::concatenate(law.normal.names(), law.shear.names()));
    } else {
      return with_bridge(law.normal.names());
    }
  }

  void wet([[maybe_unused]] const PathStep<T>& now, [[maybe_unused]] const Place& place) {
    if constexpr (acts) {
      Law::make_wet(state_, now.kinematics.overlap, *now.moisture_gap);
    } else {
      fail(place, "column make_wet has a value, but the law has no bridge");
    }
  }

  /// Starts the account of energy where this step's motion starts: what the springs and the bridge hold there has been put
  /// in before, by those who pressed the contact or wetted it.
  void open_books(const ContactKinematics<T>& now) {
    const T overlap = now.overlap + contactlaws::dot<T>(now.velocity, now.normal) * now.dt;
    const ContactKinematics<T> at_rest{now.normal, overlap, Vec3<T>(T(0), T(0), T(0)), T(0)};
    const auto answer = law_.step(pair_, at_rest, state_);
    const T stored = law_.stored_energy(pair_, overlap, answer.state);
    ledger_.stored_at_start = ledger_.stored_at_start + (stored - ledger_.stored);
    ledger_.stored = stored;
    ledger_.last_force = answer.force;
  }

  void check(const Vec3<T>& force, const Place& place) const {
    using std::isfinite;
    const bool finite =
        isfinite(force.x()) && isfinite(force.y()) && isfinite(force.z()) && isfinite(ledger_.dissipated());
    if (!finite) fail(place, "the force or the energy is out of the range of this precision");
  }

  const Law law_;
  const PairProperties<T> pair_;
  const std::array<StateValue, Law::state_size> names_;
  std::ostream& out_;
  typename Law::State state_{};
  contactlaws::EnergyLedger<T> ledger_;
  std::size_t steps_ = 0;
};

}  // namespace detail

/// Ends early if a stop is requested. @throws InputError naming what is wrong in the file, the law or their combination
template <class T>
void drive(const LawDescription& description, const std::string& path_file, std::ostream& out) {
  const LawSlots<T> slots = build_law<T>(description);
  const std::vector<PathStep<T>> path = read_path<T>(path_file);
  std::visit(
      [&](const auto& damping, const auto& shear, const auto& bridge) {
        using Law = contactlaws::ContactLaw<AnyNormal<T>, std::decay_t<decltype(damping)>,
                                            std::decay_t<decltype(shear)>, std::decay_t<decltype(bridge)>>;
        detail::Drive<Law> contact({slots.normal, damping, shear, bridge}, slots.pair, slots.starts_wet, out);
        for (const PathStep<T>& step : path) {
          if (stop_requested()) return;
          contact.step(step, {path_file, step.line});
        }
      },
      slots.damping, slots.shear, slots.bridge);
}

}  // namespace contact_path

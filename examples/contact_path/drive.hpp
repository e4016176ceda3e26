// SPDX-License-Identifier: MIT
// Drives one contact along an imposed motion and writes the results of its law: a row a step.
#pragma once

#include <chrono>
#include <cmath>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "any_law.hpp"
#include "common/progress.hpp"
#include "contactlaws/energy.hpp"
#include "path_file.hpp"

namespace contact_path {

namespace detail {

template <class T>
class Drive {
 public:
  Drive(std::shared_ptr<const AnyLaw<T>> law, const PairProperties<T>& pair, std::ostream& out)
      : law_(std::move(law)), pair_(pair), state_(law_->first_state()), out_(out) {
    out_.precision(17);
    out_ << "step,fx,fy,fz,mx,my,mz,fn_elastic,fn_total,slip,active,stored_energy,dissipated_energy";
    for (const StateValue& value : law_->state_values()) out_ << ',' << value.name;
    out_ << '\n';
  }

  /// Whether the contact is active after the step.
  bool step(const PathStep<T>& now, const Place& place) {
    if (now.moisture_gap && !law_->make_wet(state_, now.kinematics.overlap, *now.moisture_gap))
      fail(place, "column make_wet has a value, but the law has no bridge");
    if (steps_ == 0 || now.moisture_gap) open_ledger(now.kinematics);
    const auto result = law_->step(pair_, now.kinematics, state_);
    ledger_.enter(*law_, pair_, now.kinematics, result);
    state_ = result.state;
    ++steps_;
    check(result.force, place);

    const T total = result.normal_force - result.bridge_force;
    out_ << steps_;
    for (const Vec3<T>& vector : {result.force, result.couple})
      out_ << ',' << vector.x() << ',' << vector.y() << ',' << vector.z();
    out_ << ',' << result.normal_elastic << ',' << total << ',' << result.sliding << ',' << result.active << ','
         << ledger_.stored << ',' << ledger_.dissipated();
    for (const T& value : state_) out_ << ',' << value;
    out_ << '\n';
    return result.active;
  }

 private:
  /// Starts the energy ledger where this step's motion starts. What the springs and the bridge store there was done before
  /// the path, or by wetting.
  void open_ledger(const ContactKinematics<T>& now) {
    const T overlap = now.overlap + contactlaws::dot<T>(now.velocity, now.normal) * now.dt;
    const Vec3<T> zero(T(0), T(0), T(0));
    const auto result = law_->step(pair_, {now.normal, overlap, zero, T(0)}, state_);
    const T stored = law_->stored_energy(pair_, overlap, result.state);
    ledger_.stored_at_start = ledger_.stored_at_start + (stored - ledger_.stored);
    ledger_.stored = stored;
    ledger_.last_force = result.force;
    ledger_.last_couple = result.couple;
  }

  void check(const Vec3<T>& force, const Place& place) const {
    using std::isfinite;
    const bool finite =
        isfinite(force.x()) && isfinite(force.y()) && isfinite(force.z()) && isfinite(ledger_.dissipated());
    if (!finite) fail(place, "the force or the energy is out of the range of this precision");
  }

  const std::shared_ptr<const AnyLaw<T>> law_;
  const PairProperties<T> pair_;
  std::vector<T> state_;
  contactlaws::EnergyLedger<T> ledger_;
  std::ostream& out_;
  std::size_t steps_ = 0;
};

/// Notes on a motion that is probably not what its author means.
template <class T>
void note_doubts(const std::vector<PathStep<T>>& path, const PairProperties<T>& pair, const std::string& file) {
  const T& radius = pair.min_radius > T(0) ? pair.min_radius : pair.effective_radius;  // NaN where it is not given
  T agreement(0), scale(0);
  const PathStep<T>* beyond = nullptr;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const ContactKinematics<T>& now = path[i].kinematics;
    if (beyond == nullptr && now.overlap > radius) beyond = &path[i];
    if (i == 0) continue;
    const T by_overlap = now.overlap - path[i - 1].kinematics.overlap;
    const T by_velocity = -contactlaws::dot<T>(now.velocity, now.normal) * now.dt;
    const T product = by_overlap * by_velocity;
    agreement = agreement + product;
    scale = scale + (product < T(0) ? T(-product) : product);
  }
  if (scale > T(0) && agreement < -scale / T(2))
    note({file},
         "the overlap grows where the velocity separates the bodies (v.n > 0), and falls where it closes them: "
         "overlap is > 0 in contact, n points from body 1 to body 2, v is v2 - v1");
  if (beyond != nullptr) note({file, beyond->line}, "the overlap is larger than the smaller body's radius: metres?");
}

}  // namespace detail

/// @throws InputError naming what is wrong in the file, the law or their combination; Stopped
template <class T>
void drive(const LawSpec& spec, const std::string& path_file, std::ostream& out) {
  const PairProperties<T> pair = build_pair<T>(spec);
  const std::vector<PathStep<T>> path = read_path<T>(path_file);
  detail::Drive<T> contact(build_law<T>(spec, pair), pair, out);
  detail::note_doubts(path, pair, path_file);
  const auto start = std::chrono::steady_clock::now();
  std::optional<Progress> progress;  // of runs longer than a second
  bool acted = false;
  for (std::size_t i = 0; i < path.size(); ++i) {
    stop_if_requested();
    acted = contact.step(path[i], {path_file, path[i].line}) || acted;
    if (!progress && std::chrono::steady_clock::now() - start > std::chrono::seconds(1))
      progress.emplace("contact_path");
    if (progress) progress->at(double(i) / double(path.size()));
  }
  if (!acted) note({path_file}, "the contact is open in every step: overlap is > 0 in contact, < 0 across a gap");
}

}  // namespace contact_path

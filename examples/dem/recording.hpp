// SPDX-License-Identifier: MIT
// Motion of the contacts of a run, in the format of `trade --replay`: one row per contact and step.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "common/table.hpp"
#include "contactlaws/kinematics.hpp"
#include "neighbours.hpp"

namespace dem {

/// Collects rows in memory and writes them at the end. A contact that was not entered at a step is a new one when it returns.
class Recording {
 public:
  /// `every`: steps per row, with their mean velocity; more than 1 keeps the file small.
  explicit Recording(int every = 1) : every_(every) {}

  /// Enters the motion of a contact over the step.
  void add(const Pair& bodies, const contactlaws::ContactKinematics<double>& motion) {
    const auto known = before_.find(bodies);
    Unwritten now = known != before_.end() ? known->second : Unwritten{next_number_++, 0.0, Vec3::Zero(), 0.0};
    now.time += motion.dt;
    now.path += motion.velocity * motion.dt;
    now.turn += motion.normal_spin * motion.dt;
    if ((steps_ + 1) % every_ == 0 && now.time > 0.0) {
      const Vec3 velocity = now.path / now.time;
      const Vec3& n = motion.normal;
      rows_.add({double(now.number), now.time, motion.overlap, n.x(), n.y(), n.z(), velocity.x(), velocity.y(),
                 velocity.z(), now.turn / now.time});
      now = {now.number, 0.0, Vec3::Zero(), 0.0};
    }
    now_.emplace(bodies, now);
  }
  /// When all contacts of the step have been entered.
  void end_step() {
    ++steps_;
    before_ = std::move(now_);
    now_.clear();
  }

  void write_csv(std::ostream& out) const { rows_.write_csv(out); }

 private:
  /// The motion of a contact since its last row.
  struct Unwritten {
    std::size_t number;
    double time;  ///< [s]
    Vec3 path;    ///< of body 2 relative to body 1 at the contact point [m]
    double turn;  ///< about the normal [rad]
  };

  int every_;
  int steps_ = 0;
  std::size_t next_number_ = 0;
  std::map<Pair, Unwritten> before_, now_;
  common::Table rows_{"contact", "dt", "overlap", "nx", "ny", "nz", "vx", "vy", "vz", "normal_spin"};
};

}  // namespace dem

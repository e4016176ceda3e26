// SPDX-License-Identifier: MIT
// How the contacts of a run move, written as bench/trade reads it (`trade --replay`): a row a contact and step.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "common/table.hpp"
#include "contactlaws/kinematics.hpp"
#include "neighbours.hpp"

namespace dem {

/// Gathers rows in memory, and writes them in the end. A contact that the law has forgotten is a new one when it is back.
class Recording {
 public:
  /// `every`: steps that a row spans, its velocity their mean. One, unless the file would grow too large.
  explicit Recording(int every = 1) : every_(every) {}

  /// Enters how a contact within its law's range moved over the step.
  void add(const Pair& bodies, const contactlaws::ContactKinematics<double>& motion) {
    const auto known = before_.find(bodies);
    Going now = known != before_.end() ? known->second : Going{next_number_++, 0.0, Vec3::Zero(), 0.0};
    now.time += motion.dt;
    now.way += motion.velocity * motion.dt;
    now.turn += motion.normal_spin * motion.dt;
    if ((steps_ + 1) % every_ == 0 && now.time > 0.0) {
      const Vec3 velocity = now.way / now.time;
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
  /// A contact since its last row.
  struct Going {
    std::size_t number;
    double time;  ///< [s]
    Vec3 way;     ///< of body 2 relative to body 1 at the contact point [m]
    double turn;  ///< about the normal [rad]
  };

  int every_;
  int steps_ = 0;
  std::size_t next_number_ = 0;
  std::map<Pair, Going> before_, now_;
  common::Table rows_{"contact", "dt", "overlap", "nx", "ny", "nz", "vx", "vy", "vz", "normal_spin"};
};

}  // namespace dem

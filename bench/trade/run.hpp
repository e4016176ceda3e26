// SPDX-License-Identifier: MIT
// A composition driven along trajectories. The same loop is timed and compared. Inside it the compiler knows the law; one
// virtual call runs many steps.
#pragma once

#include <cstddef>
#include <memory>

#include "composition.hpp"
#include "trajectories.hpp"

namespace trade {

class Run {
 public:
  virtual ~Run() = default;
  /// Sets all contacts to new: no history, and wet where the law starts wet.
  virtual void reset() = 0;
  /// Every contact, steps first .. last - 1.
  virtual void advance(std::size_t first, std::size_t last) = 0;
  /// On body 2, in a row that has been stepped [N].
  virtual Vec3<double> force(std::size_t row) const = 0;
  /// In springs and bridge of a contact in its present state, at this overlap [J].
  virtual double stored_energy(std::size_t contact, double overlap) const = 0;
  /// What a host stores for each contact.
  virtual std::size_t state_bytes() const = 0;
};

/// `trajectories` must outlive the run. Null for what is not offered (runs.hpp).
std::unique_ptr<Run> make_run(const Composition& composition, const Trajectories& trajectories);

}  // namespace trade

// SPDX-License-Identifier: MIT
// A composition put through a scene. The loop whose forces are judged is the loop that is timed: a law and its arguments are
// known to the compiler within it, and one virtual call leads into a whole stretch of steps.
#pragma once

#include <cstddef>
#include <memory>

#include "composition.hpp"
#include "scene.hpp"

namespace trade {

class Run {
 public:
  virtual ~Run() = default;
  /// Contacts as new: virgin, and wet where the law starts wet.
  virtual void reset() = 0;
  /// Steps every contact of the scene through the steps first .. last - 1.
  virtual void advance(std::size_t first, std::size_t last) = 0;
  /// On body 2, in a row that has been stepped [N].
  virtual Vec3<double> force(std::size_t row) const = 0;
  /// Of springs and bridge of a contact as it stands, at this overlap [J].
  virtual double stored_energy(std::size_t contact, double overlap) const = 0;
  /// What a host stores for each contact.
  virtual std::size_t state_bytes() const = 0;
};

/// The scene must outlive the run. Null for what is not offered: batches and pure float exist for laws with force history (or
/// none) that is not rotated, and with tension allowed; elsewhere they would say nothing new.
std::unique_ptr<Run> make_run(const Composition& composition, const Parameters& parameters, const Scene& scene);

}  // namespace trade

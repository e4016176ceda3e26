// SPDX-License-Identifier: MIT
// The benchmark's contacts as a host would keep them for batches: one array a quantity.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contactlaws/batch.hpp"
#include "contacts.hpp"

namespace bench {

/// Bytes that a batch moves per contact: what the law reads of pair and motion, state in and out, force and couple out.
template <class Law>
constexpr std::size_t bytes_per_contact() {
  constexpr std::size_t pair = 1 + (decltype(Law::damping)::acts ? 1 : 0) + (decltype(Law::bridge)::acts ? 1 : 0);
  constexpr std::size_t motion = decltype(Law::shear)::acts || decltype(Law::damping)::acts ? 7 : 4;
  constexpr std::size_t spin_and_couple = decltype(Law::rolling)::acts ? 6 : 0;
  return (pair + motion + 2 * Law::state_size + 3 + spin_and_couple) * sizeof(typename Law::Scalar);
}

template <class Law, class Array = std::vector<typename Law::Scalar>>
class ContactArrays {
 public:
  using T = typename Law::Scalar;

  explicit ContactArrays(const std::vector<Contact>& contacts) {
    const auto column = [&contacts](const auto& value_of) {
      Array values;
      values.reserve(contacts.size());
      for (const Contact& c : contacts) values.push_back(static_cast<T>(value_of(c)));
      return values;
    };
    radius_ = column([](const Contact& c) { return c.pair.effective_radius; });
    mass_ = column([](const Contact& c) { return c.pair.effective_mass; });
    smaller_radius_ = column([](const Contact& c) { return c.pair.min_radius; });
    length_ = column([](const Contact& c) { return c.pair.length; });
    overlap_ = column([](const Contact& c) { return c.there.overlap; });
    for (int axis = 0; axis < 3; ++axis) {
      there_.push_back(column([axis](const Contact& c) { return c.there.normal[axis]; }));
      back_.push_back(column([axis](const Contact& c) { return c.back.normal[axis]; }));
      velocity_.push_back(column([axis](const Contact& c) { return c.there.velocity[axis]; }));
      spin_.push_back(column([axis](const Contact& c) { return c.there.relative_spin[axis]; }));
      force_.emplace_back(contacts.size(), T(0));
      couple_.emplace_back(contacts.size(), T(0));
    }
    state_.assign(Law::state_size, Array(contacts.size(), T(0)));
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      std::array<T, Law::state_size> values;
      Law::store(first_state<Law>(contacts[c]), values.data());
      for (std::size_t i = 0; i < values.size(); ++i) state_[i][c] = values[i];
    }
    young_ = static_cast<T>(contacts.front().pair.effective_young);
    shear_ = static_cast<T>(contacts.front().pair.effective_shear);
    dt_ = static_cast<T>(contacts.front().there.dt);
  }

  /// All contacts. `forwards`, or back in time: what strains a shear spring in one pass releases it in the next.
  ContactBatch<Law> batch(bool forwards) {
    ContactBatch<Law> b;
    b.count = overlap_.size();
    b.pair = {radius_.data(), young_, shear_, mass_.data(), smaller_radius_.data(), length_.data()};
    b.overlap = overlap_.data();
    b.dt = forwards ? dt_ : -dt_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      b.normal[axis] = (forwards ? there_ : back_)[axis].data();
      b.velocity[axis] = velocity_[axis].data();
      b.relative_spin[axis] = spin_[axis].data();
      b.force[axis] = force_[axis].data();
      b.couple[axis] = couple_[axis].data();
    }
    for (std::size_t i = 0; i < Law::state_size; ++i) b.state[i] = b.next[i] = state_[i].data();
    return b;
  }

 private:
  Array radius_, mass_, smaller_radius_, length_, overlap_;
  std::vector<Array> there_, back_, velocity_, spin_, force_, couple_, state_;
  T young_, shear_, dt_;
};

}  // namespace bench

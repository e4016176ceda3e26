// SPDX-License-Identifier: MIT
// All contacts of a mix stepped once a call, forwards and back in turn: one at a time, or as a batch.
#pragma once

#include <cstddef>
#include <vector>

#include "contact_arrays.hpp"
#include "contactlaws/scalars/xsimd.hpp"

namespace bench {

/// One contact at a time, from an array of structures.
template <class Law>
class OneByOne {
  using T = typename Law::Scalar;
  struct Stored {
    PairProperties<T> pair;
    ContactKinematics<T> there;
    ContactKinematics<T> back;
    typename Law::State state;
    Vec3<T> force;
  };

 public:
  static constexpr std::size_t bytes_per_contact = sizeof(Stored);

  explicit OneByOne(const std::vector<Contact>& contacts) {
    for (const Contact& c : contacts)
      stored_.push_back(
          {c.pair.cast<T>(), c.there.cast<T>(), c.back.cast<T>(), first_state<Law>(c), Vec3<T>(T(0), T(0), T(0))});
  }
  void operator()(const Law& law) {
    const bool even = even_;
    for (Stored& s : stored_) {
      auto step = law.step(s.pair, even ? s.there : s.back, s.state);
      s.state = step.state;
      s.force = step.force;
    }
    even_ = !even;
  }

 private:
  std::vector<Stored> stored_;
  bool even_ = true;
};

/// As a batch, from arrays that start where a cache line does: a pack is loaded from one line.
template <class Law>
class Batched {
  using T = typename Law::Scalar;

 public:
  static constexpr std::size_t bytes_per_contact = bench::bytes_per_contact<Law>();

  explicit Batched(const std::vector<Contact>& contacts)
      : arrays_(contacts), forwards_(arrays_.batch(true)), backwards_(arrays_.batch(false)) {}

  template <class Pack = typename PackOf<T>::type>
  void step(const Law& law) {
    evaluate<Law, Pack>(law, even_ ? forwards_ : backwards_);
    even_ = !even_;
  }
  void operator()(const Law& law) { step(law); }

 private:
  ContactArrays<Law, std::vector<T, xsimd::aligned_allocator<T, 64>>> arrays_;
  ContactBatch<Law> forwards_, backwards_;
  bool even_ = true;
};

}  // namespace bench

// SPDX-License-Identifier: MIT
// Many contacts at once: the kernel of contact_law.hpp on SIMD packs, one contact a lane. Two ways to pass them:
//
//   evaluate(law, batch)                                        the host's arrays, one per quantity (ContactBatch)
//   evaluate(law, first, last, state, next, gather, scatter)    two functions of the host: gather() computes the kinematics of
//                                                               a pack from the host's bodies, scatter() stores its forces
//
// Nothing is allocated; arrays need no alignment and the count no multiple of the lanes. The result of a contact depends
// neither on its lane nor on its neighbours: the last contacts are stepped as one more pack, filled up with the last one.
// Packs come with scalars/xsimd.hpp; without it a pack has one lane. Batches give the bits of the scalar path where nothing
// is contracted to fused multiply-adds and the law has no power, exponential or sine; of an open contact next to a touching
// one the sign of a zero may differ.
#pragma once

#include <array>
#include <cstddef>

#include "contactlaws/contact_law.hpp"

namespace contactlaws {

/// The pack type of a number: the number itself, unless a header of scalars/ specialises it.
template <class T>
struct PackOf {
  using type = T;
};

/// One quantity of every contact: an array, or one number for all.
template <class T>
class Column {
 public:
  // NOLINTBEGIN: implicit. A number serves all contacts (0 is a number, not a null array); an array has one a contact.
  /// The same number for all contacts.
  CONTACTLAWS_HD Column(const T& same = T(0)) noexcept : array_(nullptr), same_(same) {}
  /// The same, so that 0 is a number and no null array.
  CONTACTLAWS_HD Column(int same) noexcept : Column(T(same)) {}
  /// One value a contact.
  CONTACTLAWS_HD Column(const T* array) noexcept : array_(array), same_(T(0)) {}
  // NOLINTEND

  CONTACTLAWS_HD const T* array() const noexcept { return array_; }  ///< null where one number serves all
  CONTACTLAWS_HD const T& same() const noexcept { return same_; }    ///< the number that serves all

 private:
  const T* array_;
  T same_;
};

/// Contacts of one law, as a structure of arrays. Quantities that the law does not read may be left out.
template <class Law>
struct ContactBatch {
  using T = typename Law::Scalar;

  std::size_t count = 0;                          ///< of contacts
  PairProperties<Column<T>> pair;                 ///< see PairProperties
  std::array<Column<T>, 3> normal;                ///< see ContactKinematics
  Column<T> overlap;                              ///< [m]
  std::array<Column<T>, 3> velocity;              ///< [m/s]
  Column<T> dt;                                   ///< [s]
  Column<T> normal_spin;                          ///< [rad/s]
  std::array<Column<T>, 3> relative_spin;         ///< [rad/s]; read where the law has a rolling slot
  std::array<const T*, Law::state_size> state{};  ///< before the step, in the order of Law::state_values()
  std::array<T*, Law::state_size> next{};         ///< after it; may be the same arrays
  std::array<T*, 3> force{};                      ///< on body 2 [N]
  std::array<T*, 3> couple{};                     ///< on body 2 [N m]; written where the law has a rolling slot
};

/// What a law needs of a contact, or of a pack of contacts.
template <class T>
struct ContactInput {
  PairProperties<T> pair;           ///< of the two bodies
  ContactKinematics<T> kinematics;  ///< over the step
};

/// The contacts of one pack: number `first` and those that follow it. `full`: every lane has a contact of its own; otherwise the
/// lanes from `count` on repeat the last contact.
template <class Pack, bool full>
class PackRange {
 public:
  using Traits = ScalarTraits<Pack>;
  using Lane = typename Traits::Lane;
  static constexpr std::size_t lanes = Traits::lanes;

  /// Contacts `first` to before `first + count`.
  CONTACTLAWS_HD PackRange(std::size_t first, std::size_t count) noexcept : first_(first), count_(count) {}

  /// The number of the contact in a lane.
  CONTACTLAWS_HD std::size_t operator[](std::size_t lane) const noexcept {
    return first_ + (full || lane < count_ ? lane : count_ - 1);
  }
  CONTACTLAWS_HD std::size_t first() const noexcept { return first_; }                 ///< number of the first contact
  CONTACTLAWS_HD std::size_t count() const noexcept { return full ? lanes : count_; }  ///< of contacts

  /// From and to an array with one value a contact.
  CONTACTLAWS_HD Pack load(const Lane* values) const noexcept {
    if constexpr (full) {
      return Traits::load(values + first_);
    } else {
      std::array<Lane, lanes> filled;
      for (std::size_t i = 0; i < lanes; ++i) filled[i] = values[(*this)[i]];
      return Traits::load(filled.data());
    }
  }
  /// To an array with one value a contact.
  CONTACTLAWS_HD void store(Lane* values, const Pack& x) const noexcept {
    if constexpr (full) {
      Traits::store(values + first_, x);
    } else {
      std::array<Lane, lanes> filled;
      Traits::store(filled.data(), x);
      for (std::size_t i = 0; i < count_; ++i) values[first_ + i] = filled[i];
    }
  }
  /// From a column.
  CONTACTLAWS_HD Pack load(const Column<Lane>& column) const noexcept {
    return column.array() != nullptr ? load(column.array()) : Pack(column.same());
  }

 private:
  std::size_t first_, count_;
};

namespace detail {

/// Calls step(range) for every pack of the contacts first .. last.
template <class Pack, class StepPack>
CONTACTLAWS_HD void for_each_pack(std::size_t first, std::size_t last, const StepPack& step) noexcept {
  constexpr std::size_t lanes = ScalarTraits<Pack>::lanes;
  for (; first + lanes <= last; first += lanes) step(PackRange<Pack, true>(first, lanes));
  if (first < last) step(PackRange<Pack, false>(first, last - first));
}

/// Steps the contacts of one pack.
template <class Law, class Pack, class Range, class Gather, class Scatter>
CONTACTLAWS_HD void step_pack(const typename Law::template Rebind<Pack>& law, const Range& range,
                              const std::array<const typename Law::Scalar*, Law::state_size>& state,
                              const std::array<typename Law::Scalar*, Law::state_size>& next, const Gather& gather,
                              const Scatter& scatter) noexcept {
  using PackLaw = typename Law::template Rebind<Pack>;
  const auto input = gather(range);
  std::array<Pack, Law::state_size> values{};
  for_each_index<Law::state_size>([&](std::size_t i) CONTACTLAWS_INLINE_LAMBDA { values[i] = range.load(state[i]); });
  const auto step = law.step(input.pair, input.kinematics, PackLaw::load(values.data()));
  PackLaw::store(step.state, values.data());
  for_each_index<Law::state_size>([&](std::size_t i) CONTACTLAWS_INLINE_LAMBDA { range.store(next[i], values[i]); });
  scatter(range, input, step);
}

/// What a pack of contacts reads of the arrays of a batch.
template <class Law, class Pack>
struct BatchGather {
  const ContactBatch<Law>& batch;

  template <class Range>
  CONTACTLAWS_HD ContactInput<Pack> operator()(const Range& range) const noexcept {
    const auto column = [&range](const auto& c) CONTACTLAWS_INLINE_LAMBDA { return range.load(c); };
    const auto vector = [&column](const auto& c)
                            CONTACTLAWS_INLINE_LAMBDA { return Vec3<Pack>(column(c[0]), column(c[1]), column(c[2])); };
    ContactInput<Pack> input{batch.pair.template map<Pack>(column),
                             {vector(batch.normal), column(batch.overlap), vector(batch.velocity), column(batch.dt),
                              column(batch.normal_spin)}};
    if constexpr (decltype(Law::rolling)::acts) input.kinematics.relative_spin = vector(batch.relative_spin);
    return input;
  }
};

/// What it writes there beside its state.
template <class Law>
struct BatchScatter {
  const ContactBatch<Law>& batch;

  template <class Range, class Input, class Step>
  CONTACTLAWS_HD void operator()(const Range& range, const Input&, const Step& step) const noexcept {
    for (int i = 0; i < 3; ++i) range.store(batch.force[std::size_t(i)], step.force[i]);
    if constexpr (decltype(Law::rolling)::acts)
      for (int i = 0; i < 3; ++i) range.store(batch.couple[std::size_t(i)], step.couple[i]);
  }
};

/// Steps a batch; law_of(range) returns the law on Pack.
template <class Law, class Pack, class LawOf>
CONTACTLAWS_HD void step_batch(const LawOf& law_of, const ContactBatch<Law>& batch) noexcept {
  const BatchGather<Law, Pack> gather{batch};
  const BatchScatter<Law> scatter{batch};
  for_each_pack<Pack>(0, batch.count, [&](const auto& range) CONTACTLAWS_INLINE_LAMBDA {
    step_pack<Law, Pack>(law_of(range), range, batch.state, batch.next, gather, scatter);
  });
}

}  // namespace detail

/// Steps every contact of the batch.
template <class Law, class Pack = typename PackOf<typename Law::Scalar>::type>
CONTACTLAWS_FLATTEN void evaluate(const Law& law, const ContactBatch<Law>& batch) noexcept {
  const auto pack_law = law.template cast<Pack>();
  detail::step_batch<Law, Pack>(
      [one_law = &pack_law](const auto&) -> const auto& { return *one_law; }, batch);
}

/// The same with parameters that may differ from contact to contact, as in `law.cast<Column<double>>()`: each a number for
/// all contacts or an array (of friction coefficients, say). Parameters in arrays are not checked.
template <class Law, class Pack = typename PackOf<typename Law::Scalar>::type>
CONTACTLAWS_FLATTEN void evaluate(const typename Law::template Rebind<Column<typename Law::Scalar>>& law,
                                  const ContactBatch<Law>& batch) noexcept {
  detail::step_batch<Law, Pack>(
      [&law](const auto& range) {
        return law.template cast<Pack>([&range](const auto& c) CONTACTLAWS_INLINE_LAMBDA { return range.load(c); });
      },
      batch);
}

/// Steps contacts first .. last - 1 of a host that keeps bodies instead of contact arrays. For each pack:
///
///   gather(range) -> input               a ContactInput<Pack>, or a type that adds members to it, from the host's bodies;
///                                        range[lane] is the number of the contact
///   scatter(range, input, step)          stores what the host needs of the Step<Pack, ...>; range.count() lanes count
///
/// Both take `const auto& range`, a PackRange. `state` and `next` as in ContactBatch, indexed by the number of the contact.
template <class Law, class Pack = typename PackOf<typename Law::Scalar>::type, class Gather, class Scatter>
CONTACTLAWS_FLATTEN void evaluate(const Law& law, std::size_t first, std::size_t last,
                                  const std::array<const typename Law::Scalar*, Law::state_size>& state,
                                  const std::array<typename Law::Scalar*, Law::state_size>& next, const Gather& gather,
                                  const Scatter& scatter) noexcept {
  const auto pack_law = law.template cast<Pack>();
  detail::for_each_pack<Pack>(first, last, [&](const auto& range) CONTACTLAWS_INLINE_LAMBDA {
    detail::step_pack<Law, Pack>(pack_law, range, state, next, gather, scatter);
  });
}

}  // namespace contactlaws

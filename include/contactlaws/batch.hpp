// SPDX-License-Identifier: MIT
// Many contacts at once: the host's own arrays, one a quantity, stepped by the very kernel of contact_law.hpp on packs.
//
// Nothing is copied or allocated; arrays need no alignment and the count no multiple. A quantity that is the same for all
// contacts (dt, often E*) is given as a number instead of an array. A contact's result depends neither on its lane nor on
// its neighbours: what is left over at the end is stepped as one more pack, filled up with the last contact.
// Packs come with adapt/xsimd.hpp; without it a pack is one lane wide.
#pragma once

#include <array>
#include <cstddef>

#include "contactlaws/contact_law.hpp"

namespace contactlaws {

/// The pack that serves a number: itself, until an adapter says otherwise.
template <class T>
struct PackOf {
  using type = T;
};

/// One quantity of every contact: an array of them, or one number for all.
template <class T>
class Column {
 public:
  Column(const T& same = T(0)) : array_(nullptr), same_(same) {}  // NOLINT: a number stands for a column of it
  Column(int same) : Column(T(same)) {}                           // NOLINT: a 0 is one, not a null array
  Column(const T* array) : array_(array), same_(T(0)) {}          // NOLINT: so does an array

  const T* array() const noexcept { return array_; }  ///< null where one number serves all
  const T& same() const noexcept { return same_; }

 private:
  const T* array_;
  T same_;
};

/// Contacts of one law, as a structure of arrays. What the law does not read may be left out.
template <class Law>
struct ContactBatch {
  using T = typename Law::Scalar;

  std::size_t count = 0;
  PairProperties<Column<T>> pair;                 ///< see PairProperties
  std::array<Column<T>, 3> normal;                ///< see ContactKinematics
  Column<T> overlap;                              ///< [m]
  std::array<Column<T>, 3> velocity;              ///< [m/s]
  Column<T> dt;                                   ///< [s]
  Column<T> normal_spin;                          ///< [rad/s]
  std::array<const T*, Law::state_size> state{};  ///< before the step, in the order of Law::state_values()
  std::array<T*, Law::state_size> next{};         ///< after it; may be the same arrays
  std::array<T*, 3> force{};                      ///< on body 2 [N]
};

namespace detail {

/// Contacts first .. first + lanes, stepped as one pack; `load` and `save` move a pack from and to an array, `law_of` tells
/// their law, given what reads a column.
template <class Pack, class Law, class LawOf, class Load, class Save>
CONTACTLAWS_HD void evaluate_pack(const LawOf& law_of, const ContactBatch<Law>& batch, const Load& load,
                                  const Save& save) noexcept {
  using PackLaw = typename Law::template Rebind<Pack>;
  const auto column = [&load](const Column<typename Law::Scalar>& c) {
    return c.array() != nullptr ? load(c.array()) : Pack(c.same());
  };
  const auto vector = [&column](const auto& c) { return Vec3<Pack>(column(c[0]), column(c[1]), column(c[2])); };
  const PairProperties<Pack> pair = batch.pair.template map<Pack>(column);
  const ContactKinematics<Pack> kinematics{vector(batch.normal), column(batch.overlap), vector(batch.velocity),
                                           column(batch.dt), column(batch.normal_spin)};
  std::array<Pack, Law::state_size> state{};
  for (std::size_t i = 0; i < Law::state_size; ++i) state[i] = load(batch.state[i]);
  const auto step = law_of(column).step(pair, kinematics, PackLaw::load(state.data()));
  PackLaw::store(step.state, state.data());
  for (std::size_t i = 0; i < Law::state_size; ++i) save(batch.next[i], state[i]);
  save(batch.force[0], step.force.x());
  save(batch.force[1], step.force.y());
  save(batch.force[2], step.force.z());
}

template <class Pack, class Law, class LawOf>
CONTACTLAWS_HD void evaluate_packs(const LawOf& law_of, const ContactBatch<Law>& batch) noexcept {
  using T = typename Law::Scalar;
  using Traits = ScalarTraits<Pack>;
  constexpr std::size_t lanes = Traits::lanes;
  std::size_t first = 0;
  for (; first + lanes <= batch.count; first += lanes)
    evaluate_pack<Pack>(
        law_of, batch, [first](const T* values) { return Traits::load(values + first); },
        [first](T* values, const Pack& x) { Traits::store(values + first, x); });
  if (first == batch.count) return;
  const std::size_t left = batch.count - first;
  evaluate_pack<Pack>(
      law_of, batch,
      [first, left](const T* values) {
        std::array<T, lanes> filled;
        for (std::size_t i = 0; i < lanes; ++i) filled[i] = values[first + (i < left ? i : left - 1)];
        return Traits::load(filled.data());
      },
      [first, left](T* values, const Pack& x) {
        std::array<T, lanes> filled;
        Traits::store(filled.data(), x);
        for (std::size_t i = 0; i < left; ++i) values[first + i] = filled[i];
      });
}

}  // namespace detail

/// Steps every contact of the batch.
template <class Law, class Pack = typename PackOf<typename Law::Scalar>::type>
CONTACTLAWS_FLATTEN void evaluate(const Law& law, const ContactBatch<Law>& batch) noexcept {
  const auto pack_law = law.template cast<Pack>();
  detail::evaluate_packs<Pack>(
      [&pack_law](const auto&) -> const auto& { return pack_law; }, batch);
}

/// The same under a law whose parameters are columns too, as in `law.cast<Column<double>>()`: each a number for all
/// contacts or an array of them (a friction per contact, say). Whoever fills the arrays checks them.
template <class Law, class Pack = typename PackOf<typename Law::Scalar>::type>
CONTACTLAWS_FLATTEN void evaluate(const typename Law::template Rebind<Column<typename Law::Scalar>>& law,
                                  const ContactBatch<Law>& batch) noexcept {
  detail::evaluate_packs<Pack>([&law](const auto& column) { return law.template cast<Pack>(column); }, batch);
}

}  // namespace contactlaws

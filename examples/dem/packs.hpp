// SPDX-License-Identifier: MIT
// Numbers of several contacts or bodies side by side, a lane each: what a law on packs is fed with. Without xsimd, or without
// a vector unit that it knows, a pack is one number and all of this still holds.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "contactlaws/batch.hpp"
#if __has_include(<xsimd/xsimd.hpp>)
#include "contactlaws/adapt/xsimd.hpp"
#endif

namespace dem {

/// As many numbers as the machine computes with at once.
using Pack = contactlaws::PackOf<double>::type;

template <class T>
constexpr std::size_t lanes = contactlaws::ScalarTraits<T>::lanes;

/// One quantity of every contact.
using Column = std::vector<double>;

template <class T>
CONTACTLAWS_HD T load(const Column& column, std::size_t first) {
  return contactlaws::ScalarTraits<T>::load(column.data() + first);
}
template <class T>
CONTACTLAWS_HD void store(Column& column, std::size_t first, const T& x) {
  contactlaws::ScalarTraits<T>::store(column.data() + first, x);
}

/// Which body each lane is about.
template <class T>
using Ids = std::array<std::size_t, lanes<T>>;

/// Lane l: entry ids[l].
template <class T>
CONTACTLAWS_HD T gather(const std::vector<double>& of, const Ids<T>& ids) {
  std::array<double, lanes<T>> values;
  for (std::size_t l = 0; l < lanes<T>; ++l) values[l] = of[ids[l]];
  return contactlaws::ScalarTraits<T>::load(values.data());
}
template <class T>
CONTACTLAWS_HD contactlaws::Vec3<T> gather(const std::vector<contactlaws::Vec3<double>>& of, const Ids<T>& ids) {
  std::array<double, lanes<T>> x, y, z;
  for (std::size_t l = 0; l < lanes<T>; ++l) {
    const contactlaws::Vec3<double>& v = of[ids[l]];
    x[l] = v.x();
    y[l] = v.y();
    z[l] = v.z();
  }
  using Traits = contactlaws::ScalarTraits<T>;
  return {Traits::load(x.data()), Traits::load(y.data()), Traits::load(z.data())};
}

}  // namespace dem

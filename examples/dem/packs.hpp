// SPDX-License-Identifier: MIT
// Numbers of several contacts or bodies side by side, a lane each: what a law on packs is fed with. Without xsimd, or without
// a vector unit that it knows, a pack is one number and all of this still holds.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>
#include <vector>

#include "contactlaws/batch.hpp"
#if __has_include(<xsimd/xsimd.hpp>)
#include "contactlaws/scalars/xsimd.hpp"
#endif

namespace dem {

using Vec3 = contactlaws::Vec3<double>;

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

/// A vector in space with a number more beside it: a row of four, which moves whole between memory and a register.
struct alignas(32) Row : Vec3 {
  double more = 0.0;

  Row() : Vec3(Vec3::Zero()) {}
  Row(const Vec3& vector) : Vec3(vector) {}  // NOLINT: a vector is a row
  using Vec3::operator=;                     // `more` stays

  auto four() { return Eigen::Map<Eigen::Vector4d, Eigen::Aligned32>(data()); }
  auto four() const { return Eigen::Map<const Eigen::Vector4d, Eigen::Aligned32>(data()); }
};
static_assert(sizeof(Row) == 4 * sizeof(double), "vector and number lie side by side");

/// A row in each lane.
template <class T>
struct Rows {
  contactlaws::Vec3<T> vector;
  T more;
};

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define DEM_HAS_SHUFFLES
#endif
#endif

#if defined(DEM_HAS_SHUFFLES)
/// Whether rows become packs, and packs rows, within registers: as far as a register holds one row or two.
template <class T>
constexpr bool in_registers = lanes<T> == 4 || lanes<T> == 8;

namespace detail {

using Four = double __attribute__((vector_size(32)));

/// Row l, and beside it row l + 4 where the register holds two.
template <class T, class RowOfLane>
CONTACTLAWS_HD auto load_rows(const RowOfLane& row, std::size_t l) {
  Four low, high;
  std::memcpy(&low, row(l).data(), sizeof(Row));
  if constexpr (lanes<T> == 4) {
    return low;
  } else {
    std::memcpy(&high, row(l + 4).data(), sizeof(Row));
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
}
/// The other way: to rows[l], and rows[l + 4].
template <class T, class Register>
CONTACTLAWS_HD void store_rows(Row* rows, std::size_t l, const Register& from) {
  const Four low = __builtin_shufflevector(from, from, 0, 1, 2, 3);
  std::memcpy(rows[l].data(), &low, sizeof(Row));
  if constexpr (lanes<T> == 8) {
    const Four high = __builtin_shufflevector(from, from, 4, 5, 6, 7);
    std::memcpy(rows[l + 4].data(), &high, sizeof(Row));
  }
}

/// Exchanges the blocks of `step` lanes that lie off the diagonal of two rows: a0 a1, b0 b1 become a0 b0, a1 b1.
template <std::size_t step, class Register, std::size_t... l>
CONTACTLAWS_HD void exchange(Register& a, Register& b, std::index_sequence<l...>) {
  constexpr std::size_t count = sizeof...(l);
  const Register low = __builtin_shufflevector(a, b, (l & step ? count + l - step : l)...);
  b = __builtin_shufflevector(a, b, (l & step ? count + l : l + step)...);
  a = low;
}
/// Makes columns of rows, and rows of columns, in each four lanes.
template <class T, class Register>
CONTACTLAWS_HD void transpose(Register& a, Register& b, Register& c, Register& d) {
  constexpr std::make_index_sequence<lanes<T>> all;
  exchange<2>(a, c, all);
  exchange<2>(b, d, all);
  exchange<1>(a, b, all);
  exchange<1>(c, d, all);
}

}  // namespace detail
#else
template <class T>
constexpr bool in_registers = false;
#endif

/// Lane l: rows[ids[l]].
template <class T>
CONTACTLAWS_HD Rows<T> gather(const std::vector<Row>& rows, const Ids<T>& ids) {
  if constexpr (in_registers<T>) {
    using Register = decltype(T::data);
    const auto row = [&](std::size_t l) -> const Row& { return rows[ids[l]]; };
    auto a = detail::load_rows<T>(row, 0), b = detail::load_rows<T>(row, 1), c = detail::load_rows<T>(row, 2),
         d = detail::load_rows<T>(row, 3);
    detail::transpose<T>(a, b, c, d);
    return {{T(Register(a)), T(Register(b)), T(Register(c))}, T(Register(d))};
  } else {
    std::array<std::array<double, lanes<T>>, 4> columns;
    for (std::size_t l = 0; l < lanes<T>; ++l)
      for (std::size_t i = 0; i < 4; ++i) columns[i][l] = rows[ids[l]].data()[i];
    const auto column = [&](std::size_t i) { return contactlaws::ScalarTraits<T>::load(columns[i].data()); };
    return {{column(0), column(1), column(2)}, column(3)};
  }
}

/// To rows[first + l]: lane l.
template <class T>
CONTACTLAWS_HD void store(std::vector<Row>& rows, std::size_t first, const Rows<T>& x) {
  if constexpr (in_registers<T>) {
    auto a = x.vector.x().data, b = x.vector.y().data, c = x.vector.z().data, d = x.more.data;
    detail::transpose<T>(a, b, c, d);
    detail::store_rows<T>(rows.data() + first, 0, a);
    detail::store_rows<T>(rows.data() + first, 1, b);
    detail::store_rows<T>(rows.data() + first, 2, c);
    detail::store_rows<T>(rows.data() + first, 3, d);
  } else {
    std::array<std::array<double, lanes<T>>, 4> columns;
    const auto put = [&](std::size_t i, const T& t) { contactlaws::ScalarTraits<T>::store(columns[i].data(), t); };
    put(0, x.vector.x());
    put(1, x.vector.y());
    put(2, x.vector.z());
    put(3, x.more);
    for (std::size_t l = 0; l < lanes<T>; ++l)
      for (std::size_t i = 0; i < 4; ++i) rows[first + l].data()[i] = columns[i][l];
  }
}

}  // namespace dem

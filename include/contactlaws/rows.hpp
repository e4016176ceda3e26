// SPDX-License-Identifier: MIT
// Rows of four doubles (a vector and one number more) to packs and back: lane l of four packs is row ids[l]. A host whose
// bodies are such rows gathers a pack of contacts with it. Where a register holds one row or two, rows are loaded whole and
// transposed in registers, which takes a third of the time of single loads (g++ 12, AVX2 and AVX-512).
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "contactlaws/core/scalar.hpp"

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define CONTACTLAWS_HAS_SHUFFLES
#endif
#endif

namespace contactlaws {

/// One index per lane of Pack.
template <class Pack>
using Ids = std::array<std::size_t, ScalarTraits<Pack>::lanes>;

namespace detail {

constexpr std::size_t row_bytes = 4 * sizeof(double);

#if defined(CONTACTLAWS_HAS_SHUFFLES)
template <class Pack>
constexpr bool transposes_rows = ScalarTraits<Pack>::lanes == 4 || ScalarTraits<Pack>::lanes == 8;

using Row = double __attribute__((vector_size(row_bytes)));

/// Row l, beside it row l + 4 where the register holds two.
template <class Pack, class RowOfLane>
CONTACTLAWS_HD auto load_rows(const RowOfLane& row, std::size_t l) {
  Row low, high;
  std::memcpy(&low, row(l), row_bytes);
  if constexpr (ScalarTraits<Pack>::lanes == 4) {
    return low;
  } else {
    std::memcpy(&high, row(l + 4), row_bytes);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
}
template <class Pack, class Register>
CONTACTLAWS_HD void store_rows(double* rows, std::size_t l, const Register& from) {
  const Row low = __builtin_shufflevector(from, from, 0, 1, 2, 3);
  std::memcpy(rows + 4 * l, &low, row_bytes);
  if constexpr (ScalarTraits<Pack>::lanes == 8) {
    const Row high = __builtin_shufflevector(from, from, 4, 5, 6, 7);
    std::memcpy(rows + 4 * (l + 4), &high, row_bytes);
  }
}

/// Exchanges the blocks of `step` lanes off the diagonal of two rows: a0 a1, b0 b1 become a0 b0, a1 b1.
template <std::size_t step, class Register, std::size_t... l>
CONTACTLAWS_HD void exchange(Register& a, Register& b, std::index_sequence<l...>) {
  constexpr std::size_t count = sizeof...(l);
  const Register low = __builtin_shufflevector(a, b, (l & step ? count + l - step : l)...);
  b = __builtin_shufflevector(a, b, (l & step ? count + l : l + step)...);
  a = low;
}
/// Transposes each block of four lanes.
template <class Pack, class Register>
CONTACTLAWS_HD void transpose(Register& a, Register& b, Register& c, Register& d) {
  constexpr std::make_index_sequence<ScalarTraits<Pack>::lanes> all;
  exchange<2>(a, c, all);
  exchange<2>(b, d, all);
  exchange<1>(a, b, all);
  exchange<1>(c, d, all);
}
#else
template <class Pack>
constexpr bool transposes_rows = false;
#endif

}  // namespace detail

/// Lane l of the four packs: the row at rows + 4 ids[l].
template <class Pack>
CONTACTLAWS_HD std::array<Pack, 4> gather_rows(const double* rows, const Ids<Pack>& ids) {
  if constexpr (detail::transposes_rows<Pack>) {
    using Register = decltype(Pack::data);
    const auto row = [&](std::size_t l) { return rows + 4 * ids[l]; };
    auto a = detail::load_rows<Pack>(row, 0), b = detail::load_rows<Pack>(row, 1), c = detail::load_rows<Pack>(row, 2),
         d = detail::load_rows<Pack>(row, 3);
    detail::transpose<Pack>(a, b, c, d);
    return {Pack(Register(a)), Pack(Register(b)), Pack(Register(c)), Pack(Register(d))};
  } else {
    constexpr std::size_t lanes = ScalarTraits<Pack>::lanes;
    std::array<std::array<double, lanes>, 4> columns;
    for (std::size_t l = 0; l < lanes; ++l)
      for (std::size_t i = 0; i < 4; ++i) columns[i][l] = rows[4 * ids[l] + i];
    const auto pack = [&](std::size_t i) { return ScalarTraits<Pack>::load(columns[i].data()); };
    return {pack(0), pack(1), pack(2), pack(3)};
  }
}

/// Writes lane l of the four packs to the row at rows + 4 l.
template <class Pack>
CONTACTLAWS_HD void store_rows(double* rows, const std::array<Pack, 4>& x) {
  if constexpr (detail::transposes_rows<Pack>) {
    auto a = x[0].data, b = x[1].data, c = x[2].data, d = x[3].data;
    detail::transpose<Pack>(a, b, c, d);
    detail::store_rows<Pack>(rows, 0, a);
    detail::store_rows<Pack>(rows, 1, b);
    detail::store_rows<Pack>(rows, 2, c);
    detail::store_rows<Pack>(rows, 3, d);
  } else {
    constexpr std::size_t lanes = ScalarTraits<Pack>::lanes;
    std::array<std::array<double, lanes>, 4> columns;
    for (std::size_t i = 0; i < 4; ++i) ScalarTraits<Pack>::store(columns[i].data(), x[i]);
    for (std::size_t l = 0; l < lanes; ++l)
      for (std::size_t i = 0; i < 4; ++i) rows[4 * l + i] = columns[i][l];
  }
}

}  // namespace contactlaws

// SPDX-License-Identifier: MIT
// Packs of numbers: any kernel on xsimd::batch<double> or <float>, one contact a lane.
#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>

#include <xsimd/xsimd.hpp>

#include "contactlaws/batch.hpp"
#include "contactlaws/core/power.hpp"

namespace contactlaws {
template <class L, class A>
struct VectorOf<xsimd::batch<L, A>> {
  using type = PlainVec3<xsimd::batch<L, A>>;
};

template <class L, class A>
struct ScalarTraits<xsimd::batch<L, A>> {
  using Pack = xsimd::batch<L, A>;
  using Mask = xsimd::batch_bool<L, A>;
  using Lane = L;
  static constexpr std::size_t lanes = Pack::size;

  static Pack select(const Mask& condition, const Pack& yes, const Pack& no) noexcept {
    return xsimd::select(condition, yes, no);
  }
  static bool any(const Mask& condition) noexcept { return xsimd::any(condition); }
  static bool all(const Mask& condition) noexcept { return xsimd::all(condition); }
  static Mask negate(const Mask& condition) noexcept { return ~condition; }  // GCC does not always inline xsimd's `!`
  static Pack load(const L* values) noexcept { return Pack::load_unaligned(values); }
  static void store(L* values, const Pack& x) noexcept { x.store_unaligned(values); }
};

template <class L, class A>
struct BinaryDigits<xsimd::batch<L, A>> {
  using Pack = xsimd::batch<L, A>;
  static constexpr bool known = true;
  using Bits = xsimd::batch<std::conditional_t<sizeof(L) == 8, std::uint64_t, std::uint32_t>, A>;

  static Bits bits(const Pack& x) noexcept { return reinterpreted<Bits>(x); }
  static Pack number(const Bits& bits) noexcept { return reinterpreted<Pack>(bits); }
  static Pack nearest(const Pack& x) noexcept { return xsimd::nearbyint(x); }

 private:
  /// xsimd's bitwise_cast takes the type of a batch in version 8, and that of its lanes in version 13.
  template <class To, class From>
  static To reinterpreted(const From& from) noexcept {
    static_assert(sizeof(To) == sizeof(From));
    To to;
    std::memcpy(static_cast<void*>(&to), &from, sizeof(To));
    return to;
  }
};

template <>
struct PackOf<double> {
  using type = xsimd::batch<double>;
};
template <>
struct PackOf<float> {
  using type = xsimd::batch<float>;
};
}  // namespace contactlaws

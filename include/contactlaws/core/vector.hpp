// SPDX-License-Identifier: MIT
// The vector type of a scalar: Eigen's; of packs, and with CONTACTLAWS_NO_EIGEN of every scalar, a small class. That class
// needs no Eigen, compiles faster, is fast without optimisation too, and is inlined where GCC inlines Eigen's expressions of
// packs only in part. Forces have the same bits with both where nothing is contracted to fused multiply-adds.
// Define CONTACTLAWS_NO_EIGEN for every file of a program, or for none.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "contactlaws/core/config.hpp"

#if !defined(CONTACTLAWS_NO_EIGEN)
#include <Eigen/Core>
#include <Eigen/Geometry>  // cross
#endif

namespace contactlaws {

/// A vector in space. It converts from and to other vectors of T that have x(), y() and z(), Eigen's among them.
template <class T>
class PlainVec3 {
  template <class V>
  using Component = std::decay_t<decltype(std::declval<const V&>().x(), std::declval<const V&>().z())>;
  template <class V>
  using IfVector = std::enable_if_t<std::is_same_v<Component<V>, T>, int>;

 public:
  using Scalar = T;

  PlainVec3() = default;
  CONTACTLAWS_HD PlainVec3(const T& x, const T& y, const T& z) noexcept : value{x, y, z} {}
  template <class V, IfVector<V> = 0>
  CONTACTLAWS_HD PlainVec3(const V& v) noexcept : value{v.x(), v.y(), v.z()} {}  // NOLINT: implicit
  template <class V, IfVector<V> = 0>
  CONTACTLAWS_HD operator V() const noexcept {  // NOLINT: implicit
    return V(x(), y(), z());
  }

  CONTACTLAWS_HD const T& x() const noexcept { return value[0]; }
  CONTACTLAWS_HD const T& y() const noexcept { return value[1]; }
  CONTACTLAWS_HD const T& z() const noexcept { return value[2]; }
  CONTACTLAWS_HD const T& operator[](std::ptrdiff_t i) const noexcept { return value[i]; }
  CONTACTLAWS_HD T& operator[](std::ptrdiff_t i) noexcept { return value[i]; }

  CONTACTLAWS_HD PlainVec3 operator-() const noexcept { return {-x(), -y(), -z()}; }
  CONTACTLAWS_HD PlainVec3& operator+=(const PlainVec3& v) noexcept { return *this = *this + v; }
  CONTACTLAWS_HD PlainVec3& operator-=(const PlainVec3& v) noexcept { return *this = *this - v; }
  CONTACTLAWS_HD PlainVec3& operator*=(const T& s) noexcept { return *this = *this * s; }
  CONTACTLAWS_HD friend PlainVec3 operator+(const PlainVec3& a, const PlainVec3& b) noexcept {
    return {a.x() + b.x(), a.y() + b.y(), a.z() + b.z()};
  }
  CONTACTLAWS_HD friend PlainVec3 operator-(const PlainVec3& a, const PlainVec3& b) noexcept {
    return {a.x() - b.x(), a.y() - b.y(), a.z() - b.z()};
  }
  CONTACTLAWS_HD friend PlainVec3 operator*(const PlainVec3& v, const T& s) noexcept {
    return {v.x() * s, v.y() * s, v.z() * s};
  }
  CONTACTLAWS_HD friend PlainVec3 operator*(const T& s, const PlainVec3& v) noexcept { return v * s; }
  CONTACTLAWS_HD friend PlainVec3 operator/(const PlainVec3& v, const T& s) noexcept {
    return {v.x() / s, v.y() / s, v.z() / s};
  }
  CONTACTLAWS_HD PlainVec3 cross(const PlainVec3& v) const noexcept {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }

 private:
  T value[3];
};

/// The vector type of a scalar; packs specialise it (scalars/xsimd.hpp).
template <class T>
struct VectorOf {
#if defined(CONTACTLAWS_NO_EIGEN)
  using type = PlainVec3<T>;
#else
  using type = Eigen::Matrix<T, 3, 1>;
#endif
};

/// A vector in space.
template <class T>
using Vec3 = typename VectorOf<T>::type;

}  // namespace contactlaws

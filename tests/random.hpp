// Random inputs, the same on every machine, and the pair of grains that the hill memo computes with.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "contactlaws/kinematics.hpp"
#include "contactlaws/pair.hpp"

namespace contactlaws::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

/// How many random cases to try: sanitizers look for other things than rare digits, and are slow.
constexpr int cases(int wanted) { return sanitized ? (wanted + 19) / 20 : wanted; }

/// The standard fixes the engine's numbers but not its distributions', so these are our own. Draw one number a statement:
/// compilers evaluate the arguments of a call, and the sides of an operator, in different orders.
struct Random {
  std::mt19937_64 engine;

  explicit Random(std::uint64_t seed = 20190501) : engine(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine() >> 11), -53);
  }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  /// An integer of [low, high].
  int integer(int low, int high) { return low + static_cast<int>(engine() % static_cast<unsigned>(high - low + 1)); }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }

  /// Log-uniform from 2^low to 2^(high+1), denormal where the exponent says so; one in eight at the edge of a binade.
  template <class T>
  T binary(int low, int high) {
    const int exponent = integer(low, high);
    T mantissa = T(1) + std::ldexp(static_cast<T>(engine() >> 11), -53);
    const auto edge = engine() % 16;
    if (edge == 0) mantissa = T(1);
    if (edge == 1) mantissa = T(2) - std::numeric_limits<T>::epsilon();
    return std::ldexp(mantissa, exponent);
  }

  Vec3<double> direction() {
    for (;;) {
      const double x = uniform(-1, 1);
      const double y = uniform(-1, 1);
      const double z = uniform(-1, 1);
      const Vec3<double> v(x, y, z);
      const double square = v.squaredNorm();
      if (square > 0.01 && square < 1.0) return v / std::sqrt(square);
    }
  }
  Vec3<double> direction_across(const Vec3<double>& normal) {
    for (;;) {
      const Vec3<double> v = direction().cross(normal);
      if (v.squaredNorm() > 0.01) return v.normalized();
    }
  }
};

/// Two grains of granite, 7.5 mm and 5 mm (Potyondy 2019, Sec. 2), neither counted as fixed.
template <class T>
PairProperties<T> granite_pair() {
  const ElasticMaterial<T> granite{T(29) * T(1e9), T(15) / T(100), T(2650)};
  return pair_properties(sphere(granite, T(T(75) / T(10000))), sphere(granite, T(T(5) / T(1000))));
}

/// A pair of grains from a micrometre to a metre, from gel to steel.
inline PairProperties<double> random_pair(Random& random) {
  const auto side = [&random] {
    const double young = random.log_uniform(1e5, 4e11);
    const double poisson = random.uniform(-0.5, 0.5);
    const double density = random.log_uniform(500.0, 20000.0);
    return sphere(ElasticMaterial<double>{young, poisson, density}, random.log_uniform(1e-6, 1.0));
  };
  const auto first = side();
  const auto second = side();
  return pair_properties(first, second);
}

/// Properties that no pair has, for tests of accuracy: each log-uniform over many binades.
template <class T>
PairProperties<T> wide_pair(Random& random) {
  const T radius = random.binary<T>(-30, 8);
  const T young = random.binary<T>(10, 40);
  const T shear = random.binary<T>(10, 40);
  const T mass = random.binary<T>(-60, 20);
  const T min_radius = random.binary<T>(-30, 8);
  return {radius, young, shear, mass, min_radius, min_radius * random.binary<T>(0, 6)};
}

/// log2 of the smallest number of T.
template <class T>
constexpr int smallest_exponent = std::numeric_limits<T>::min_exponent - std::numeric_limits<T>::digits;

}  // namespace contactlaws::test

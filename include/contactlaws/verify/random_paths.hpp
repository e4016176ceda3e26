// SPDX-License-Identifier: MIT
// Random motion, the same on every machine for the same seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "contactlaws/verify/path.hpp"

namespace contactlaws::verify {

/// The standard fixes the engine's numbers but not its distributions', so these are our own.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  double log_uniform(double low, double high) {
    using std::exp;
    using std::log;
    return exp(uniform(log(low), log(high)));
  }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  Vector direction() {
    for (;;) {
      const double x = uniform(-1, 1), y = uniform(-1, 1),
                   z = uniform(-1, 1);  // one after the other, on every compiler
      const Vector v(x, y, z);
      const double square = v.squaredNorm();
      if (square > 0.01 && square < 1.0) return v.normalized();
    }
  }
  Vector direction_across(const Vector& normal) {
    for (;;) {
      const Vector v = across(direction(), normal);
      if (v.squaredNorm() > 0.01) return v.normalized();
    }
  }
  Rotation rotation() {
    const Vector a = direction(), b = direction_across(a);
    Rotation r;
    r << a, b, a.cross(b);
    return r;
  }

 private:
  std::mt19937_64 engine_;
};

/// What the law's own force makes natural.
struct Scales {
  double overlap;  ///< the largest that is usual [m]
  double force;    ///< at that overlap [N]
  double time;     ///< sqrt(m* overlap / force): a third of an impact, about [s]

  double speed() const { return overlap / time; }  ///< of an impact that gets about so deep [m/s]
};

/// The normal turns and twists, the overlap wanders, the bodies stick and slip, and now and then part by a hair.
inline Path random_path(Random& random, const Scales& scales) {
  constexpr int length = 20;
  Path path;
  Vector normal = random.direction();
  const double dt = scales.time * random.log_uniform(0.01, 0.3);
  for (int i = 0; i < length; ++i) {
    const double turn = random.uniform(0.0, 0.05);
    normal = (normal + turn * random.direction()).normalized();
    const double share = random.chance(0.05) ? random.uniform(-0.5, 0.0) : random.uniform(0.2, 1.0);
    const double slip = scales.overlap * random.log_uniform(1e-3, 0.3);
    const Vector velocity = slip / dt * random.direction_across(normal);
    path.push_back({normal, scales.overlap * share, velocity, dt, random.uniform(-0.05, 0.05) / dt});
  }
  settle(path);
  return path;
}

}  // namespace contactlaws::verify

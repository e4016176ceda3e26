// SPDX-License-Identifier: MIT
// Random motion, the same on every machine for the same seed.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "contactlaws/verify/path.hpp"

namespace contactlaws::verify {

/// The standard fixes the engine's numbers but not its distributions', so these are our own.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine(seed) {}
  /// A sequence for each name, so that the paths of one property do not depend on those of another (FNV-1a).
  Random(std::uint64_t seed, const std::string& name)
      : engine([&] {
          for (const char c : name) seed = (seed ^ static_cast<unsigned char>(c)) * 0x100000001b3;
          return seed;
        }()) {}

  double uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(engine() >> 11), -53);
  }
  double log_uniform(double low, double high) {
    using std::exp;
    using std::log;
    return exp(uniform(log(low), log(high)));
  }
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  Vector direction() {
    for (;;) {
      const double x = uniform(-1, 1);
      const double y = uniform(-1, 1);
      const double z = uniform(-1, 1);
      const Vector v(x, y, z);
      const double square = v.squaredNorm();
      if (square > 0.01 && square < 1.0) return v.normalized();
    }
  }
  Vector direction_across(const Vector& normal) {
    for (;;) {
      const Vector v = tangential(direction(), normal);
      if (v.squaredNorm() > 0.01) return v.normalized();
    }
  }
  Rotation rotation() {
    const Vector axis = direction();
    return rotation_about(axis, uniform(0.0, 2 * pi<double>()));
  }

 private:
  std::mt19937_64 engine;
};

/// Sizes that follow from the law's own force at the usual overlap.
struct Scales {
  double overlap;   ///< the largest usual one [m]
  double length;    ///< R1 + R2 [m]
  double force;     ///< at that overlap [N]
  double time;      ///< sqrt(m* overlap / force): about a third of an impact [s]
  double rounding;  ///< that a force may show, relative to the largest along a path [1]

  double speed() const { return overlap / time; }  ///< of an impact that gets about so deep [m/s]
};

/// The normal turns and twists, the overlap wanders, the bodies stick, slip and roll, and at times part by a hair.
inline Path random_path(Random& random, const Scales& scales) {
  constexpr int length = 20;
  Path path;
  Vector normal = random.direction();
  const double dt = scales.time * random.log_uniform(0.01, 0.3);
  for (int i = 0; i < length; ++i) {
    const double turn = random.uniform(0.0, 0.05);
    normal = (normal + turn * random.direction()).normalized();
    const bool open = random.chance(0.05);
    const double share = open ? random.uniform(-0.5, 0.0) : random.uniform(0.2, 1.0);
    const double slip = scales.overlap * random.log_uniform(1e-3, 0.3);
    const Vector velocity = slip / dt * random.direction_across(normal);
    const double twist = random.uniform(-0.05, 0.05);
    const double roll = scales.overlap / scales.length * random.log_uniform(1e-3, 1.0);
    path.push_back({normal, scales.overlap * share, velocity, dt, twist / dt, Vector(roll / dt * random.direction())});
  }
  set_normal_velocities(path);
  return path;
}

}  // namespace contactlaws::verify

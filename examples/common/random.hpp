// SPDX-License-Identifier: MIT
// Random numbers that are the same with every compiler and standard library, whose distributions are not.
#pragma once

#include <cstdint>
#include <random>

namespace common {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace common

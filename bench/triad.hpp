// SPDX-License-Identifier: MIT
// STREAM's triad (McCalpin 1995), the yardstick of memory: a = b + s c, on arrays that no cache holds.
#pragma once

#include <cstddef>
#include <vector>

namespace bench {

class Triad {
 public:
  static constexpr std::size_t count = 20'000'000;
  static constexpr std::size_t bytes = 3 * sizeof(double);  ///< of each of them, as STREAM counts

  void operator()() {
    for (std::size_t i = 0; i < count; ++i) a_[i] = b_[i] + 3.0 * c_[i];
  }

 private:
  std::vector<double> a_ = std::vector<double>(count, 0.0), b_ = std::vector<double>(count, 1.0),
                      c_ = std::vector<double>(count, 2.0);
};

}  // namespace bench

// SPDX-License-Identifier: MIT
// Divides work evenly among threads.
#pragma once

#include <cstddef>
#include <thread>
#include <vector>

namespace dem {

/// Calls work(first, last) on shares of 0 .. count, one per thread, each starting at a multiple of `grain`; returns when all are
/// done. Entries must be independent of each other, and the work must not throw.
template <class Work>
void in_parallel(int threads, std::size_t count, std::size_t grain, const Work& work) {
  const auto shares = static_cast<std::size_t>(threads);
  const std::size_t grains = (count + grain - 1) / grain;
  const auto start = [&](std::size_t share) { return share == shares ? count : grains * share / shares * grain; };
  std::vector<std::thread> others;
  for (std::size_t share = 1; share < shares; ++share)
    others.emplace_back([&work, first = start(share), last = start(share + 1)] { work(first, last); });
  work(start(0), start(1));
  for (std::thread& other : others) other.join();
}

}  // namespace dem

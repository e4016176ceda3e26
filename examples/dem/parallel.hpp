// SPDX-License-Identifier: MIT
// Divides work evenly among threads.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dem {

/// Threads that stay, and wait for work: to start a thread takes longer than a thousand contacts.
class Team {
 public:
  Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team() { resize(0); }

  /// Calls work(member) for members 1 to `others`, each on a thread of its own, and work(0) here; returns when all are done.
  template <class Work>
  void run(std::size_t others, const Work& work) {
    if (others != threads_.size()) resize(others);
    work_ = std::cref(work);
    working_ = others;
    order();
    work(std::size_t(0));
    while (working_ > 0) std::this_thread::yield();
  }

 private:
  std::vector<std::thread> threads_;
  std::function<void(std::size_t)> work_;  ///< none: the threads end
  std::atomic<std::size_t> working_{0};    ///< threads that are not done yet
  std::atomic<unsigned> orders_{0};        ///< given so far
  std::mutex mutex_;
  std::condition_variable ordered_;

  void order() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++orders_;
    }
    ordered_.notify_all();
  }
  void resize(std::size_t others) {
    work_ = nullptr;
    order();
    for (std::thread& thread : threads_) thread.join();
    threads_.clear();
    for (std::size_t member = 1; member <= others; ++member)
      threads_.emplace_back([this, member, done = orders_.load()] { obey(member, done); });
  }
  void obey(std::size_t member, unsigned done) {
    while (true) {
      // Orders of one step follow each other within microseconds; a thread that sleeps takes tens of them to wake.
      for (int i = 0; i < 2000 && orders_ == done; ++i) std::this_thread::yield();
      if (orders_ == done) {
        std::unique_lock<std::mutex> lock(mutex_);
        ordered_.wait(lock, [&] { return orders_ != done; });
      }
      ++done;
      if (!work_) return;
      work_(member);
      --working_;
    }
  }
};

/// Calls work(first, last) on shares of 0 .. count, one per thread, each starting at a multiple of `grain`; returns when all are
/// done. Entries must be independent of each other, and the work must not throw.
template <class Work>
void in_parallel(int threads, std::size_t count, std::size_t grain, const Work& work) {
  if (threads == 1) return work(std::size_t(0), count);
  const auto shares = static_cast<std::size_t>(threads);
  const std::size_t grains = (count + grain - 1) / grain;
  const auto start = [&](std::size_t share) { return share == shares ? count : grains * share / shares * grain; };
  thread_local Team team;  // of this thread: several may step scenes of their own
  team.run(shares - 1, [&](std::size_t share) { work(start(share), start(share + 1)); });
}

}  // namespace dem

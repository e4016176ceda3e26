// SPDX-License-Identifier: MIT
// Progress of a long run: a bar on a terminal, a line now and then in a log. Ctrl-C requests a stop after the current step.
#pragma once

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace common {

/// A bar: `what [#####     ]  50 %, 12 s left`, on the standard error stream. Results go to the standard output.
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (terminal_ && shown_) std::fputc('\n', stderr);
  }

  /// `done` is the finished share of the work, 0 to 1. Cheap enough to call at every step.
  void at(double done) {
    const auto now = std::chrono::steady_clock::now();
    if (shown_ && done < 1.0 && now - last_ < (terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(20)))
      return;
    if (!terminal_ && done <= last_done_) return;
    last_ = now;
    last_done_ = done;
    shown_ = true;
    const int percent = static_cast<int>(100.0 * std::clamp(done, 0.0, 1.0));
    if (first_done_ < 0.0) first_done_ = done;
    if (terminal_) {
      const std::string bar(static_cast<std::size_t>(percent / 4), '#');
      std::fprintf(stderr, "\r%s [%-25s] %3d %%%-20s", what_.c_str(), bar.c_str(), percent, left(now, done).c_str());
    } else {
      std::fprintf(stderr, "%s: %d %%%s\n", what_.c_str(), percent, left(now, done).c_str());
    }
    std::fflush(stderr);
  }

 private:
  /// ", 2 min left": as long again as the share done so far took. Empty in the first seconds.
  std::string left(std::chrono::steady_clock::time_point now, double done) const {
    const double taken = std::chrono::duration<double>(now - start_).count();
    if (taken < 3.0 || done <= first_done_ || done >= 1.0) return "";
    const double seconds = taken * (1.0 - done) / (done - first_done_);
    char text[32];
    if (seconds < 100.0)
      std::snprintf(text, sizeof text, ", %.0f s left", seconds);
    else
      std::snprintf(text, sizeof text, ", %.0f min left", seconds / 60.0);
    return text;
  }

  std::string what_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_{};
  double first_done_ = -1.0;  ///< more than 0 where an earlier run left a checkpoint
  double last_done_ = -1.0;
  bool shown_ = false;
#if __has_include(<unistd.h>)
  bool terminal_ = isatty(STDERR_FILENO) != 0;
#else
  bool terminal_ = false;
#endif
};

namespace detail {
inline volatile std::sig_atomic_t stop_signal = 0;
extern "C" inline void on_stop_signal(int signal) {
  stop_signal = signal;
  std::signal(signal, SIG_DFL);  // a second signal ends the program at once
}
}  // namespace detail

/// While an object of this class lives, SIGINT (Ctrl-C) and SIGTERM only set stop_requested().
class InterruptGuard {
 public:
  InterruptGuard()
      : on_interrupt_(std::signal(SIGINT, detail::on_stop_signal)),
        on_terminate_(std::signal(SIGTERM, detail::on_stop_signal)) {
    detail::stop_signal = 0;
  }
  ~InterruptGuard() {
    std::signal(SIGINT, on_interrupt_);
    std::signal(SIGTERM, on_terminate_);
  }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  void (*on_interrupt_)(int);
  void (*on_terminate_)(int);
};

/// Whether a signal requested a stop.
inline bool stop_requested() { return detail::stop_signal != 0; }

/// Ends a run whose results would be incomplete; run_program() catches it.
struct Stopped {
  const char* what = "nothing is written";
};
/// What loops over steps call. @throws Stopped
inline void stop_if_requested() {
  if (stop_requested()) throw Stopped{};
}
/// The exit status of a program that was stopped: 128 + signal, so 130 after Ctrl-C.
inline int stop_status() { return 128 + detail::stop_signal; }

}  // namespace common

// SPDX-License-Identifier: MIT
// How a long run talks to the person who waits for it: a bar on a terminal, a line now and then in a log; and Ctrl-C, which
// asks the run to stop after the step it is in, with what it has.
#pragma once

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <string>

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace dem {

/// A bar: `what [#####     ]  50 %`. Goes to the standard error stream, which results never do.
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() {
    if (terminal_ && shown_) std::fputc('\n', stderr);
  }

  /// `done` is the share of the work behind us, 0 to 1. Cheap enough to call at every step.
  void at(double done) {
    const auto now = std::chrono::steady_clock::now();
    if (shown_ && done < 1.0 && now - last_ < (terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(20)))
      return;
    if (!terminal_ && done <= last_done_) return;
    last_ = now;
    last_done_ = done;
    shown_ = true;
    const int percent = static_cast<int>(100.0 * std::clamp(done, 0.0, 1.0));
    if (terminal_) {
      const std::string bar(static_cast<std::size_t>(percent / 4), '#');
      std::fprintf(stderr, "\r%s [%-25s] %3d %%", what_.c_str(), bar.c_str(), percent);
    } else {
      std::fprintf(stderr, "%s: %d %%\n", what_.c_str(), percent);
    }
    std::fflush(stderr);
  }

 private:
  std::string what_;
  std::chrono::steady_clock::time_point last_{};
  double last_done_ = -1.0;
  bool shown_ = false;
#if __has_include(<unistd.h>)
  bool terminal_ = isatty(STDERR_FILENO) != 0;
#else
  bool terminal_ = false;
#endif
};

namespace detail {
inline volatile std::sig_atomic_t interrupted = 0;
extern "C" inline void on_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);  // a second Ctrl-C ends the program at once
}
}  // namespace detail

/// While one of these lives, Ctrl-C is a request; see stop_requested().
class InterruptGuard {
 public:
  InterruptGuard() : before_(std::signal(SIGINT, detail::on_interrupt)) { detail::interrupted = 0; }
  ~InterruptGuard() { std::signal(SIGINT, before_); }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  void (*before_)(int);
};

/// Whether Ctrl-C was pressed: what loops over steps ask, to end with what they have.
inline bool stop_requested() { return detail::interrupted != 0; }

}  // namespace dem

// SPDX-License-Identifier: MIT
// A file that is there in full or not at all: written beside its final name, and renamed once it is complete.
#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "input_error.hpp"

#if __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace contact_path {

class OutputFile {
 public:
  /// @throws InputError if the file cannot be written, or if that would replace what is not a plain file
  explicit OutputFile(const std::string& file) : file_(file), partial_(file + ".partial") {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
      fail({file}, "is not a plain file");
    stream_.open(partial_, std::ios::binary);
    if (!stream_) fail({file}, std::string("cannot be written: ") + std::strerror(errno));
    to_remove() = partial_.c_str();
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, remove_and_end);
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    to_remove() = nullptr;
    if (stream_.is_open()) {
      stream_.close();
      std::remove(partial_.c_str());
    }
  }

  std::ostream& stream() { return stream_; }

  /// Puts the file in its place. @throws InputError if not all of it could be written
  void complete() {
    stream_.flush();
    std::error_code fault;
    if (stream_) std::filesystem::rename(partial_, file_, fault);
    if (!stream_ || fault) fail({file_}, "cannot be written: " + std::string(fault ? fault.message() : "disk full?"));
    stream_.close();
  }

 private:
  /// What an interrupt has to clear away: a signal handler sees nothing but globals.
  static const char*& to_remove() {
    static const char* name = nullptr;
    return name;
  }
  static void remove_and_end(int signal) {
#if __has_include(<unistd.h>)
    if (to_remove() != nullptr) unlink(to_remove());
#endif
    std::_Exit(128 + signal);
  }

  std::string file_;
  std::string partial_;
  std::ofstream stream_;
};

}  // namespace contact_path

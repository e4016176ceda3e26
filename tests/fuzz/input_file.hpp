// A fuzzer's bytes as a file, for programs that read files: one a process, written anew for each input.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace fuzz {

class InputFile {
 public:
  InputFile() : name_((std::filesystem::temp_directory_path() / ("fuzz." + std::to_string(getpid()))).string()) {}
  ~InputFile() { std::remove(name_.c_str()); }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& holding(const std::uint8_t* data, std::size_t size) {
    std::ofstream stream(name_, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    stream.close();
    if (!stream) std::abort();
    return name_;
  }

 private:
  std::string name_;
};

/// `read(file)` either yields something or throws an `Error` that names the file; no input may do anything else.
template <class Error, class Read>
void expect_read_or_refused(const std::uint8_t* data, std::size_t size, const Read& read) {
  static InputFile input;
  const std::string& file = input.holding(data, size);
  try {
    read(file);
  } catch (const Error& error) {
    const std::string message = error.what();
    if (message.compare(0, file.size() + 1, file + ':') == 0) return;
    std::fprintf(stderr, "the message does not begin with the file: %s\n", message.c_str());
    std::abort();
  }
}

}  // namespace fuzz

// SPDX-License-Identifier: MIT
// Faults in files, with their place: `file:line:column: message`, in the format of compilers.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

namespace common {

/// A place in a file. Lines and columns count from 1; 0 stands for the whole file or line.
struct Place {
  std::string file;
  std::size_t line = 0;
  std::size_t column = 0;
};

inline std::string to_string(const Place& place) {
  std::string text = place.file;
  if (place.line > 0) text += ':' + std::to_string(place.line);
  if (place.column > 0) text += ':' + std::to_string(place.column);
  return text;
}

/// A fault that the user can mend. The message is shown to the user unchanged.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void fail(const Place& place, const std::string& message) {
  throw InputError(to_string(place) + ": " + message);
}

/// A remark for the user on the standard error stream; the program goes on.
inline void note(const Place& place, const std::string& message) {
  std::fputs((to_string(place) + ": note: " + message + '\n').c_str(), stderr);
}

/// A piece of a file for a message: in quotes, at most 40 characters, all printable.
inline std::string in_quotes(const std::string& piece) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : piece.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (piece.size() > longest ? "...'" : "'");
}

/// Names with commas between them: a, b, c.
template <class Names>
std::string listed(const Names& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/// @throws InputError naming a file that cannot be read
inline std::string read_text(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) fail({file}, "is a directory");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) fail({file}, std::string("cannot be opened: ") + std::strerror(errno));
  std::ostringstream text;
  if (stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (stream.bad() || text.bad()) fail({file}, "cannot be read");
  return text.str();
}

}  // namespace common

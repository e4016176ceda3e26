// SPDX-License-Identifier: MIT
// What is wrong with an input file, and where: `file:line:column: message`, as compilers say it.
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

/// A place in a file; lines and columns count from 1, and 0 means the whole of it.
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

/// Its message is for the user, as it stands.
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

/// A piece of a file, fit to stand in a message: in quotes, short, printable.
inline std::string in_quotes(const std::string& piece) {
  constexpr std::size_t longest = 40;
  std::string text = "'";
  for (const char c : piece.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (piece.size() > longest ? "...'" : "'");
}

/// Names in a row: a, b, c.
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

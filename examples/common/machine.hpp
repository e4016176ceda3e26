// SPDX-License-Identifier: MIT
// What a measured time belongs to: processor, compiler and date.
#pragma once

#include <ctime>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

namespace common {

/// As /proc/cpuinfo names it; "unknown" where there is none.
inline std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.compare(0, 10, "model name") == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

inline std::string compiler() {
#if defined(__clang__)
  const std::string name = __VERSION__;
#elif defined(__GNUC__)
  const std::string name = "g++ " __VERSION__;
#elif defined(_MSC_FULL_VER)
  const std::string name = "MSVC " + std::to_string(_MSC_FULL_VER);
#else
  const std::string name = "unknown";
#endif
#if defined(__OPTIMIZE__) || defined(_MSC_FULL_VER)
  return name;
#else
  return name + ", not optimised";
#endif
}

/// YYYY-MM-DD, UTC
inline std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[11];
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::gmtime(&now));
  return text;
}

inline nlohmann::ordered_json machine() {
  return {{"processor", processor()}, {"compiler", compiler()}, {"date", today()}};
}

}  // namespace common

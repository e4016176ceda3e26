// SPDX-License-Identifier: MIT
// Where and when a benchmark was run.
#pragma once

#include <ctime>
#include <fstream>
#include <string>

namespace bench {

inline std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.compare(0, 10, "model name") == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

/// YYYY-MM-DD, UTC
inline std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[11];
  std::strftime(text, sizeof(text), "%Y-%m-%d", std::gmtime(&now));
  return text;
}

}  // namespace bench

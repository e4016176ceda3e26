// What the scoreboard's programs share: how many cases to try, and the rows that they print, one JSON object a line.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

namespace contactlaws::test {

/// How much to try: `--full`, the full counts; `--count N`, so many of everything; else a quick look.
class Effort {
 public:
  Effort(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
      const std::string option = argv[i];
      if (option == "--full") {
        full_ = true;
      } else if (option == "--count" && i + 1 < argc && std::atoll(argv[i + 1]) > 0) {
        fixed_ = std::atoll(argv[++i]);
      } else {
        std::cerr << argv[0] << ": " << option << " is neither --full nor --count N, N > 0\n";
        std::exit(2);
      }
    }
  }
  std::int64_t operator()(std::int64_t quick, std::int64_t full) const {
    return fixed_ > 0 ? fixed_ : full_ ? full : quick;
  }

 private:
  bool full_ = false;
  std::int64_t fixed_ = 0;
};

/// One figure of the scoreboard.
struct Row {
  int item;          ///< number in the table of README.md
  std::string name;  ///< kernel or law, then the quantity
  double figure;
  std::string unit;
  std::optional<double> target = {};  ///< the largest figure allowed; none where a figure is only published
  std::int64_t count = 0;             ///< cases tried
  std::string worst = {};             ///< the input that gave the figure
  std::string reason = {};            ///< why a target is missed, or what a figure means; shown in the table
};

/// Prints a row. JSON has no NaN or infinity: such a figure is null, and misses any target.
inline void report(const Row& row) {
  nlohmann::ordered_json json;
  json["item"] = row.item;
  json["name"] = row.name;
  json["figure"] = std::isfinite(row.figure) ? nlohmann::ordered_json(row.figure) : nullptr;
  json["unit"] = row.unit;
  json["target"] = row.target ? nlohmann::ordered_json(*row.target) : nullptr;
  json["met"] = row.target ? nlohmann::ordered_json(row.figure <= *row.target) : nullptr;
  json["count"] = row.count;
  json["worst"] = row.worst;
  json["reason"] = row.reason;
  std::cout << json.dump() << std::endl;
}

/// Values as text that gives them back.
template <class... Values>
std::string text_of(const Values&... values) {
  std::ostringstream text;
  text.precision(17);
  ((text << values), ...);
  return text.str();
}

}  // namespace contactlaws::test

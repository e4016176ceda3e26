// SPDX-License-Identifier: MIT
// Drives a contact law along an imposed motion:
//
//   contact_path LAW.toml PATH.csv [-o OUT.csv] [--precision double|float|long|200]
//   contact_path --list
//
// Exit status: 0; 2 for a fault in its input, which it names; 130 after Ctrl-C. With 2 and 130 there is no output. Notes on
// input that is allowed but probably not meant go to the standard error.
#include <filesystem>
#include <iostream>
#include <map>
#include <string>

#include "common/output_file.hpp"
#include "common/program.hpp"
#include "common/progress.hpp"
#include "contactlaws/scalars/multiprecision.hpp"
#include "law_file.hpp"
#include "list.hpp"

namespace contact_path {

/// Each precision is compiled on its own: drive_double.cpp, drive_float.cpp, drive_long.cpp, drive_200.cpp.
template <class T>
void drive(const LawSpec& law, const std::string& path_file, std::ostream& out);

namespace {

using Driver = void (*)(const LawSpec&, const std::string&, std::ostream&);
const std::map<std::string, Driver> drivers{{"double", drive<double>},
                                            {"float", drive<float>},
                                            {"long", drive<long double>},
                                            {"200", drive<contactlaws::Binary200>}};

struct Arguments {
  std::string law;
  std::string path;
  std::string out;
  std::string precision = "double";
};

int run(const Arguments& arguments) {
  const LawSpec law = read_law(arguments.law);
  const Driver drive_law = drivers.at(arguments.precision);
  const InterruptGuard guard;
  if (arguments.out.empty()) {
    drive_law(law, arguments.path, std::cout);
    return 0;
  }
  for (const std::string& input : {arguments.law, arguments.path}) {
    std::error_code not_there;
    if (std::filesystem::equivalent(input, arguments.out, not_there))
      fail({arguments.out}, "is also an input, and would be lost");
  }
  OutputFile out(arguments.out);
  drive_law(law, arguments.path, out.stream());
  out.complete();
  return 0;
}

}  // namespace

}  // namespace contact_path

int main(int argc, char** argv) {
  CLI::App app("Drives a contact law along an imposed motion, and writes the force and the state at every step.",
               "contact_path");
  contact_path::Arguments arguments;
  const auto list = [] {
    contact_path::list_all(std::cout);
    throw CLI::Success();
  };
  app.add_option("LAW.toml", arguments.law, "the law and the pair of bodies")->required();
  app.add_option("PATH.csv", arguments.path, "the motion, a row a step")->required();
  app.add_option("-o,--output", arguments.out, "where to write (default: the standard output)");
  app.add_option("--precision", arguments.precision, "what to compute in (default: double)")
      ->check(CLI::IsMember({"double", "float", "long", "200"}));
  app.add_flag_callback("--list", list, "prints laws, parameters, units and ranges, and the columns of the files");
  return common::run_program(app, argc, argv, [&arguments] { return contact_path::run(arguments); });
}

// SPDX-License-Identifier: MIT
// What main() does in every program: arguments, faults, exit status.
#pragma once

#include <cstdio>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "input_error.hpp"
#include "progress.hpp"

namespace common {

/// Parses the arguments and calls `run`, which returns the exit status. A fault in the arguments, an exception and a standard
/// output that cannot be written give the status 2 and a message that begins with the program's name; Stopped gives stop_status().
template <class Run>
int run_program(CLI::App& app, int argc, char** argv, const Run& run) {
  try {
    int status = 0;
    try {
      app.parse(argc, argv);
      status = run();
    } catch (const CLI::ParseError& fault) {  // --help, too
      if (app.exit(fault) != 0) return 2;
    }
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0 || !std::cout.flush())
      throw InputError("the standard output cannot be written");
    return status;
  } catch (const Stopped& stopped) {
    std::cerr << app.get_name() << ": stopped, " << stopped.what << '\n';
    return stop_status();
  } catch (const std::exception& fault) {
    std::cerr << app.get_name() << ": " << fault.what() << '\n';
    return 2;
  }
}

}  // namespace common

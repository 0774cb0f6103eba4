#pragma once

#include <string>

#include "app/options.h"

namespace drape::app {

// What became of the command line: options to act on, or a text to print instead.
struct CommandLine {
  Options options;
  std::string answer;  // to --help and --version; for stdout
  std::string error;   // what is wrong with it; for stderr
};

// The only file pair that includes CLI11.
CommandLine parse_command_line(int argument_count, const char* const* arguments);

}  // namespace drape::app

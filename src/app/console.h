#pragma once

#include <string>

#include "app/options.h"

namespace drape::app {

// How to speak to whoever started the program. Words go to stderr; stdout is for results.
struct Console {
  int verbosity = 0;
  bool color = false;
  ProgressStyle progress = ProgressStyle::none;  // never `automatic`
};

// Settles what `auto` means here: a terminal gets colours and a bar, a file gets neither.
Console make_console(const Options& options);

void note(const Console& console, const std::string& text);      // not with -q
void detail(const Console& console, const std::string& text);    // only with -v
void warn(const Console& console, const std::string& text);      // not with -q
void complain(const Console& console, const std::string& line);  // a whole line with "error:" in it

// A line of results on stdout.
void print_result(const std::string& text);

}  // namespace drape::app

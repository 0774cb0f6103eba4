#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::app {

struct ProcessResult {
  bool was_found = true;  // the program, in PATH
  int exit_status = 0;    // 128 plus the signal's number where a signal ended it
  std::string errors;     // the end of what it wrote on stderr
  double cpu_seconds = 0;
};

// Runs a program without a shell, with nothing on its stdin, and waits for its end. Each line of its stdout
// goes to `on_line`. When a stop signal arrives, the program is ended too.
ProcessResult run_process(const std::vector<std::string>& arguments,
                          const std::function<void(std::string_view)>& on_line);

}  // namespace drape::app

#pragma once

#include <string>
#include <vector>

namespace drape::app {

// What went wrong: for people, and for the caller of the program.
struct Failure {
  int exit_status = 0;
  std::vector<std::string> lines;
};

// The exception that is being handled, as a failure. Call it inside `catch (...)`.
Failure describe_current_exception();

}  // namespace drape::app

#include <fmt/format.h>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/exit_status.h"
#include "app/failure.h"
#include "app/interrupt.h"
#include "core/memory.h"
#include "mesh/import_process.h"

namespace drape::app {

static int act_on(const CommandLine& command_line) {
  if (!command_line.error.empty()) {
    fmt::print(stderr, "{}", command_line.error);
    return static_cast<int>(ExitStatus::usage);
  }
  if (!command_line.answer.empty()) {
    fmt::print("{}", command_line.answer);
    return static_cast<int>(ExitStatus::done);
  }
  return perform(command_line.options, make_console(command_line.options));
}

static int run_program(int argument_count, const char* const* arguments) {
  Console console;
  try {
    remember_stop_signals();
    const CommandLine command_line = parse_command_line(argument_count, arguments);
    console = make_console(command_line.options);
    return act_on(command_line);
  } catch (...) {
    const Failure failure = describe_current_exception();
    for (const std::string& line : failure.lines) complain(console, line);
    return failure.exit_status;
  }
}

}  // namespace drape::app

// The program starts itself anew to read the meshes that it must not trust itself with.
int main(int argument_count, char** arguments) {
  if (const auto status = drape::run_import_child(argument_count, arguments)) return *status;
  drape::keep_freed_memory();
  return drape::app::run_program(argument_count, arguments);
}

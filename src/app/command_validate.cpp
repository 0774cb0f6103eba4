#include <algorithm>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/failure.h"
#include "app/run.h"
#include "app/start.h"
#include "core/error.h"
#include "scene/load.h"

namespace drape::app {

static int validate(const std::string& input, const Options& options, const Console& console) {
  try {
    const SceneSource source = find_scene(input, options.overrides);
    const SceneDescription scene = load_scene(source.file, source.overrides);
    if (auto problems = start_problems(scene, find_start(scene)); !problems.empty())
      throw InputError(std::move(problems));
    print_result(input + ": ok");
    return static_cast<int>(ExitStatus::done);
  } catch (...) {
    const Failure failure = describe_current_exception();
    for (const std::string& line : failure.lines) complain(console, line);
    return failure.exit_status;
  }
}

int validate_command(const Options& options, const Console& console) {
  int worst = static_cast<int>(ExitStatus::done);
  for (const std::string& input : options.inputs) worst = std::max(worst, validate(input, options, console));
  return worst;
}

}  // namespace drape::app

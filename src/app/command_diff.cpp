#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/picture_diff.h"

namespace drape::app {

int diff_command(const Options& options, const Console&) {
  const auto comparisons = compare(options.inputs[0], options.inputs[1], options.diff);
  for (const PictureComparison& each : comparisons) {
    print_result(fmt::format("{}  {}  {}", each.same ? "same  " : "differ", each.name, each.figures));
  }
  const bool same =
      std::all_of(comparisons.begin(), comparisons.end(), [](const auto& each) { return each.same; });
  return static_cast<int>(same ? ExitStatus::done : ExitStatus::differs);
}

}  // namespace drape::app

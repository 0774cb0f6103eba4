#pragma once

#include <optional>
#include <string>

#include "scene/description.h"

namespace drape::app {

// What became of one of the scene's facts.
struct FactResult {
  SceneFact fact;
  std::string meaning;          // "lowest of sheet, frames 30 to 60, at least 0.1"
  std::optional<double> found;  // nothing: none of its frames was looked at
  int frame = 0;                // where it comes nearest to a bound, or is farthest beyond it
  bool holds = true;
};

}  // namespace drape::app

#pragma once

#include "app/console.h"
#include "app/options.h"
#include "app/run.h"

namespace drape::app {

// Simulates the frames that the cache lacks, from the last checkpoint on where there is a fitting one. Frame
// 0 is the start, before any step; frames before the scene's first are simulated, but not kept. Throws
// Interrupted after a checkpoint.
void simulate(Run& run, const Options& options, const Console& console);

}  // namespace drape::app

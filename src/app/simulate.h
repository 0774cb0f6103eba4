#pragma once

#include "app/console.h"
#include "app/options.h"
#include "app/run.h"

namespace drape::app {

// Simulates the frames that the cache lacks, from the last checkpoint on where there is a fitting one. The
// first frame of a scene is its start, before any step. Throws Interrupted after a checkpoint.
void simulate(Run& run, const Options& options, const Console& console);

}  // namespace drape::app

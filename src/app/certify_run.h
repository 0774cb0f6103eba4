#pragma once

#include "app/console.h"
#include "app/options.h"
#include "app/run.h"

namespace drape::app {

// Certifies every frame of the scene, from the cache, and keeps the summary in the record; a warning where a
// frame fails. Does nothing where the record has the certificate of these very frames. Throws FileError, and
// Interrupted.
void certify_run(Run& run, const Options& options, const Console& console);

}  // namespace drape::app

#pragma once

#include "app/console.h"
#include "app/options.h"

namespace drape::app {

// Does what the options ask for; the exit status. Failures are exceptions.
int perform(const Options& options, const Console& console);

int run_command(const Options& options, const Console& console);
int still_command(const Options& options, const Console& console);
int validate_command(const Options& options, const Console& console);
int info_command(const Options& options, const Console& console);
int export_command(const Options& options, const Console& console);
int measure_command(const Options& options, const Console& console);
int verify_command(const Options& options, const Console& console);
int diff_command(const Options& options, const Console& console);

}  // namespace drape::app

#include "app/commands.h"

#include "app/encode.h"
#include "app/exit_status.h"
#include "app/render_frames.h"
#include "app/run.h"
#include "app/simulate.h"
#include "app/statistics_file.h"

namespace drape::app {

static Run open_only_run(const Options& options) {
  return open_run(options.inputs.front(), options.overrides, options.output);
}

static int simulate_command(const Options& options, const Console& console) {
  Run run = open_only_run(options);
  simulate(run, options, console);
  if (!options.statistics_file.empty()) write_statistics(options.statistics_file, run.manifest);
  print_result(run.folder.cache().string());
  return static_cast<int>(ExitStatus::done);
}

static int render_command(const Options& options, const Console& console) {
  Run run = open_only_run(options);
  render_frames(run, chosen_frames(run, options), options, console);
  print_result(run.folder.frames().string());
  return static_cast<int>(ExitStatus::done);
}

static int encode_command(const Options& options, const Console& console) {
  Run run = open_only_run(options);
  encode(run, console);
  print_result(run.folder.video().string());
  return static_cast<int>(ExitStatus::done);
}

int perform(const Options& options, const Console& console) {
  switch (options.command) {
    case Command::run:
      return run_command(options, console);
    case Command::simulate:
      return simulate_command(options, console);
    case Command::render:
      return render_command(options, console);
    case Command::encode:
      return encode_command(options, console);
    case Command::still:
      return still_command(options, console);
    case Command::validate:
      return validate_command(options, console);
    case Command::info:
      return info_command(options, console);
    case Command::export_geometry:
      return export_command(options, console);
    case Command::measure:
      return measure_command(options, console);
    case Command::verify:
      return verify_command(options, console);
    case Command::diff:
      return diff_command(options, console);
  }
  return static_cast<int>(ExitStatus::internal);
}

}  // namespace drape::app

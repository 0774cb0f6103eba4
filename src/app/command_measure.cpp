#include <fmt/format.h>

#include "app/commands.h"
#include "app/drape_figures.h"
#include "app/exit_status.h"
#include "app/run.h"
#include "core/error.h"

namespace drape::app {

// A cloth that still swings has no drape yet. The test on the table is read off when nothing moves to the
// eye.
static constexpr double speed_at_rest = 0.02;  // m/s

static void warn_where_it_moves(const Run& run, int frame, const Console& console) {
  const auto record = run.manifest.frames.find(frame);
  if (record == run.manifest.frames.end()) return;
  const double speed = record->second.statistics.largest_speed;
  if (speed > speed_at_rest)
    warn(console,
         fmt::format("frame {}: the cloth is not at rest, some of it moves at {:.3f} m/s: make time.frames "
                     "larger, or material.damping",
                     frame, speed));
}

static void print_figures(const DrapeFigures& figures, int frame, bool as_json) {
  if (as_json)
    return print_result(fmt::format(R"({{"frame": {}, "drape_coefficient_percent": {:.3f}, "folds": {}}})",
                                    frame, figures.coefficient, figures.folds));
  print_result(fmt::format("drape coefficient  {:.1f} %", figures.coefficient));
  print_result(fmt::format("folds              {}", figures.folds));
}

int measure_command(const Options& options, const Console& console) {
  const Run run = open_run(options.inputs.front(), options.overrides, options.output);
  if (!run.scene.drape_test)
    throw InputError(
        {{run.scene.file, 0, 0,
          "nothing to measure: give the scene `measure: {drape: {cloth: NAME, support: NAME}}`"}});
  const int frame = options.frames.empty() ? run.scene.time.last_frame : only_frame(run, options);
  const CachedFrame cached = read_cached_frame(run.folder.cache(), run.manifest.fingerprint, frame);
  warn_where_it_moves(run, frame, console);
  print_figures(measure_drape(run.scene, cached), frame, options.as_json);
  return static_cast<int>(ExitStatus::done);
}

}  // namespace drape::app

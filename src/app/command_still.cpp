#include <filesystem>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/render_frames.h"
#include "app/run.h"
#include "render/png_file.h"

namespace drape::app {

int still_command(const Options& options, const Console&) {
  // Here -o names the picture, so the run is the input's own.
  const Run run = open_run(options.inputs.front(), options.overrides, "");
  const int frame = only_frame(run, options);
  std::filesystem::path target = options.output;
  if (target.empty()) target = run.folder.root / ("still_" + frame_file_name(frame, ".png"));
  render::write_png(target, draw_frame(run, frame, options));
  print_result(target.string());
  return static_cast<int>(ExitStatus::done);
}

}  // namespace drape::app

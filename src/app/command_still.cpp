#include <filesystem>
#include <string>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/render_frames.h"
#include "app/run.h"
#include "core/error.h"
#include "render/png_file.h"

namespace drape::app {

// Another ending would name what this is not.
static std::filesystem::path picture_path(const std::filesystem::path& output) {
  const std::string ending = output.extension().string();
  if (ending != ".png" && ending != ".PNG")
    throw InputError({{output.string(), 0, 0, "a picture is a PNG file: let its name end in .png"}});
  return output;
}

int still_command(const Options& options, const Console&) {
  // Here -o names the picture, so the run is the input's own.
  const Run run = open_run(options.inputs.front(), options.overrides, "");
  const int frame = only_frame(run, options);
  const std::filesystem::path target = options.output.empty()
                                           ? run.folder.root / ("still_" + frame_file_name(frame, ".png"))
                                           : picture_path(options.output);
  render::write_png(target, draw_frame(run, frame, options));
  print_result(target.string());
  return static_cast<int>(ExitStatus::done);
}

}  // namespace drape::app

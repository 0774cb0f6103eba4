#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/manifest.h"
#include "app/options.h"
#include "app/run_folder.h"
#include "scene/description.h"

namespace drape::app {

// A scene that is being made into a film: its description, its folder, and the record of what is done so far.
struct Run {
  std::string input;  // as the user named it: a scene file or a run's folder
  SceneDescription scene;
  RunFolder folder;
  Manifest manifest;
};

// The scene file and the overrides that an input stands for; overrides of the command line win.
struct SceneSource {
  std::filesystem::path file;
  std::vector<std::string> overrides;
};
SceneSource find_scene(const std::string& input, const std::vector<std::string>& overrides);

// `before`, without those that set the same key as one of `after`, and then `after`.
std::vector<std::string> merge_overrides(const std::vector<std::string>& before,
                                         const std::vector<std::string>& after);

// Reads the scene and the record of earlier work in the folder: `output`, or the input itself where it is a
// run's folder, or out/NAME. Throws InputError and FileError.
Run open_run(const std::string& input, const std::vector<std::string>& overrides, const std::string& output);

// Throws InputError where the folder's record is of another scene file: its frames are not for this one to
// replace.
void refuse_folder_of_other_scene(const Run& run);

// Writes the record of new pictures or a new film, where the one on disk is of the same simulation. Others
// stay: a mistaken setting must not cost the frames that they know.
void update_record(const Run& run);

// The frames that -f and --chunk ask for.
std::vector<int> chosen_frames(const Run& run, const Options& options);

// The one frame that -f names. Throws InputError where it names none or several.
int only_frame(const Run& run, const Options& options);

}  // namespace drape::app

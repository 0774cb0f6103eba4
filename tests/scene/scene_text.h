#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/load.h"
#include "temporary_folder.h"

namespace drape {

using test::TemporaryFolder;

// The least that a scene can be, for keys to be added to.
extern const std::string smallest_scene;

// Loads a text as the file scene.yaml of a folder of its own.
SceneDescription load_text(const std::string& text, const std::vector<std::string>& overrides = {});

// The words of the error that loading the text ends with, each problem on a line, "scene.yaml" for the file's
// path; "" where it loads.
std::string errors_of(const std::string& text, const std::vector<std::string>& overrides = {});

// The same for a file that exists; `folder`, with the slash after it, is taken out of the words.
struct Failure {
  int exit_status = 0;
  std::string words;
};
Failure failure_of(const std::filesystem::path& scene, const std::filesystem::path& folder,
                   const std::vector<std::string>& overrides = {});

}  // namespace drape

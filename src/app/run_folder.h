#pragma once

#include <filesystem>
#include <string>

namespace drape::app {

// Where the results of one scene lie:
//   frames/frame_0001.png ...   cache/   NAME.mp4   run.json
struct RunFolder {
  std::filesystem::path root;
  std::string name;

  std::filesystem::path frames() const { return root / "frames"; }
  std::filesystem::path cache() const { return root / "cache"; }
  std::filesystem::path video() const { return root / (name + ".mp4"); }
  std::filesystem::path manifest() const { return root / "run.json"; }
};

// "frame_0001" and an ending: the name of a frame in all folders of results.
std::string frame_file_name(int frame, const std::string& ending);

}  // namespace drape::app

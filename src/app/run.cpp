#include "app/run.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/frame_range.h"
#include "app/program.h"
#include "core/error.h"
#include "core/file.h"
#include "scene/load.h"

namespace drape::app {
namespace fs = std::filesystem;

static std::string key_of(const std::string& override_text) {
  return override_text.substr(0, override_text.find('='));
}

std::vector<std::string> merge_overrides(const std::vector<std::string>& before,
                                         const std::vector<std::string>& after) {
  std::vector<std::string> merged;
  for (const std::string& old : before) {
    const auto sets_the_same = [&](const std::string& newer) { return key_of(newer) == key_of(old); };
    if (std::none_of(after.begin(), after.end(), sets_the_same)) merged.push_back(old);
  }
  merged.insert(merged.end(), after.begin(), after.end());
  return merged;
}

static bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

// What somebody may have meant who typed "napkin" for "scenes/napkin.yaml".
static std::string suggestion_for(const fs::path& path) {
  for (const fs::path& folder : {fs::path(), fs::path("scenes")}) {
    for (const char* ending : {"", ".yaml"}) {
      const fs::path candidate = folder / (path.string() + ending);
      std::error_code ignored;
      if (fs::is_regular_file(candidate, ignored))
        return fmt::format("; did you mean {}?", candidate.string());
    }
  }
  return "";
}

SceneSource find_scene(const std::string& input, const std::vector<std::string>& overrides) {
  const fs::path path = input;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw FileError(input, "there is no such file" + suggestion_for(path));
  if (!is_folder(path)) return {path, merge_overrides({}, overrides)};
  const auto manifest = read_manifest(path / "run.json");
  if (!manifest)
    throw FileError(input, "is a folder without run.json: name a scene file, or the folder of a run");
  return {(path / manifest->scene).lexically_normal(), merge_overrides(manifest->overrides, overrides)};
}

static RunFolder find_folder(const std::string& input, const fs::path& scene_file,
                             const std::string& output) {
  const std::string name = scene_file.stem().string();
  if (!output.empty()) return {output, name};
  return {is_folder(input) ? fs::path(input) : fs::path("out") / name, name};
}

// Frames of other settings do not count as work done.
static Manifest open_manifest(const RunFolder& folder, std::uint64_t fingerprint) {
  Manifest manifest = read_manifest(folder.manifest()).value_or(Manifest{});
  if (manifest.fingerprint != fingerprint) manifest = Manifest{};
  manifest.fingerprint = fingerprint;
  return manifest;
}

Run open_run(const std::string& input, const std::vector<std::string>& overrides, const std::string& output) {
  const SceneSource source = find_scene(input, overrides);
  Run run;
  run.input = input;
  run.scene = load_scene(source.file, source.overrides);
  run.folder = find_folder(input, source.file, output);
  refuse_file_as_folder(run.folder.root);
  run.manifest = open_manifest(run.folder, simulation_fingerprint(run.scene));
  run.manifest.program_version = program_version();
  run.manifest.scene = fs::proximate(fs::absolute(source.file), fs::absolute(run.folder.root)).string();
  run.manifest.overrides = source.overrides;
  return run;
}

void refuse_folder_of_other_scene(const Run& run) {
  const auto on_disk = read_manifest(run.folder.manifest());
  if (!on_disk || on_disk->scene == run.manifest.scene) return;
  const fs::path other = (run.folder.root / on_disk->scene).lexically_normal();
  throw InputError(
      {{run.folder.root.string(), 0, 0,
        fmt::format("holds the run of {}: name another folder with -o, or replace it with --overwrite",
                    other.string())}});
}

void update_record(const Run& run) {
  const auto on_disk = read_manifest(run.folder.manifest());
  if (on_disk && on_disk->fingerprint == run.manifest.fingerprint)
    write_manifest(run.folder.manifest(), run.manifest);
}

std::vector<int> chosen_frames(const Run& run, const Options& options) {
  const TimeSettings& time = run.scene.time;
  const auto frames = options.frames.empty()
                          ? all_frames(time.first_frame, time.last_frame)
                          : parse_frames(options.frames, time.first_frame, time.last_frame);
  return frames_of_chunk(frames, options.chunk);
}

int only_frame(const Run& run, const Options& options) {
  const auto frames = chosen_frames(run, options);
  if (options.frames.empty() || frames.size() != 1) throw InputError({{"", 0, 0, "name one frame: -f 60"}});
  return frames.front();
}

}  // namespace drape::app

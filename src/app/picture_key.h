#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "render/view.h"

namespace drape::app {

// A hash of all that a picture depends on: the arguments of Rasterizer::draw.
std::uint64_t picture_key(const std::vector<render::Surface>& surfaces, const render::View& view,
                          const render::Settings& settings);

// What a picture in the folder of frames was made from, kept beside it in a small file of its own, so that
// several machines may render parts of one film into one folder.
struct PictureOrigin {
  std::uint64_t key = 0;
  std::uint64_t build = 0;         // program_build of the program that drew it
  std::uint64_t picture_hash = 0;  // of the PNG file
};
std::optional<PictureOrigin> read_origin(const std::filesystem::path& picture);
void write_origin(const std::filesystem::path& picture, const PictureOrigin& origin);

// The hash of a file's content; 0 where there is no such file.
std::uint64_t file_hash(const std::filesystem::path& path);

}  // namespace drape::app

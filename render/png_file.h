#pragma once

#include <filesystem>

#include "render/image.h"

namespace drape::render {

// PNG files by libpng; the only file pair that includes it. Reading gives 8-bit RGB whatever the file holds
// (palette, grey, 16 bit; alpha over black). Both throw FileError; a damaged file is named with libpng's
// words.
Image read_png(const std::filesystem::path& path);
void write_png(const std::filesystem::path& path, const Image& image);  // whole or absent

}  // namespace drape::render

#pragma once

#include <cstdint>
#include <vector>

namespace drape::render {

// 8-bit sRGB, rows from the top, 3 bytes a pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

}  // namespace drape::render

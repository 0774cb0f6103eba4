#pragma once

#include <filesystem>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace drape {

// The polygons of a PLY file: ascii, or binary of either byte order. Texture coordinates are those of the
// corners (texcoord) or else those of the points (u v, s t, texture_u texture_v). Other elements and
// properties are passed over. `path` is for messages.
PolygonSoup read_ply(std::string_view content, const std::filesystem::path& path);

}  // namespace drape

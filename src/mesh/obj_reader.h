#pragma once

#include <filesystem>
#include <string_view>

#include "mesh/polygon_soup.h"

namespace drape {

// The polygons of a Wavefront OBJ file's text. Source: "Object Files (.obj)", appendix B1 of Wavefront's
// Advanced Visualizer manual. Points, texture coordinates and faces are read, what groups or draws them is
// passed over, free-form curves and surfaces are refused. Texture coordinates are dropped where some faces
// have none. `path` is for messages.
PolygonSoup read_obj(std::string_view text, const std::filesystem::path& path);

}  // namespace drape

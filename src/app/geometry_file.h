#pragma once

#include <string>
#include <vector>

#include "core/vector.h"
#include "mesh/triangle_mesh.h"

namespace drape::app {

// A named surface to write: the shape that does not change, and where its points are.
struct GeometryPart {
  std::string name;
  const TriangleMesh* mesh = nullptr;  // for triangles and texture coordinates
  std::vector<Vec3f> positions;
};

// Wavefront OBJ, one object a part. Numbers are as short as they can be and still read back as the same
// floats.
std::string to_obj(const std::vector<GeometryPart>& parts);

// Binary little-endian PLY: the parts one after another as one surface, without texture coordinates.
std::string to_ply(const std::vector<GeometryPart>& parts);

}  // namespace drape::app

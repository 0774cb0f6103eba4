#pragma once

#include <filesystem>

#include "mesh/clip.h"
#include "mesh/polygon_soup.h"

namespace drape {

// Reads a surface by the ending of its name: .obj and .ply by readers of our own, any other format that
// assimp knows by assimp in a child process. Throws FileError where the file can't be opened, InputError
// (exit status 3) that names file, line where there is one, and what is wrong otherwise.
PolygonSoup read_polygons(const std::filesystem::path& path);

// The same with its shapes in one of the file's animations. Throws UnknownClip where it has no such one.
SoupInShapes read_clip(const std::filesystem::path& path, const ClipRequest& clip);

// The same as one mesh: polygons cut into fans, points welded where their positions are equal, texture
// coordinates kept.
TriangleMesh read_mesh(const std::filesystem::path& path);

// All digits: a reader gets the same floats back.
void write_obj(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace drape

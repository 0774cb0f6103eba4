#pragma once

// The only file pair that includes assimp. assimp crashes or hangs on malformed files: call this only in a
// process that may die (mesh/import_process.h).

#include <filesystem>

#include "mesh/clip.h"
#include "mesh/polygon_soup.h"

namespace drape {

// All meshes of the file, placed as its nodes place them (where they are skinned: their bones), in its own
// units and pose of rest. It may refer to regular files in its own folder or below, and to no others. Throws
// std::runtime_error in words for the user.
PolygonSoup import_with_assimp(const std::filesystem::path& path);

// The same in the shapes that one of the file's animations gives them: nodes that move, and surfaces that
// these draw along (skinned). One shape each interval from the animation's time 0 on, until it is over.
// Keys are joined linearly: assimp does not tell where a file would have them held (STEP of glTF) or
// joined by curves (FBX, Collada). Splines of glTF and morph targets are refused. Throws UnknownClip, too.
SoupInShapes import_clip_with_assimp(const std::filesystem::path& path, const ClipRequest& clip);

}  // namespace drape

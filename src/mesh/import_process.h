#pragma once

#include <filesystem>
#include <optional>

#include "mesh/clip.h"
#include "mesh/polygon_soup.h"

namespace drape {

// Formats that only assimp reads are read in a child process, because assimp crashes, hangs and exhausts
// memory on malformed files. The child is this program, started anew (/proc/self/exe): a fork without exec
// would inherit locks that other threads hold. It has limits on memory, CPU time and what it may open, and
// writes nothing but a pipe to its parent, which checks all that comes through.

// To be called first in the main function of every program that reads such meshes. Does the child's work and
// returns its exit status where this process is such a child; nothing in all other processes.
std::optional<int> run_import_child(int argc, const char* const* argv);

// The parent's side: the file's surface, and its shapes in the clip that is asked for. Throws InputError
// (exit status 3) with the file's name where the file is at fault or the child died, and UnknownClip.
SoupInShapes import_in_child(const std::filesystem::path& path, const std::optional<ClipRequest>& clip);

}  // namespace drape

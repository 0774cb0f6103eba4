#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "scene/section.h"
#include "simulation/input.h"

namespace drape {

// Whether a file's name stands for a sequence: it has a run of # in the place of a number.
bool names_sequence(const std::string& name);

// The key `mesh` of a section that names one: body.####.obj, of which file n is the shape at frame n. The
// numbers follow one another, and all files have the faces of the first; it must be fit for simulation.
std::optional<MeshShape> read_sequence(const Section& section, const std::filesystem::path& scene_folder,
                                       double fps);

// The keys `mesh` and `clip` of a section: a file that holds an animation, which begins at frame 0.
std::optional<MeshShape> read_clip_key(const Section& section, const std::filesystem::path& scene_folder,
                                       double fps);

}  // namespace drape

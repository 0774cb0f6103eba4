#pragma once

#include <filesystem>
#include <vector>

#include "app/surface_check.h"
#include "core/error.h"
#include "scene/description.h"

namespace drape::app {

// How the cloth of a scene starts, judged as its frames will be.
struct Start {
  ClothSurface surface;  // all cloths, as placed; what only touches, or is nearer than contact needs, apart
  CertifiedSurface certified;  // where it is not clean, something is through something: that alone is in it
};

// Layers that only touch, even those that lie exactly in each other, are set some 20 um apart: contact must
// know on which side of each other they are. Pairs of one cloth do not count where the scene has no
// self-collision.
Start find_start(const SceneDescription& scene);

// What is through what, one problem for each pair of cloths and each cloth and collider; none where all is
// clean.
std::vector<Problem> start_problems(const SceneDescription& scene, const Start& start);

// The input of the scene's simulation, its start as above. Throws InputError where something is through
// something, with a picture of the faces as start.png in the folder.
SimulationInput start_input(const SceneDescription& scene, const std::filesystem::path& folder);

}  // namespace drape::app

#pragma once

#include "scene/description.h"
#include "scene/section.h"

namespace drape {

// The keys `camera`, `lights` and `render` of a scene, over their defaults.
void read_picture(const Section& scene, SceneDescription& description);

}  // namespace drape

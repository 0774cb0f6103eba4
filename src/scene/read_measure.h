#pragma once

#include "scene/description.h"
#include "scene/section.h"

namespace drape {

// What a scene is to be measured for. Goes after its cloths and colliders, which it names.
void read_measure(const Section& scene, SceneDescription& description);

}  // namespace drape

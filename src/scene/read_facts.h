#pragma once

#include "scene/description.h"
#include "scene/section.h"

namespace drape {

// What the scene's frames must show, its list `test`. Goes after its cloths, which it names.
void read_facts(const Section& scene, SceneDescription& description);

// The word for a quantity in a scene.
std::string_view fact_name(FactQuantity quantity);

}  // namespace drape

#pragma once

#include <string>
#include <vector>

#include "app/frame_certificate.h"
#include "scene/description.h"

namespace drape::app {

// How a triangle of all cloths together is called: "triangle 12 of napkin", counted from 1.
std::string name_in_cloth(const SceneDescription& scene, int triangle);
// And one of the drawn surface: "drawn triangle 12 of napkin".
std::string name_in_drawn(const CertifiedScene& scene, const SceneDescription& names, int triangle);

// The numbers of triangles up to and with each cloth.
std::vector<int> triangle_ends(const SceneDescription& scene);

// The cloth that a triangle of all cloths together is of: its index.
int cloth_of(const SceneDescription& scene, int triangle);

}  // namespace drape::app

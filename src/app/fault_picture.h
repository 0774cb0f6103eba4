#pragma once

#include "app/surface_check.h"
#include "render/image.h"

namespace drape::app {

// The triangles that meet others or are in a collider, ascending, each once; those of it that have a place.
std::vector<int> faulty_triangles(const ClothSurface& surface, const CertifiedSurface& certified);

// The cloth alone, its faulty triangles in red, from where most of them are seen and near enough to tell them
// apart. Needs at least one of them. Throws RenderError.
render::Image draw_faults(const ClothSurface& surface, const std::vector<int>& faulty);

}  // namespace drape::app

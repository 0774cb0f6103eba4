#pragma once

#include <vector>

#include "core/vector.h"
#include "render/view.h"

namespace drape::render {

struct Sphere {
  Vec3f center{0, 0, 0};
  float radius = 0;
};

// Round all points of the surfaces: about the middle of their box, as small as that allows. Of no points:
// radius 0.
Sphere bounding_sphere(const std::vector<Surface>& surfaces);

// The clip space of a camera that sees `scene` and the ground whole, moved by an offset in pixels.
Mat4f camera_projection(const View& view, const Settings& settings, const Sphere& scene, const Vec2f& offset);

// How far from the camera's target the ground is half dissolved into the backdrop.
float ground_half_distance(const Camera& camera);

// Beyond this distance from the camera's target nothing of the ground is left to see.
float ground_reach(const Camera& camera);

}  // namespace drape::render

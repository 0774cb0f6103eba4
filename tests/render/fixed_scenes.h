#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/view.h"

namespace drape::render::test {

struct FixedScene {
  std::string name;
  std::vector<Surface> surfaces;
  View view;
};
inline void PrintTo(const FixedScene& scene, std::ostream* out) { *out << scene.name; }

// A cloth through the points of a function of (u, v) in the unit square, cells x cells. Its front is where u,
// v and the normal are left-handed, as for the grid of mesh/primitives.h (u along +x, v along +z, front up).
Surface make_sheet(int cells, const std::function<Vec3f(float u, float v)>& point);
Surface make_ball(const Vec3f& center, float radius);

// A square of a side of 2 round the origin that faces +z.
Surface make_wall();

// A camera on the z axis that looks at the origin from +z.
View view_from_z(float distance);

// Sun alone, from the direction of +z, without extent.
void light_head_on(View& view);

// The scenes of the golden pictures.
std::vector<FixedScene> fixed_scenes();

Vec3f pixel(const Image& image, int x, int y);

// Where a point of the world is seen, in pixels from the top left corner.
Vec2f seen_at(const Vec3f& point, const View& view, const Settings& settings);

}  // namespace drape::render::test

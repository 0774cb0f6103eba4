#include "app/triangle_names.h"

#include <fmt/format.h>

namespace drape::app {

namespace {

struct ClothTriangle {
  std::size_t cloth = 0;
  int triangle = 0;  // of it, from 0
};

}  // namespace

template <typename CountTriangles>
static ClothTriangle find_triangle(int triangle, const CountTriangles& count_triangles) {
  ClothTriangle place{0, triangle};
  while (place.triangle >= count_triangles(place.cloth)) place.triangle -= count_triangles(place.cloth++);
  return place;
}

static ClothTriangle simulated_triangle(const SceneDescription& scene, int triangle) {
  return find_triangle(
      triangle, [&](std::size_t i) { return static_cast<int>(scene.cloths[i].input.mesh.triangles.size()); });
}

std::string name_in_cloth(const SceneDescription& scene, int triangle) {
  const ClothTriangle place = simulated_triangle(scene, triangle);
  return fmt::format("triangle {} of {}", place.triangle + 1, scene.cloths[place.cloth].input.name);
}

std::string name_in_drawn(const CertifiedScene& scene, const SceneDescription& names, int triangle) {
  const ClothTriangle place = find_triangle(
      triangle, [&](std::size_t i) { return static_cast<int>(scene.drawn.cloths[i].triangles.size()); });
  return fmt::format("drawn triangle {} of {}", place.triangle + 1, names.cloths[place.cloth].input.name);
}

std::vector<int> triangle_ends(const SceneDescription& scene) {
  std::vector<int> ends;
  for (const ClothDescription& cloth : scene.cloths)
    ends.push_back((ends.empty() ? 0 : ends.back()) + static_cast<int>(cloth.input.mesh.triangles.size()));
  return ends;
}

int cloth_of(const SceneDescription& scene, int triangle) {
  return static_cast<int>(simulated_triangle(scene, triangle).cloth);
}

}  // namespace drape::app

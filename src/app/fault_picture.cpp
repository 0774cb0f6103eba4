#include "app/fault_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/loop_subdivision.h"
#include "render/rasterizer.h"

namespace drape::app {

static constexpr render::Settings picture_size{1280, 720, 8};
static constexpr std::size_t most_samples = 24;  // of the faulty triangles, for the choice of a direction

static TrianglePoints points_of(const ClothSurface& surface, int triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return {surface.positions[a], surface.positions[b], surface.positions[c]};
}

static bool has_place(const TrianglePoints& t) {
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite();
}

std::vector<int> faulty_triangles(const ClothSurface& surface, const CertifiedSurface& certified) {
  std::vector<int> faulty = certified.in_colliders;
  for (const auto& [s, t] : certified.intersecting) faulty.insert(faulty.end(), {s, t});
  std::sort(faulty.begin(), faulty.end());
  faulty.erase(std::unique(faulty.begin(), faulty.end()), faulty.end());
  std::erase_if(faulty, [&](int t) { return !has_place(points_of(surface, t)); });
  return faulty;
}

namespace {

struct Ball {
  Vec3 centre;
  double radius;
};

}  // namespace

static Ball ball_round(const ClothSurface& surface, const std::vector<int>& triangles) {
  const TrianglePoints first = points_of(surface, triangles.front());
  Vec3 lower = first[0], upper = first[0];
  for (const int t : triangles)
    for (const Vec3& p : points_of(surface, t)) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  return {0.5 * (lower + upper), 0.5 * (upper - lower).norm()};
}

static std::vector<int> placed_triangles(const ClothSurface& surface) {
  std::vector<int> all;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
    if (has_place(points_of(surface, t))) all.push_back(t);
  return all;
}

// Toward the corners, edges and faces of a cube; from above first, where people look from.
static std::vector<Vec3> directions() {
  std::vector<Vec3> all;
  for (const int y : {1, 0, -1})
    for (const int z : {1, -1, 0})
      for (const int x : {1, -1, 0})
        if (x != 0 || y != 0 || z != 0) all.push_back(Vec3(x, 0.7 * y, z).normalized());
  return all;
}

// The share of the triangle's area that shows towards `direction`; 0 where another triangle is before its
// middle.
static double shown(const ClothSurface& surface, const std::vector<int>& all, int triangle,
                    const Vec3& direction, double far) {
  const TrianglePoints t = points_of(surface, triangle);
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3, start = middle + 1e-4 * far * direction;
  const auto is_before = [&](int other) {
    return other != triangle &&
           segment_meets_triangle(start, middle + far * direction, points_of(surface, other));
  };
  if (std::any_of(all.begin(), all.end(), is_before)) return 0;
  return std::abs((t[1] - t[0]).cross(t[2] - t[0]).normalized().dot(direction));
}

static Vec3 best_direction(const ClothSurface& surface, const std::vector<int>& all,
                           const std::vector<int>& faulty, double far) {
  const std::size_t stride = (faulty.size() + most_samples - 1) / most_samples;
  Vec3 best = Vec3::UnitY();
  double most = -1;
  for (const Vec3& direction : directions()) {
    double sum = 0;
    for (std::size_t i = 0; i < faulty.size(); i += stride)
      sum += shown(surface, all, faulty[i], direction, far);
    if (sum > 1.01 * most) most = sum, best = direction;
  }
  return best;
}

static render::Camera camera_on(const ClothSurface& surface, const std::vector<int>& faulty) {
  const std::vector<int> all = placed_triangles(surface);
  const Ball cloth = ball_round(surface, all), faults = ball_round(surface, faulty);
  const double radius = std::max(1.5 * faults.radius, 0.06 * cloth.radius);
  render::Camera camera;
  const double half_angle = 0.5 * camera.vertical_field_of_view * std::numbers::pi / 180;
  const Vec3 direction = best_direction(surface, all, faulty, 2 * cloth.radius);
  camera.target = faults.centre.cast<float>();
  camera.eye = (faults.centre + radius / std::sin(half_angle) * direction).cast<float>();
  return camera;
}

static render::Surface surface_of(const std::vector<Vec3f>& positions, const std::vector<Vec3f>& normals,
                                  const render::Color& color) {
  render::Surface surface;
  surface.positions = positions;
  surface.normals = normals;
  surface.material.color = surface.material.back = color;
  surface.material.sheen = 0;
  surface.material.translucency = 0;
  surface.two_sided = true;
  return surface;
}

static std::vector<Vec3f> drawable(const std::vector<Vec3>& positions) {
  std::vector<Vec3f> result;
  for (const Vec3& p : positions)
    result.push_back(p.allFinite() ? Vec3f(p.cast<float>()) : Vec3f(Vec3f::Zero()));
  return result;
}

render::Image draw_faults(const ClothSurface& surface, const std::vector<int>& faulty) {
  const std::vector<Vec3f> positions = drawable(surface.positions);
  const std::vector<Vec3f> normals = vertex_normals(positions, surface.triangles);
  std::vector<render::Surface> surfaces = {surface_of(positions, normals, {0.80f, 0.80f, 0.78f}),
                                           surface_of(positions, normals, {0.90f, 0.05f, 0.05f})};
  for (const int t : placed_triangles(surface)) {
    const bool is_faulty = std::binary_search(faulty.begin(), faulty.end(), t);
    surfaces[is_faulty ? 1 : 0].triangles.push_back(surface.triangles[t]);
  }
  render::View view;
  view.camera = camera_on(surface, faulty);
  view.sun.direction = view.camera.target - view.camera.eye;  // faults are seen from below too
  render::Rasterizer rasterizer;
  return rasterizer.draw(surfaces, view, picture_size);
}

}  // namespace drape::app

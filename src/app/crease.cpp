#include "app/crease.h"

#include <array>
#include <cmath>
#include <map>

#include "core/rigid_motion.h"

namespace drape::app {

DrawnVertices split_at_seams(const std::vector<Triangle>& triangles,
                             const std::vector<Triangle>& uv_triangles) {
  DrawnVertices vertices;
  std::map<std::array<int, 2>, int> known;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle drawn{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int uv = uv_triangles.empty() ? -1 : uv_triangles[t][k];
      const auto [place, is_new] =
          known.try_emplace({triangles[t][k], uv}, static_cast<int>(vertices.point_of.size()));
      if (is_new) {
        vertices.point_of.push_back(triangles[t][k]);
        vertices.uv_of.push_back(uv);
      }
      drawn[k] = place->second;
    }
    vertices.triangles.push_back(drawn);
  }
  return vertices;
}

// The normal of a triangle, as long as twice its area: the weight it has in sums.
static Vec3 area_normal(const TriangleMesh& mesh, const Triangle& triangle) {
  const Vec3& a = mesh.positions[triangle[0]];
  return (mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a);
}

static std::vector<std::vector<int>> triangles_round_points(const TriangleMesh& mesh) {
  std::vector<std::vector<int>> round(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int point : mesh.triangles[t]) round[point].push_back(static_cast<int>(t));
  }
  return round;
}

// The mean of the normals round a point that are close enough to `own`.
static Vec3f corner_normal(const Vec3& own, const std::vector<int>& round, const std::vector<Vec3>& normals,
                           double least_cosine) {
  Vec3 sum = Vec3::Zero();
  for (int triangle : round) {
    const Vec3& other = normals[triangle];
    if (own.dot(other) >= least_cosine * own.norm() * other.norm()) sum += other;
  }
  return sum.normalized().cast<float>();
}

namespace {

// Builds a surface corner by corner; corners that are alike become one vertex.
class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(const TriangleMesh& mesh) : mesh_(mesh) {}

  int vertex(int point, int uv, const Vec3f& normal) {
    const Key key{point, uv, normal.x(), normal.y(), normal.z()};
    const auto [place, is_new] = known_.try_emplace(key, static_cast<int>(surface_.positions.size()));
    if (is_new) {
      surface_.positions.push_back(mesh_.positions[point].cast<float>());
      surface_.normals.push_back(normal);
      if (uv >= 0) surface_.uvs.push_back(mesh_.uvs[uv].cast<float>());
    }
    return place->second;
  }

  void add(const Triangle& triangle) { surface_.triangles.push_back(triangle); }
  render::Surface take() { return std::move(surface_); }

 private:
  using Key = std::tuple<int, int, float, float, float>;
  const TriangleMesh& mesh_;
  render::Surface surface_;
  std::map<Key, int> known_;
};

}  // namespace

render::Surface surface_with_creases(const TriangleMesh& mesh, double crease_degrees) {
  const double least_cosine = sin_cos_degrees(crease_degrees).second;
  const auto round = triangles_round_points(mesh);
  std::vector<Vec3> normals;
  for (const Triangle& triangle : mesh.triangles) normals.push_back(area_normal(mesh, triangle));
  SurfaceBuilder builder(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle drawn{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int point = mesh.triangles[t][k];
      const int uv = mesh.uv_triangles.empty() ? -1 : mesh.uv_triangles[t][k];
      drawn[k] = builder.vertex(point, uv, corner_normal(normals[t], round[point], normals, least_cosine));
    }
    builder.add(drawn);
  }
  return builder.take();
}

}  // namespace drape::app

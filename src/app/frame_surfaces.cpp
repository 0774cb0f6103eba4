#include "app/frame_surfaces.h"

#include <variant>

#include "app/collider_surface.h"
#include "app/drawn_points.h"
#include "app/view.h"
#include "simulation/colliders.h"

namespace drape::app {

template <typename Item>
static std::vector<Item> gather(const std::vector<Item>& items, const std::vector<int>& indices) {
  std::vector<Item> result;
  result.reserve(indices.size());
  for (int index : indices) result.push_back(items[static_cast<std::size_t>(index)]);
  return result;
}

static std::vector<Vec2f> to_float(const std::vector<Vec2>& values) {
  std::vector<Vec2f> result;
  for (const Vec2& value : values) result.push_back(value.cast<float>());
  return result;
}

static PreparedCloth prepare_cloth(const ClothDescription& cloth, std::size_t first_point) {
  const TriangleMesh& mesh = cloth.input.mesh;
  PreparedCloth prepared;
  prepared.first_point = first_point;
  prepared.point_count = mesh.positions.size();
  prepared.material = cloth.look.material;
  if (cloth.look.subdivide > 0) prepared.subdivision.emplace(mesh, cloth.look.subdivide);
  const auto& subdivision = prepared.subdivision;
  prepared.triangles = subdivision ? subdivision->triangles() : mesh.triangles;
  prepared.vertices =
      split_at_seams(prepared.triangles, subdivision ? subdivision->uv_triangles() : mesh.uv_triangles);
  if (!mesh.uvs.empty()) {
    prepared.uvs = gather(subdivision ? subdivision->uvs() : to_float(mesh.uvs), prepared.vertices.uv_of);
  }
  return prepared;
}

PreparedScene prepare_scene(const SceneDescription& scene) {
  PreparedScene prepared;
  std::size_t first_point = 0;
  for (const ClothDescription& cloth : scene.cloths) {
    prepared.cloths.push_back(prepare_cloth(cloth, first_point));
    first_point += prepared.cloths.back().point_count;
  }
  std::size_t first_collider_point = 0;
  for (const ColliderDescription& collider : scene.colliders) {
    const bool is_plane = std::holds_alternative<PlaneShape>(collider.input.shape);
    prepared.solids.push_back(certified_collider(collider.input.shape));
    prepared.colliders.push_back({collider_surface(collider), is_plane, collider.visible, {}, 0});
    if (!deforms(collider.input)) continue;
    prepared.colliders.back().deforming = collider;
    prepared.colliders.back().first_point = first_collider_point;
    first_collider_point += prepared.solids.back().surface->positions.size();
  }
  return prepared;
}

static void take_shape(const PreparedCollider& collider, const CachedFrame& frame, TriangleMesh& mesh) {
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    mesh.positions[v] = frame.collider_points[collider.first_point + v].cast<double>();
}

std::vector<CertifiedCollider> solids_in(const PreparedScene& scene, const CachedFrame& frame) {
  std::vector<CertifiedCollider> solids = scene.solids;
  for (std::size_t i = 0; i < solids.size(); ++i)
    if (scene.colliders[i].deforming) take_shape(scene.colliders[i], frame, *solids[i].surface);
  return solids;
}

static render::Surface surface_in(const PreparedCollider& collider, const CachedFrame& frame) {
  if (!collider.deforming) return collider.surface;
  ColliderDescription shaped = *collider.deforming;
  take_shape(collider, frame, std::get<MeshShape>(shaped.input.shape).mesh);
  return collider_surface(shaped);
}

static render::Surface cloth_surface(const PreparedCloth& cloth, const std::vector<Vec3f>& positions) {
  render::Surface surface;
  surface.normals = gather(vertex_normals(positions, cloth.triangles), cloth.vertices.point_of);
  surface.positions = gather(positions, cloth.vertices.point_of);
  surface.uvs = cloth.uvs;
  surface.triangles = cloth.vertices.triangles;
  surface.material = cloth.material;
  surface.two_sided = true;
  return surface;
}

std::vector<render::Surface> frame_surfaces(const PreparedScene& scene, const CachedFrame& frame) {
  std::vector<render::Surface> surfaces;
  const std::vector<std::vector<Vec3f>> points = drawn_points(scene, frame);
  for (std::size_t i = 0; i < scene.cloths.size(); ++i)
    surfaces.push_back(cloth_surface(scene.cloths[i], points[i]));
  for (std::size_t i = 0; i < scene.colliders.size(); ++i) {
    const PreparedCollider& collider = scene.colliders[i];
    const RigidPose& pose = frame.collider_poses[i];
    const bool is_ground = collider.is_plane && is_level(pose);  // which frame_view takes care of
    if (collider.visible && !is_ground) surfaces.push_back(posed(surface_in(collider, frame), pose));
  }
  return surfaces;
}

}  // namespace drape::app

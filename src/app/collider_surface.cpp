#include "app/collider_surface.h"

#include "app/crease.h"
#include "mesh/loop_subdivision.h"
#include "mesh/primitives.h"

namespace drape::app {

static constexpr int segments = 64;  // round a sphere: smooth at the size of a picture
static constexpr int rings = 32;
static constexpr double plane_size = 4;       // metres; a plane has no end, but a picture of it must
static constexpr double crease_degrees = 40;  // a box has edges, a cylinder of ten sides is still round

namespace {
struct MeshOf {
  TriangleMesh operator()(const PlaneShape&) const { return make_grid({plane_size, plane_size}, {2, 2}); }
  TriangleMesh operator()(const SphereShape& sphere) const {
    return make_sphere(sphere.radius, segments, rings);
  }
  TriangleMesh operator()(const BoxShape& box) const { return make_box(box.size); }
  TriangleMesh operator()(const CylinderShape& cylinder) const {
    return make_cylinder(cylinder.radius, cylinder.height, cylinder_segments);
  }
  TriangleMesh operator()(const CapsuleShape& capsule) const {
    const Vec3 half(0, capsule.length / 2, 0);
    return make_capsule(-half, half, capsule.radius, segments, rings);
  }
  TriangleMesh operator()(const MeshShape& shape) const { return shape.mesh; }
};
}  // namespace

TriangleMesh collider_mesh(const ColliderShape& shape) { return std::visit(MeshOf{}, shape); }

static TriangleMesh subdivided(const TriangleMesh& mesh, int levels) {
  const LoopSubdivision subdivision(mesh, levels);
  std::vector<Vec3f> coarse;
  for (const Vec3& position : mesh.positions) coarse.push_back(position.cast<float>());
  TriangleMesh fine;
  for (const Vec3f& position : subdivision.apply(coarse)) fine.positions.push_back(position.cast<double>());
  for (const Vec2f& uv : subdivision.uvs()) fine.uvs.push_back(uv.cast<double>());
  fine.triangles = subdivision.triangles();
  fine.uv_triangles = subdivision.uv_triangles();
  return fine;
}

// Only meshes of the user's are subdivided: the others are fine enough, and a box must keep its edges.
render::Surface collider_surface(const ColliderDescription& collider) {
  TriangleMesh mesh = collider_mesh(collider.input.shape);
  const bool is_users = std::holds_alternative<MeshShape>(collider.input.shape);
  if (is_users && collider.look.subdivide > 0) mesh = subdivided(mesh, collider.look.subdivide);
  render::Surface surface = surface_with_creases(mesh, crease_degrees);
  surface.material = collider.look.material;
  surface.two_sided = std::holds_alternative<PlaneShape>(collider.input.shape);
  return surface;
}

render::Surface posed(const render::Surface& surface, const RigidPose& pose) {
  render::Surface result = surface;
  for (Vec3f& position : result.positions) position = pose(position.cast<double>()).cast<float>();
  for (Vec3f& normal : result.normals) normal = (pose.rotation * normal.cast<double>()).cast<float>();
  return result;
}

}  // namespace drape::app

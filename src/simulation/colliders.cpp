#include "simulation/colliders.h"

#include "mesh/primitives.h"
#include "mesh/topology.h"

namespace drape {
namespace {

ColliderPrimitives mesh_primitives(const TriangleMesh& mesh) {
  ColliderPrimitives primitives{mesh.positions, {}, mesh.triangles, 0};
  const Topology topology = build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles);
  for (const Edge& edge : topology.edges) primitives.edges.push_back(edge.vertices);
  return primitives;
}

struct MakePrimitives {
  ColliderPrimitives operator()(const PlaneShape&) const { return {}; }
  ColliderPrimitives operator()(const SphereShape& sphere) const {
    return {{Vec3::Zero()}, {}, {}, sphere.radius};
  }
  ColliderPrimitives operator()(const BoxShape& box) const { return mesh_primitives(make_box(box.size)); }
  ColliderPrimitives operator()(const CylinderShape& cylinder) const {
    return mesh_primitives(make_cylinder(cylinder.radius, cylinder.height, cylinder_segments));
  }
  ColliderPrimitives operator()(const CapsuleShape& capsule) const {
    const Vec3 half(0, 0.5 * capsule.length, 0);
    return {{-half, half}, {{0, 1}}, {}, capsule.radius};
  }
  ColliderPrimitives operator()(const MeshShape& shape) const { return mesh_primitives(shape.mesh); }
};

}  // namespace

ColliderPrimitives collider_primitives(const ColliderShape& shape) {
  return std::visit(MakePrimitives{}, shape);
}

}  // namespace drape

#include "app/surface_check.h"

#include <algorithm>

#include "app/collider_surface.h"
#include "core/parallel.h"

namespace drape::app {

namespace {

struct SolidOf {
  std::optional<Solid> operator()(const PlaneShape&) const { return HalfSpace{}; }
  std::optional<Solid> operator()(const SphereShape& sphere) const {
    return RoundedSegment{Vec3::Zero(), Vec3::Zero(), sphere.radius};
  }
  std::optional<Solid> operator()(const CapsuleShape& capsule) const {
    const Vec3 half(0, 0.5 * capsule.length, 0);
    return RoundedSegment{-half, half, capsule.radius};
  }
  std::optional<Solid> operator()(const BoxShape& box) const { return convex_solid(collider_mesh(box)); }
  std::optional<Solid> operator()(const CylinderShape& cylinder) const {
    return convex_solid(collider_mesh(cylinder));
  }
  // Which side of an open mesh is inside, nobody knows.
  std::optional<Solid> operator()(const MeshShape&) const { return std::nullopt; }
};

}  // namespace

// Spheres, capsules and planes are exact: the triangles that they are drawn with would be another collider.
CertifiedCollider certified_collider(const ColliderShape& shape) {
  CertifiedCollider collider{std::visit(SolidOf{}, shape), std::nullopt};
  const bool is_of_triangles = !collider.solid || std::holds_alternative<ConvexSolid>(*collider.solid);
  if (is_of_triangles) collider.surface = collider_mesh(shape);
  return collider;
}

CertifiedSurface certify(const ClothSurface& surface) {
  SurfaceCertificate certificate = certify_surface(surface.positions, surface.triangles);
  CertifiedSurface certified;
  certified.is_finite = certificate.is_finite;
  certified.figures.intersecting_pairs = static_cast<int>(certificate.intersecting.size());
  certified.figures.smallest_gap = certificate.smallest_gap.distance;
  certified.intersecting = std::move(certificate.intersecting);
  return certified;
}

// For each triangle how deep it is in the solid.
static std::vector<double> depths(const ClothSurface& surface, const Solid& solid, const RigidPose& pose) {
  std::vector<Vec3> points;
  for (const Vec3& p : surface.positions)
    points.push_back(pose.rotation.transpose() * (p - pose.translation));
  std::vector<double> depth(surface.triangles.size());
  parallel_for_each(depth.size(), 1024, [&](std::size_t t) {
    const auto& [a, b, c] = surface.triangles[t];
    depth[t] = depth_in(solid, {points[a], points[b], points[c]});
  });
  return depth;
}

static std::vector<int> triangles_at(const ClothSurface& surface, const TriangleMesh& mesh,
                                     const RigidPose& pose) {
  std::vector<Vec3> points;
  for (const Vec3& p : mesh.positions) points.push_back(pose(p));
  return triangles_that_meet(surface.positions, surface.triangles, points, mesh.triangles);
}

static void sort_out(std::vector<int>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

namespace {

struct InCollider {
  std::vector<int> triangles;  // ascending
  double deepest = 0;          // m
};

}  // namespace

static InCollider judge_against(const CertifiedCollider& collider, const RigidPose& pose,
                                const ClothSurface& surface) {
  InCollider in;
  if (collider.surface) in.triangles = triangles_at(surface, *collider.surface, pose);
  if (!collider.solid) return in;
  const std::vector<double> depth = depths(surface, *collider.solid, pose);
  for (std::size_t t = 0; t < depth.size(); ++t) {
    if (depth[t] > 0) in.triangles.push_back(static_cast<int>(t));
    in.deepest = std::max(in.deepest, depth[t]);
  }
  sort_out(in.triangles);
  return in;
}

std::vector<int> triangles_in(const ClothSurface& surface, const CertifiedCollider& collider,
                              const RigidPose& pose) {
  return judge_against(collider, pose, surface).triangles;
}

void forget_pairs_within(const std::vector<int>& part_ends, CertifiedSurface& certified) {
  const auto part_of = [&](int t) { return std::upper_bound(part_ends.begin(), part_ends.end(), t); };
  std::erase_if(certified.intersecting,
                [&](const TrianglePair& pair) { return part_of(pair.first) == part_of(pair.second); });
  certified.figures.intersecting_pairs = static_cast<int>(certified.intersecting.size());
}

bool is_clean(const CertifiedSurface& surface) {
  return surface.is_finite && surface.intersecting.empty() && surface.in_colliders.empty();
}

CertifiedSurface certify(const ClothSurface& surface, const std::vector<CertifiedCollider>& colliders,
                         const std::vector<RigidPose>& poses) {
  CertifiedSurface certified = certify(surface);
  std::vector<int>& found = certified.in_colliders;
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    const InCollider in = judge_against(colliders[i], poses[i], surface);
    found.insert(found.end(), in.triangles.begin(), in.triangles.end());
    certified.figures.collider_depth = std::max(certified.figures.collider_depth, in.deepest);
  }
  sort_out(found);
  certified.figures.collider_triangles = static_cast<int>(found.size());
  return certified;
}

}  // namespace drape::app

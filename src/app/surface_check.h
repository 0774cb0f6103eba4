#pragma once

#include <optional>
#include <vector>

#include "certificate/solid.h"
#include "certificate/surface_certificate.h"
#include "core/rigid_motion.h"
#include "simulation/input.h"

namespace drape::app {

// All cloth of a frame as one surface.
struct ClothSurface {
  std::vector<Vec3> positions;  // m
  std::vector<Triangle> triangles;
};

// What there is to say of a surface, in figures.
struct SurfaceFigures {
  int intersecting_pairs = 0;
  double smallest_gap = 0;     // m, between triangles without a common vertex; infinite where there are none
  int collider_triangles = 0;  // triangles that are in a collider, or meet one
  double collider_depth = 0;   // m: the deepest, in colliders that are no meshes
};

// A surface, and the triangles of it that ought not to be where they are.
struct CertifiedSurface {
  SurfaceFigures figures;
  bool is_finite = true;
  std::vector<TrianglePair> intersecting;
  std::vector<int> in_colliders;  // ascending
};

// A collider as far as it can be judged by.
struct CertifiedCollider {
  std::optional<Solid> solid;           // in its own frame; none for a mesh
  std::optional<TriangleMesh> surface;  // in its own frame, where it is one of triangles
};

CertifiedCollider certified_collider(const ColliderShape& shape);

// The triangles of a surface that are in a collider, or meet its own, ascending.
std::vector<int> triangles_in(const ClothSurface& surface, const CertifiedCollider& collider,
                              const RigidPose& pose);

// Whether all is finite, nothing meets anything, and nothing is in a collider.
bool is_clean(const CertifiedSurface& surface);

// Forgets the pairs of triangles of one and the same part. The parts follow one another; `part_ends` are the
// numbers of triangles up to and with each.
void forget_pairs_within(const std::vector<int>& part_ends, CertifiedSurface& certified);

// Judges a surface by itself and, where they are given, against colliders at their poses.
CertifiedSurface certify(const ClothSurface& surface);
CertifiedSurface certify(const ClothSurface& surface, const std::vector<CertifiedCollider>& colliders,
                         const std::vector<RigidPose>& poses);

}  // namespace drape::app

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/frame_surfaces.h"
#include "certificate/solid.h"
#include "certificate/surface_certificate.h"
#include "scene/description.h"
#include "simulation/cache.h"

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

struct FrameCertificate {
  std::string name;  // of the frame: its number, or the file
  bool is_finite = true;
  double smallest_stretch = 1;
  double largest_stretch = 1;
  SurfaceFigures simulated;
  std::optional<SurfaceFigures> drawn;  // where what is drawn is another surface: subdivided
};

// Whether all is finite, nothing meets anything, and nothing is in a collider.
bool is_certified(const FrameCertificate& certificate);

// A collider as far as it can be judged by.
struct CertifiedCollider {
  std::optional<Solid> solid;           // in its own frame; none for a mesh
  std::optional<TriangleMesh> surface;  // in its own frame, where it is one of triangles
};

// What is the same in all frames of a scene.
struct CertifiedScene {
  PreparedScene drawn;
  bool is_subdivided = false;
  ClothSurface rest;
  std::vector<CertifiedCollider> colliders;
};
CertifiedScene prepare_certificate(const SceneDescription& scene);

// The surfaces of a frame: as simulated, and as drawn.
ClothSurface simulated_surface(const CertifiedScene& scene, const CachedFrame& frame);
ClothSurface drawn_surface(const CertifiedScene& scene, const CachedFrame& frame);

// Judges a surface by itself and, where a scene is given, against its colliders as they are in the frame.
CertifiedSurface certify(const ClothSurface& surface);
CertifiedSurface certify(const ClothSurface& surface, const CertifiedScene& scene, const CachedFrame& frame);

FrameCertificate certify_frame(const CertifiedScene& scene, const CachedFrame& frame);

}  // namespace drape::app

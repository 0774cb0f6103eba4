#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/frame_surfaces.h"
#include "app/surface_check.h"
#include "scene/description.h"
#include "simulation/cache.h"

namespace drape::app {

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

// What is the same in all frames of a scene.
struct CertifiedScene {
  PreparedScene drawn;
  bool is_subdivided = false;
  ClothSurface rest;
  bool self_collision = true;                   // without it, what a cloth does to itself is not judged
  std::vector<int> simulated_ends, drawn_ends;  // numbers of triangles up to and with each cloth
};
CertifiedScene prepare_certificate(const SceneDescription& scene);

// The surfaces of a frame: as simulated, and as drawn.
ClothSurface simulated_surface(const CertifiedScene& scene, const CachedFrame& frame);
ClothSurface drawn_surface(const CertifiedScene& scene, const CachedFrame& frame);

// What is wrong with them, if anything is.
CertifiedSurface certify_simulated(const CertifiedScene& scene, const CachedFrame& frame);
CertifiedSurface certify_drawn(const CertifiedScene& scene, const CachedFrame& frame);

FrameCertificate certify_frame(const CertifiedScene& scene, const CachedFrame& frame);

}  // namespace drape::app

#pragma once

#include <optional>
#include <vector>

#include "app/crease.h"
#include "app/surface_check.h"
#include "mesh/loop_subdivision.h"
#include "render/view.h"
#include "scene/description.h"
#include "simulation/cache.h"

namespace drape::app {

// A cloth's part of what is the same in all frames.
struct PreparedCloth {
  std::size_t first_point = 0;  // in CachedFrame::positions
  std::size_t point_count = 0;
  std::optional<LoopSubdivision> subdivision;  // nothing: drawn as it is simulated
  std::vector<Triangle> triangles;             // of the points, or of the refined ones
  DrawnVertices vertices;
  std::vector<Vec2f> uvs;  // one for each drawn vertex, or empty
  render::Material material;
};

// A collider in its own frame.
struct PreparedCollider {
  render::Surface surface;
  bool is_plane = false;
  bool visible = true;
  std::optional<ColliderDescription> deforming;  // where its surface is another one in each frame
  std::size_t first_point = 0;                   // of it, in CachedFrame::collider_points
};

// What is drawn of a scene, as far as it is the same in all frames. Any number of threads may read it.
struct PreparedScene {
  std::vector<PreparedCloth> cloths;
  std::vector<PreparedCollider> colliders;
  std::vector<CertifiedCollider> solids;  // what smoothed cloth must not enter, one for each collider
};
PreparedScene prepare_scene(const SceneDescription& scene);

// The colliders as they are in a frame, for the certificate: those that deform in their shapes of then.
std::vector<CertifiedCollider> solids_in(const PreparedScene& scene, const CachedFrame& frame);

// The surfaces of one frame.
std::vector<render::Surface> frame_surfaces(const PreparedScene& scene, const CachedFrame& frame);

}  // namespace drape::app

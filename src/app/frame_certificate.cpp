#include "app/frame_certificate.h"

#include "app/drawn_points.h"

namespace drape::app {

static bool is_clean(const SurfaceFigures& figures) {
  return figures.intersecting_pairs == 0 && figures.collider_triangles == 0;
}

bool is_certified(const FrameCertificate& certificate) {
  return certificate.is_finite && is_clean(certificate.simulated) &&
         (!certificate.drawn || is_clean(*certificate.drawn));
}

static void append(std::vector<Triangle>& triangles, const std::vector<Triangle>& more, std::size_t first) {
  const int offset = static_cast<int>(first);
  for (const auto& [a, b, c] : more) triangles.push_back({a + offset, b + offset, c + offset});
}

CertifiedScene prepare_certificate(const SceneDescription& scene) {
  CertifiedScene certified;
  certified.drawn = prepare_scene(scene);
  certified.self_collision = scene.self_collision;
  int drawn_end = 0;
  for (const PreparedCloth& cloth : certified.drawn.cloths)
    certified.drawn_ends.push_back(drawn_end += static_cast<int>(cloth.triangles.size()));
  for (const ClothDescription& cloth : scene.cloths) {
    const TriangleMesh& mesh = cloth.input.mesh;
    ClothSurface& rest = certified.rest;
    append(rest.triangles, mesh.triangles, rest.positions.size());
    rest.positions.insert(rest.positions.end(), mesh.positions.begin(), mesh.positions.end());
    certified.simulated_ends.push_back(static_cast<int>(rest.triangles.size()));
    certified.is_subdivided = certified.is_subdivided || cloth.look.subdivide > 0;
  }
  return certified;
}

ClothSurface simulated_surface(const CertifiedScene& scene, const CachedFrame& frame) {
  ClothSurface surface{{}, scene.rest.triangles};
  for (const Vec3f& p : frame.positions) surface.positions.push_back(p.cast<double>());
  return surface;
}

ClothSurface drawn_surface(const CertifiedScene& scene, const CachedFrame& frame) {
  return as_one_surface(scene.drawn, drawn_points(scene.drawn, frame));
}

static CertifiedSurface judge(const CertifiedScene& scene, const CachedFrame& frame,
                              const ClothSurface& surface, const std::vector<int>& ends) {
  CertifiedSurface certified = certify(surface, solids_in(scene.drawn, frame), frame.collider_poses);
  if (!scene.self_collision) forget_pairs_within(ends, certified);
  return certified;
}

CertifiedSurface certify_simulated(const CertifiedScene& scene, const CachedFrame& frame) {
  return judge(scene, frame, simulated_surface(scene, frame), scene.simulated_ends);
}

CertifiedSurface certify_drawn(const CertifiedScene& scene, const CachedFrame& frame) {
  return judge(scene, frame, drawn_surface(scene, frame), scene.drawn_ends);
}

FrameCertificate certify_frame(const CertifiedScene& scene, const CachedFrame& frame) {
  const CertifiedSurface simulated = certify_simulated(scene, frame);
  const ClothSurface surface = simulated_surface(scene, frame);
  const StretchRange stretch = edge_stretch(scene.rest.positions, surface.positions, surface.triangles);
  FrameCertificate certificate{
      std::to_string(frame.frame), simulated.is_finite, stretch.smallest, stretch.largest,
      simulated.figures,           std::nullopt};
  if (!scene.is_subdivided) return certificate;
  const CertifiedSurface drawn = certify_drawn(scene, frame);
  certificate.is_finite = certificate.is_finite && drawn.is_finite;
  certificate.drawn = drawn.figures;
  return certificate;
}

}  // namespace drape::app

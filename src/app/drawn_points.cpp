#include "app/drawn_points.h"

#include "app/fault_picture.h"

namespace drape::app {
namespace {

using CloudOfEach = std::vector<std::vector<Vec3f>>;  // points of each cloth

std::vector<Vec3f> simulated_points(const PreparedCloth& cloth, const CachedFrame& frame) {
  const auto begin = frame.positions.begin() + static_cast<std::ptrdiff_t>(cloth.first_point);
  return {begin, begin + static_cast<std::ptrdiff_t>(cloth.point_count)};
}

// The two surfaces that what is drawn lies between.
struct Range {
  CloudOfEach flat, smooth;
};

Range range_of(const PreparedScene& scene, const CachedFrame& frame) {
  Range range;
  for (const PreparedCloth& cloth : scene.cloths) {
    const std::vector<Vec3f> points = simulated_points(cloth, frame);
    range.flat.push_back(cloth.subdivision ? cloth.subdivision->apply_flat(points) : points);
    range.smooth.push_back(cloth.subdivision ? cloth.subdivision->apply(points) : points);
  }
  return range;
}

// `shares` of the way from flat to smooth, of all points one after another. All of it is smooth to the bit.
CloudOfEach between(const Range& range, const std::vector<float>& shares) {
  CloudOfEach points = range.smooth;
  std::size_t i = 0;
  for (std::size_t c = 0; c < points.size(); ++c)
    for (std::size_t v = 0; v < points[c].size(); ++v, ++i)
      if (shares[i] < 1) points[c][v] = range.flat[c][v] + shares[i] * (points[c][v] - range.flat[c][v]);
  return points;
}

// Half the share at the corners of the faulty triangles, or none where that is little already.
void flatten(const ClothSurface& surface, const std::vector<int>& faulty, std::vector<float>& shares) {
  constexpr float little = 0.2f;
  std::vector<char> chosen(shares.size(), 0);
  for (const int triangle : faulty)
    for (const int v : surface.triangles[triangle]) chosen[v] = 1;
  for (std::size_t v = 0; v < shares.size(); ++v)
    if (chosen[v]) shares[v] = shares[v] < little ? 0 : shares[v] / 2;
}

// The triangles that share a corner with one of `triangles`, and these.
std::vector<int> grown(const ClothSurface& surface, const std::vector<int>& triangles) {
  std::vector<char> touched(surface.positions.size(), 0);
  for (const int triangle : triangles)
    for (const int v : surface.triangles[triangle]) touched[v] = 1;
  std::vector<int> result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    if (touched[a] || touched[b] || touched[c]) result.push_back(static_cast<int>(t));
  }
  return result;
}

}  // namespace

ClothSurface as_one_surface(const PreparedScene& scene, const CloudOfEach& points) {
  ClothSurface surface;
  for (std::size_t i = 0; i < scene.cloths.size(); ++i) {
    const int first = static_cast<int>(surface.positions.size());
    for (const auto& [a, b, c] : scene.cloths[i].triangles)
      surface.triangles.push_back({a + first, b + first, c + first});
    for (const Vec3f& p : points[i]) surface.positions.push_back(p.cast<double>());
  }
  return surface;
}

std::vector<std::vector<Vec3f>> drawn_points(const PreparedScene& scene, const CachedFrame& frame) {
  constexpr int most_rounds = 12, rounds_before_growing = 4;
  const Range range = range_of(scene, frame);
  if (range.flat == range.smooth) return range.smooth;
  const std::vector<CertifiedCollider> solids = solids_in(scene, frame);
  ClothSurface surface = as_one_surface(scene, range.smooth);
  std::vector<float> shares(surface.positions.size(), 1.0f);
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<int> faulty = faulty_triangles(surface, certify(surface, solids, frame.collider_poses));
    if (faulty.empty()) return between(range, shares);
    if (round >= rounds_before_growing) faulty = grown(surface, faulty);
    flatten(surface, faulty, shares);
    surface = as_one_surface(scene, between(range, shares));
  }
  return range.flat;
}

}  // namespace drape::app

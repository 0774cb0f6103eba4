#include "certificate/surface_certificate.h"

#include <algorithm>
#include <cmath>

#include "certificate/box_tree.h"
#include "certificate/triangle_distance.h"
#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t triangles_in_a_block = 512;
constexpr std::size_t triangles_to_a_sample = 16;

TrianglePoints points_of(const std::vector<Vec3>& positions, const Triangle& t) {
  return {positions[t[0]], positions[t[1]], positions[t[2]]};
}

bool is_finite(const TrianglePoints& t) { return t[0].allFinite() && t[1].allFinite() && t[2].allFinite(); }

// The triangles that have a place in space, and the tree of their boxes.
struct PlacedTriangles {
  const std::vector<Vec3>& positions;
  const std::vector<Triangle>& triangles;
  std::vector<int> numbers;  // of the tree's items
  BoxTree tree;

  int number_at(std::size_t place) const { return numbers[tree.item(place)]; }
  TrianglePoints points(int number) const { return points_of(positions, triangles[number]); }
  const BoundingBox& box_at(std::size_t place) const { return tree.box(tree.item(place)); }
};

PlacedTriangles place(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  std::vector<int> numbers;
  std::vector<BoundingBox> boxes;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t) {
    const TrianglePoints points = points_of(positions, triangles[t]);
    if (!is_finite(points)) continue;
    numbers.push_back(t);
    boxes.push_back(box_of(points));
  }
  return {positions, triangles, std::move(numbers), BoxTree(std::move(boxes))};
}

bool has_corner(const Triangle& t, int vertex) { return t[0] == vertex || t[1] == vertex || t[2] == vertex; }

int shared_corners(const Triangle& s, const Triangle& t) {
  return has_corner(t, s[0]) + has_corner(t, s[1]) + has_corner(t, s[2]);
}

// The corners of `t`, beginning with those of `s` that it has too, in the order of `s`.
Triangle shared_first(const Triangle& t, const Triangle& s) {
  Triangle result;
  int count = 0;
  for (const int vertex : s)
    if (has_corner(t, vertex)) result[count++] = vertex;
  for (const int vertex : t)
    if (!has_corner(s, vertex)) result[count++] = vertex;
  return result;
}

bool meet(const PlacedTriangles& placed, const TrianglePair& pair, int shared) {
  if (shared == 3) return true;
  const Triangle s = shared_first(placed.triangles[pair.first], placed.triangles[pair.second]);
  const Triangle t = shared_first(placed.triangles[pair.second], s);
  const TrianglePoints a = points_of(placed.positions, s), b = points_of(placed.positions, t);
  if (shared == 2) return meet_beyond_edge(a, b);
  return shared == 1 ? meet_beyond_vertex(a, b) : triangles_meet(a, b);
}

struct Findings {
  std::vector<TrianglePair> intersecting;
  Gap smallest_gap;
};

// Compares the triangle in place i with those that come after it, as far as they are no farther than the
// smallest gap so far: what meets is at no distance.
void examine(const PlacedTriangles& placed, std::size_t i, Findings& findings) {
  Gap& gap = findings.smallest_gap;
  const auto judge = [&](std::size_t k) {
    const TrianglePair pair = std::minmax(placed.number_at(i), placed.number_at(k));
    const int shared = shared_corners(placed.triangles[pair.first], placed.triangles[pair.second]);
    const bool meets = boxes_overlap(placed.box_at(i), placed.box_at(k)) && meet(placed, pair, shared);
    if (meets) findings.intersecting.push_back(pair);
    if (shared > 0) return;
    const double distance =
        meets ? 0 : triangle_distance(placed.points(pair.first), placed.points(pair.second));
    if (distance < gap.distance) gap = {distance, pair};
  };
  placed.tree.find_near(
      placed.box_at(i), i + 1, [&] { return gap.distance * gap.distance; }, judge);
}

// The gap of a few triangles: with it in hand, the search round all others is short.
Gap sample_gap(const PlacedTriangles& placed) {
  Findings findings;
  for (std::size_t i = 0; i < placed.tree.size(); i += triangles_to_a_sample) examine(placed, i, findings);
  return findings.smallest_gap;
}

Findings examine_all(const PlacedTriangles& placed) {
  const std::size_t count = placed.tree.size();
  Findings all{{}, sample_gap(placed)};
  std::vector<Findings> parts((count + triangles_in_a_block - 1) / triangles_in_a_block, all);
  parallel_blocks(count, triangles_in_a_block, [&](std::size_t begin, std::size_t end, std::size_t block) {
    for (std::size_t i = begin; i < end; ++i) examine(placed, i, parts[block]);
  });
  for (const Findings& part : parts) {
    all.intersecting.insert(all.intersecting.end(), part.intersecting.begin(), part.intersecting.end());
    if (part.smallest_gap.distance < all.smallest_gap.distance) all.smallest_gap = part.smallest_gap;
  }
  std::sort(all.intersecting.begin(), all.intersecting.end());
  return all;
}

}  // namespace

SurfaceCertificate certify_surface(const std::vector<Vec3>& positions,
                                   const std::vector<Triangle>& triangles) {
  Findings findings = examine_all(place(positions, triangles));
  const bool is_finite =
      std::all_of(positions.begin(), positions.end(), [](const Vec3& p) { return p.allFinite(); });
  return {is_finite, std::move(findings.intersecting), findings.smallest_gap};
}

std::vector<TrianglePair> intersecting_triangles(const std::vector<Vec3>& positions,
                                                 const std::vector<Triangle>& triangles) {
  return certify_surface(positions, triangles).intersecting;
}

StretchRange edge_stretch(const std::vector<Vec3>& rest_positions, const std::vector<Vec3>& positions,
                          const std::vector<Triangle>& triangles) {
  StretchRange range{std::numeric_limits<double>::infinity(), 0};
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const double rest = (rest_positions[a] - rest_positions[b]).norm();
      if (rest == 0) continue;
      const double stretch = (positions[a] - positions[b]).norm() / rest;
      if (!std::isfinite(stretch)) return {stretch, stretch};
      range = {std::min(range.smallest, stretch), std::max(range.largest, stretch)};
    }
  return range.largest > 0 ? range : StretchRange{};
}

std::vector<int> triangles_that_meet(const std::vector<Vec3>& positions,
                                     const std::vector<Triangle>& triangles,
                                     const std::vector<Vec3>& other_positions,
                                     const std::vector<Triangle>& other_triangles) {
  const PlacedTriangles placed = place(positions, triangles), other = place(other_positions, other_triangles);
  std::vector<int> found;
  parallel_collect(placed.tree.size(), triangles_in_a_block, found,
                   [&](std::size_t begin, std::size_t end, std::vector<int>& in_block) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const TrianglePoints points = placed.points(placed.number_at(i));
                       bool meets = false;
                       other.tree.find_overlapping(placed.box_at(i), [&](std::size_t k) {
                         meets = meets || triangles_meet(points, other.points(other.number_at(k)));
                       });
                       if (meets) in_block.push_back(placed.number_at(i));
                     }
                   });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace drape

#include "contact/patch_pair.h"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

// More than what sums of ways and distances are rounded by.
constexpr double rounding = 1e-9;

// Primitives of a patch and their boxes.
struct Boxed {
  std::vector<int> items;
  std::vector<Bounds> boxes;
};

struct Listing {
  const ContactGeometry& geometry;
  const std::vector<Vec3>& x;
  double margin;
  double reach;  // of the two bodies, with the margin
  PatchPair& pair;
};

// The patch's points, edges or triangles that are near `region`.
template <typename VerticesOf>
Boxed select(const Listing& listing, const std::vector<int>& items, const Bounds& region,
             const VerticesOf& vertices_of) {
  Boxed chosen;
  chosen.items.reserve(items.size());
  chosen.boxes.reserve(items.size());
  for (const int item : items) {
    const auto& vertices = vertices_of(item);
    const Bounds box = bounds_of(listing.x, vertices);
    if (!near(box, region, listing.reach)) continue;
    chosen.items.push_back(item);
    chosen.boxes.push_back(box);
  }
  return chosen;
}

Boxed select_points(const Listing& listing, const Patch& patch, const Bounds& region) {
  return select(listing, patch.points, region, [](int v) { return std::array{v}; });
}
Boxed select_edges(const Listing& listing, const Patch& patch, const Bounds& region) {
  return select(
      listing, patch.edges, region, [&](int e) -> const auto& { return listing.geometry.edges[e]; });
}
Boxed select_triangles(const Listing& listing, const Patch& patch, const Bounds& region) {
  return select(
      listing, patch.triangles, region, [&](int t) -> const auto& { return listing.geometry.triangles[t]; });
}

void add_pair(const Listing& listing, PairKind kind, const std::array<int, 4>& vertices) {
  const double distance = closest_points(kind, gather(listing.x, vertices)).distance;
  if (distance > listing.reach) return;
  const double thickness = pair_thickness(listing.geometry, kind, vertices);
  PatchPair& list = listing.pair;
  const double expiry = expiry_of(list.radius, thickness, list.travelled, distance);
  if (expiry > list.travelled + listing.margin) return;
  list.pairs.push_back({vertices, thickness, expiry});
  list.least_thickness = std::min(list.least_thickness, thickness);
}

void list_point_triangle(const Listing& listing, const Boxed& points, const Boxed& triangles) {
  for (std::size_t i = 0; i < points.items.size(); ++i)
    for (std::size_t k = 0; k < triangles.items.size(); ++k) {
      if (!near(points.boxes[i], triangles.boxes[k], listing.reach)) continue;
      const int p = points.items[i];
      const auto& [a, b, c] = listing.geometry.triangles[triangles.items[k]];
      if (p != a && p != b && p != c) add_pair(listing, PairKind::point_triangle, {p, a, b, c});
    }
}

void list_edges(const Listing& listing, int first, int second) {
  const auto& [a, b] = listing.geometry.edges[std::min(first, second)];
  const auto& [c, d] = listing.geometry.edges[std::max(first, second)];
  if (a != c && a != d && b != c && b != d) add_pair(listing, PairKind::edge_edge, {a, b, c, d});
}

void list_edge_edge(const Listing& listing, const Boxed& first, const Boxed& second, bool same) {
  for (std::size_t i = 0; i < first.items.size(); ++i)
    for (std::size_t k = same ? i + 1 : 0; k < second.items.size(); ++k)
      if (near(first.boxes[i], second.boxes[k], listing.reach))
        list_edges(listing, first.items[i], second.items[k]);
}

void list_within(const Listing& listing, const Patch& patch, const Bounds& box) {
  list_point_triangle(listing, select_points(listing, patch, box), select_triangles(listing, patch, box));
  listing.pair.edges_begin = listing.pair.pairs.size();
  const Boxed edges = select_edges(listing, patch, box);
  list_edge_edge(listing, edges, edges, true);
}

void list_between(const Listing& listing, const Patch& a, const Bounds& box_a, const Patch& b,
                  const Bounds& box_b) {
  list_point_triangle(listing, select_points(listing, a, box_b), select_triangles(listing, b, box_a));
  list_point_triangle(listing, select_points(listing, b, box_a), select_triangles(listing, a, box_b));
  listing.pair.edges_begin = listing.pair.pairs.size();
  list_edge_edge(listing, select_edges(listing, a, box_b), select_edges(listing, b, box_a), false);
}

bool has_bare_edges(const ContactBody& body) { return body.triangle_begin == body.triangle_end; }

double distance_of(const Bounds& a, const Bounds& b) {
  return (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(0).norm();
}

}  // namespace

double contact_reach(const ContactGeometry& geometry, int body_a, int body_b) {
  return pair_radius(geometry, body_a, body_b) +
         (1 + arrival_share) * largest_thickness(geometry, body_a, body_b) + rounding;
}

ContactPair contact_pair(const PatchPair& patches, std::size_t i) {
  const PairKind kind = i < patches.edges_begin ? PairKind::point_triangle : PairKind::edge_edge;
  const ListedPair& pair = patches.pairs[i];
  return {pair.vertices,  kind,           patches.meets_collider, patches.counts_edge_ends,
          pair.thickness, patches.radius, patches.friction};
}

double least_distance(const PatchPair& patches, std::size_t i) {
  const ListedPair& pair = patches.pairs[i];
  return pair.expiry - patches.travelled + patches.radius + (1 + arrival_share) * pair.thickness;
}

double expiry_of(double radius, double thickness, double travelled, double distance) {
  return travelled + distance - radius - (1 + arrival_share) * thickness - rounding;
}

void update_next(PatchPair& patches) {
  patches.next_contact = std::numeric_limits<double>::infinity();
  for (const ListedPair& pair : patches.pairs)
    patches.next_contact = std::min(patches.next_contact, pair.expiry);
  patches.next_collision = patches.next_contact + patches.least_thickness;
}

void list_pairs(const ContactGeometry& geometry, const std::vector<Patch>& patches,
                const std::vector<Vec3>& x, double margin, PatchPair& pair) {
  const Patch &a = patches[pair.first], &b = patches[pair.second];
  const double reach = contact_reach(geometry, a.body, b.body);
  const Bounds box_a = bounds_of(x, a.vertices), box_b = bounds_of(x, b.vertices);
  pair.pairs.clear();
  pair.edges_begin = 0;
  pair.least_thickness = std::numeric_limits<double>::infinity();
  pair.valid_until = pair.travelled + std::max(margin, distance_of(box_a, box_b) - reach);
  pair.meets_collider = !geometry.bodies[a.body].is_cloth || !geometry.bodies[b.body].is_cloth;
  pair.counts_edge_ends = has_bare_edges(geometry.bodies[a.body]) || has_bare_edges(geometry.bodies[b.body]);
  pair.radius = pair_radius(geometry, a.body, b.body);
  pair.friction = pair_friction(geometry, a.body, b.body);
  const Listing listing{geometry, x, margin, reach + margin, pair};
  if (pair.first == pair.second)
    list_within(listing, a, box_a);
  else if (near(box_a, box_b, listing.reach))
    list_between(listing, a, box_a, b, box_b);
  update_next(pair);
}

}  // namespace drape

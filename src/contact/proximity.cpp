#include "contact/proximity.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t block = 256;

// The vertices that a list has boxes for: all, or one cloth's.
std::pair<int, int> vertex_range(const ContactGeometry& geometry, const ProximityList& list) {
  if (list.own_body < 0) return {0, static_cast<int>(geometry.vertex_body.size())};
  const ContactBody& body = geometry.bodies[list.own_body];
  return {body.vertex_begin, body.vertex_end};
}

// What a body's primitives are grown by, so that boxes of pairs within their thickness overlap.
double half_thickness(const ContactGeometry& geometry, const ContactBody& body) {
  if (body.is_cloth) return 0.5 * body.thickness;
  double thickest = 0;
  for (const ContactBody& other : geometry.bodies) thickest = std::max(thickest, other.thickness);
  return body.radius + 0.5 * thickest;
}

float rounded_down(double value) { return std::nextafter(static_cast<float>(value), -INFINITY); }
float rounded_up(double value) { return std::nextafter(static_cast<float>(value), INFINITY); }

struct Boxes {
  std::vector<Box> vertices, edges, triangles;
  std::vector<Box> bodies;
};

Box hull(const std::vector<Box>& boxes, std::initializer_list<int> members) {
  Box box = empty_box();
  for (const int member : members) include(box, boxes[member]);
  return box;
}

Box vertex_box(const ProximityList& list, int v, double growth) {
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lower[k] = rounded_down(list.lower[v][k] - growth);
    box.upper[k] = rounded_up(list.upper[v][k] + growth);
  }
  return box;
}

Boxes primitive_boxes(const ContactGeometry& geometry, const ProximityList& list) {
  Boxes boxes{std::vector<Box>(geometry.vertex_body.size(), empty_box()),
              std::vector<Box>(geometry.edges.size()), std::vector<Box>(geometry.triangles.size()),
              std::vector<Box>(geometry.bodies.size(), empty_box())};
  const auto [begin, end] = vertex_range(geometry, list);
  for (int v = begin; v < end; ++v) {
    const int body = geometry.vertex_body[v];
    boxes.vertices[v] = vertex_box(list, v, half_thickness(geometry, geometry.bodies[body]));
    include(boxes.bodies[body], boxes.vertices[v]);
  }
  for (std::size_t e = 0; e < geometry.edges.size(); ++e)
    boxes.edges[e] = hull(boxes.vertices, {geometry.edges[e][0], geometry.edges[e][1]});
  for (std::size_t t = 0; t < geometry.triangles.size(); ++t) {
    const Triangle& triangle = geometry.triangles[t];
    boxes.triangles[t] = hull(boxes.vertices, {triangle[0], triangle[1], triangle[2]});
  }
  return boxes;
}

// Primitives begin..end whose boxes touch `region`.
std::vector<int> primitives_in(const std::vector<Box>& boxes, int begin, int end, const Box& region) {
  std::vector<int> found;
  for (int i = begin; i < end; ++i)
    if (overlap(boxes[i], region)) found.push_back(i);
  return found;
}

std::vector<Box> select(const std::vector<Box>& boxes, const std::vector<int>& chosen) {
  std::vector<Box> selected;
  selected.reserve(chosen.size());
  for (const int i : chosen) selected.push_back(boxes[i]);
  return selected;
}

// Everything that building one list passes along.
struct Builder {
  const ContactGeometry& geometry;
  const std::vector<Vec3>& start;
  const std::vector<double>& reach;  // how far from its start each vertex may come in its box
  const Boxes& boxes;
  double cell_size;
  std::vector<ContactPair>& pairs;
};

bool share_a_vertex(const std::array<int, 4>& v, PairKind kind) {
  for (int i = 0; i < first_side(kind); ++i)
    for (int k = first_side(kind); k < 4; ++k)
      if (v[i] == v[k]) return true;
  return false;
}

bool all_kinematic(const ContactGeometry& geometry, const std::array<int, 4>& vertices) {
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](int v) { return geometry.inverse_masses[v] == 0; });
}

// A lower bound of the pair's distance from balls round its sides: cheap, and enough for most.
double distance_bound(const FourPoints& x, PairKind kind) {
  const int n = first_side(kind);
  Vec3 centre[2] = {Vec3::Zero(), Vec3::Zero()};
  for (int i = 0; i < 4; ++i) centre[i < n ? 0 : 1] += x[i] / (i < n ? n : 4 - n);
  double radius[2] = {0, 0};
  for (int i = 0; i < 4; ++i) {
    double& r = radius[i < n ? 0 : 1];
    r = std::max(r, (x[i] - centre[i < n ? 0 : 1]).squaredNorm());
  }
  return (centre[0] - centre[1]).norm() - std::sqrt(radius[0]) - std::sqrt(radius[1]);
}

// How much nearer the two sides can come while their vertices stay in their boxes.
double reach_of(const Builder& builder, PairKind kind, const std::array<int, 4>& v) {
  const auto& reach = builder.reach;
  if (kind == PairKind::point_triangle)
    return reach[v[0]] + std::max({reach[v[1]], reach[v[2]], reach[v[3]]});
  return std::max(reach[v[0]], reach[v[1]]) + std::max(reach[v[2]], reach[v[3]]);
}

void add_pair(const Builder& builder, PairKind kind, const std::array<int, 4>& vertices,
              std::vector<ContactPair>& out) {
  if (share_a_vertex(vertices, kind) || all_kinematic(builder.geometry, vertices)) return;
  const auto [a, b] = pair_bodies(builder.geometry, kind, vertices);
  const double radius = pair_radius(builder.geometry, a, b);
  const double most = radius + largest_thickness(builder.geometry, a, b) + reach_of(builder, kind, vertices);
  const FourPoints start = gather(builder.start, vertices);
  if (distance_bound(start, kind) > most) return;
  const double distance = closest_points(kind, start).distance;
  if (distance > most) return;
  const auto bare_edge = [&](int body) {
    return builder.geometry.bodies[body].triangle_begin == builder.geometry.bodies[body].triangle_end;
  };
  const double thickness = pair_thickness(builder.geometry, kind, vertices);
  out.push_back({vertices, kind, bare_edge(a) || bare_edge(b), thickness, radius,
                 pair_friction(builder.geometry, a, b), distance - radius - 1.02 * thickness});
}

// Pairs of two lists of primitives whose boxes overlap, in the order of the queries.
template <typename MakePair>
void collect_overlaps(const Builder& builder, const std::vector<Box>& items, const std::vector<Box>& queries,
                      const MakePair& make_pair) {
  if (items.empty() || queries.empty()) return;
  const SpatialHash hash(items, builder.cell_size);
  std::vector<ContactPair> found;
  parallel_collect(queries.size(), block, found,
                   [&](std::size_t begin, std::size_t end, std::vector<ContactPair>& out) {
                     for (std::size_t q = begin; q < end; ++q)
                       hash.find(queries[q], [&](int item) { make_pair(item, static_cast<int>(q), out); });
                   });
  builder.pairs.insert(builder.pairs.end(), found.begin(), found.end());
}

void collect_point_triangle(const Builder& builder, const std::vector<int>& points,
                            const std::vector<int>& triangles) {
  collect_overlaps(
      builder, select(builder.boxes.vertices, points), select(builder.boxes.triangles, triangles),
      [&](int p, int t, std::vector<ContactPair>& out) {
        const Triangle& triangle = builder.geometry.triangles[triangles[t]];
        add_pair(builder, PairKind::point_triangle, {points[p], triangle[0], triangle[1], triangle[2]}, out);
      });
}

void collect_edge_edge(const Builder& builder, const std::vector<int>& first, const std::vector<int>& second,
                       bool same) {
  collect_overlaps(builder, select(builder.boxes.edges, first), select(builder.boxes.edges, second),
                   [&](int i, int k, std::vector<ContactPair>& out) {
                     if (same && i >= k) return;
                     const auto& a = builder.geometry.edges[first[i]];
                     const auto& b = builder.geometry.edges[second[k]];
                     add_pair(builder, PairKind::edge_edge, {a[0], a[1], b[0], b[1]}, out);
                   });
}

void collect_within(const Builder& builder, int body_index) {
  const ContactBody& body = builder.geometry.bodies[body_index];
  const Box& region = builder.boxes.bodies[body_index];
  const auto points = primitives_in(builder.boxes.vertices, body.vertex_begin, body.vertex_end, region);
  const auto edges = primitives_in(builder.boxes.edges, body.edge_begin, body.edge_end, region);
  const auto triangles =
      primitives_in(builder.boxes.triangles, body.triangle_begin, body.triangle_end, region);
  collect_point_triangle(builder, points, triangles);
  collect_edge_edge(builder, edges, edges, true);
}

void collect_between(const Builder& builder, int first, int second) {
  const Boxes& boxes = builder.boxes;
  const ContactBody &a = builder.geometry.bodies[first], &b = builder.geometry.bodies[second];
  const Box &region_a = boxes.bodies[second], &region_b = boxes.bodies[first];
  if (!overlap(region_a, region_b)) return;
  collect_point_triangle(builder, primitives_in(boxes.vertices, a.vertex_begin, a.vertex_end, region_a),
                         primitives_in(boxes.triangles, b.triangle_begin, b.triangle_end, region_b));
  collect_point_triangle(builder, primitives_in(boxes.vertices, b.vertex_begin, b.vertex_end, region_b),
                         primitives_in(boxes.triangles, a.triangle_begin, a.triangle_end, region_a));
  collect_edge_edge(builder, primitives_in(boxes.edges, a.edge_begin, a.edge_end, region_a),
                    primitives_in(boxes.edges, b.edge_begin, b.edge_end, region_b), false);
}

void collect_pairs(const Builder& builder, int own_body) {
  if (own_body >= 0) return collect_within(builder, own_body);
  const int bodies = static_cast<int>(builder.geometry.bodies.size());
  for (int a = 0; a < bodies; ++a)
    for (int b = a + 1; b < bodies; ++b)
      if (builder.geometry.bodies[a].is_cloth || builder.geometry.bodies[b].is_cloth)
        collect_between(builder, a, b);
}

std::vector<double> box_reach(const ProximityList& list, const std::vector<Vec3>& start, int begin, int end) {
  std::vector<double> reach(start.size(), 0.0);
  for (int v = begin; v < end; ++v)
    reach[v] = (start[v] - list.lower[v]).cwiseMax(list.upper[v] - start[v]).norm();
  return reach;
}

void build_list(const ContactGeometry& geometry, const StepMotion& motion, double pad, double cell_size,
                ProximityList& list) {
  const Vec3 shift = frame_motion(geometry, list, motion);
  const double room = pad + shift.norm();
  list.frame_shift.setZero();
  list.lower.resize(geometry.vertex_body.size());
  list.upper.resize(geometry.vertex_body.size());
  const auto [begin, end] = vertex_range(geometry, list);
  for (int v = begin; v < end; ++v) {
    const Vec3 moved = motion.end[v] - shift;
    list.lower[v] = motion.start[v].cwiseMin(moved).array() - room;
    list.upper[v] = motion.start[v].cwiseMax(moved).array() + room;
  }
  list.travelled.assign(geometry.vertex_body.size(), 0.0);
  list.pairs.clear();
  const Boxes boxes = primitive_boxes(geometry, list);
  const std::vector<double> reach = box_reach(list, motion.start, begin, end);
  collect_pairs({geometry, motion.start, reach, boxes, cell_size, list.pairs}, list.own_body);
  list.built = true;
}

bool inside(const ProximityList& list, int v, const Vec3& x, double reserve) {
  return (x.array() - reserve >= list.lower[v].array()).all() &&
         (x.array() + reserve <= list.upper[v].array()).all();
}

}  // namespace

Vec3 frame_motion(const ContactGeometry& geometry, const ProximityList& list, const StepMotion& motion) {
  if (list.own_body < 0) return Vec3::Zero();
  const ContactBody& body = geometry.bodies[list.own_body];
  Vec3 sum = Vec3::Zero();
  for (int v = body.vertex_begin; v < body.vertex_end; ++v) sum += motion.end[v] - motion.start[v];
  return sum / (body.vertex_end - body.vertex_begin);
}

bool within_boxes(const ContactGeometry& geometry, const ProximityList& list, const StepMotion& motion) {
  if (!list.built) return false;
  const Vec3 step_shift = frame_motion(geometry, list, motion);
  const Vec3 shift = list.frame_shift + step_shift;
  // The fail-safe may hold a vertex back while the frame moves on.
  const double reserve = step_shift.norm();
  const auto [begin, end] = vertex_range(geometry, list);
  for (int v = begin; v < end; ++v)
    if (!inside(list, v, motion.end[v] - shift, reserve)) return false;
  return true;
}

bool update_proximity(const ContactGeometry& geometry, const StepMotion& motion, double pad, double cell_size,
                      ProximityList& list) {
  if (within_boxes(geometry, list, motion)) return false;
  build_list(geometry, motion, pad, cell_size, list);
  return true;
}

void follow_motion(const ContactGeometry& geometry, const StepMotion& motion, ProximityList& list) {
  const Vec3 shift = frame_motion(geometry, list, motion);
  const auto [begin, end] = vertex_range(geometry, list);
  for (int v = begin; v < end; ++v) list.travelled[v] += (motion.end[v] - motion.start[v] - shift).norm();
  list.frame_shift += shift;
}

}  // namespace drape

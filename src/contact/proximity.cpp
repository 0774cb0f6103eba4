#include "contact/proximity.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/spatial_hash.h"
#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t patch_block = 32;
constexpr std::size_t pair_block = 1024;

// Over how many steps at the present speed a list should last.
constexpr double steps_to_last = 30;

double relative_way(const Bounds& a, const Bounds& b) {
  return (a.upper - b.lower).cwiseMax(b.upper - a.lower).norm();
}

// Where a vertex may be that stops anywhere on its way.
Bounds with_rest(const Bounds& way) { return {way.lower.cwiseMin(0), way.upper.cwiseMax(0)}; }

Bounds way_of(const Patch& patch, const std::vector<Vec4>& vertex_ways) {
  const Vec4& first = vertex_ways[patch.vertices.front()];
  Bounds way{first, first};
  for (const int v : patch.vertices) include(way, vertex_ways[v]);
  return way;
}

void measure_ways(const StepMotion& motion, Proximity& proximity) {
  proximity.vertex_ways.resize(motion.start.size());
  proximity.ways.resize(proximity.patches.size());
  parallel_for_each(motion.start.size(), 1024, [&](std::size_t v) {
    proximity.vertex_ways[v] = padded(motion.end[v] - motion.start[v]);
  });
  parallel_for_each(proximity.patches.size(), patch_block, [&](std::size_t p) {
    proximity.ways[p] = way_of(proximity.patches[p], proximity.vertex_ways);
  });
}

Bounds sum(const Bounds& a, const Bounds& b) { return {a.lower + b.lower, a.upper + b.upper}; }

// Whether each patch is still in its room at this step's end.
bool all_in_rooms(const Proximity& proximity) {
  if (proximity.rooms.empty()) return false;
  for (std::size_t p = 0; p < proximity.patches.size(); ++p) {
    const Bounds moved = sum(proximity.moved[p], with_rest(proximity.ways[p])), &room = proximity.rooms[p];
    if ((moved.lower - room.lower).minCoeff() < 0 || (room.upper - moved.upper).minCoeff() < 0) return false;
  }
  return true;
}

void give_rooms(const ProximityMargins& margins, Proximity& proximity) {
  const Bounds rest{Vec4::Zero(), Vec4::Zero()};
  proximity.moved.assign(proximity.patches.size(), rest);
  proximity.rooms.resize(proximity.patches.size());
  for (std::size_t p = 0; p < proximity.patches.size(); ++p) {
    const Bounds way = with_rest(proximity.ways[p]);
    const double room = std::max(margins.room, steps_to_last * (way.upper - way.lower).norm());
    proximity.rooms[p] = {Vec4::Constant(-room), Vec4::Constant(room)};
  }
}

float rounded_down(double value) { return std::nextafter(static_cast<float>(value), -INFINITY); }
float rounded_up(double value) { return std::nextafter(static_cast<float>(value), INFINITY); }

// What a body's patches are grown by: with another body's, at least the contact_reach of the two.
double half_reach(const ContactGeometry& geometry, int body) {
  double most = 0;
  for (std::size_t other = 0; other < geometry.bodies.size(); ++other)
    if (geometry.bodies[body].is_cloth || geometry.bodies[other].is_cloth)
      most = std::max(most, contact_reach(geometry, body, static_cast<int>(other)) -
                                pair_radius(geometry, body, static_cast<int>(other)));
  return geometry.bodies[body].radius + 0.5 * most;
}

// Where each patch may come in its room, grown so that patches that may touch overlap.
std::vector<Box> grown_places(const ContactGeometry& geometry, const std::vector<Vec3>& x,
                              const Proximity& proximity) {
  std::vector<double> growth;
  for (std::size_t b = 0; b < geometry.bodies.size(); ++b)
    growth.push_back(half_reach(geometry, static_cast<int>(b)));
  std::vector<Box> boxes(proximity.patches.size());
  for (std::size_t p = 0; p < boxes.size(); ++p) {
    const Patch& patch = proximity.patches[p];
    const Bounds place = sum(bounds_of(x, patch.vertices), proximity.rooms[p]);
    for (int k = 0; k < 3; ++k) {
      boxes[p].lower[k] = rounded_down(place.lower[k] - growth[patch.body]);
      boxes[p].upper[k] = rounded_up(place.upper[k] + growth[patch.body]);
    }
  }
  return boxes;
}

double mean_extent(const std::vector<Box>& boxes) {
  double sum = 0;
  for (const Box& box : boxes)
    for (int k = 0; k < 3; ++k) sum += box.upper[k] - box.lower[k];
  return boxes.empty() ? 1 : sum / (3 * static_cast<double>(boxes.size()));
}

bool may_touch(const ContactGeometry& geometry, int body_a, int body_b) {
  if (body_a == body_b) return geometry.bodies[body_a].is_cloth && geometry.self_collision;
  return geometry.bodies[body_a].is_cloth || geometry.bodies[body_b].is_cloth;
}

// The pairs of a patch with those before it and with itself.
void append_partners(const ContactGeometry& geometry, const Proximity& proximity, const SpatialHash& hash,
                     const Box& box, int second, std::vector<PatchPair>& out) {
  std::vector<int> partners;
  hash.find(box, [&](int first) {
    const int a = proximity.patches[first].body, b = proximity.patches[second].body;
    if (first <= second && may_touch(geometry, a, b)) partners.push_back(first);
  });
  std::sort(partners.begin(), partners.end());
  for (const int first : partners) out.push_back({first, second, {}});
}

std::vector<PatchPair> near_patches(const ContactGeometry& geometry, const std::vector<Vec3>& x,
                                    const Proximity& proximity) {
  const std::vector<Box> boxes = grown_places(geometry, x, proximity);
  const SpatialHash hash(boxes, mean_extent(boxes));
  std::vector<PatchPair> pairs;
  parallel_collect(boxes.size(), patch_block, pairs,
                   [&](std::size_t begin, std::size_t end, std::vector<PatchPair>& out) {
                     for (std::size_t p = begin; p < end; ++p)
                       append_partners(geometry, proximity, hash, boxes[p], static_cast<int>(p), out);
                   });
  return pairs;
}

// Finds the pairs of patches anew; those that stay keep their lists.
void pair_patches(const ContactGeometry& geometry, const std::vector<Vec3>& x, Proximity& proximity) {
  std::vector<PatchPair> pairs = near_patches(geometry, x, proximity);
  const auto key = [](const PatchPair& pair) { return std::pair(pair.second, pair.first); };
  auto old = proximity.pairs.begin();
  for (PatchPair& pair : pairs) {
    while (old != proximity.pairs.end() && key(*old) < key(pair)) ++old;
    if (old != proximity.pairs.end() && key(*old) == key(pair)) pair = std::move(*old);
  }
  proximity.pairs = std::move(pairs);
}

std::vector<int> stale_lists(const Proximity& proximity) {
  std::vector<int> stale;
  parallel_collect(proximity.pairs.size(), pair_block, stale,
                   [&](std::size_t begin, std::size_t end, std::vector<int>& out) {
                     for (std::size_t p = begin; p < end; ++p) {
                       const PatchPair& pair = proximity.pairs[p];
                       if (pair.travelled + relative_way_if_stopped(proximity, pair) > pair.valid_until)
                         out.push_back(static_cast<int>(p));
                     }
                   });
  return stale;
}

// Enough for some steps, and always for this one.
double margin_for(const Proximity& proximity, const ProximityMargins& margins, const PatchPair& pair) {
  const double wanted =
      std::clamp(steps_to_last * relative_way(proximity, pair), margins.least, margins.most);
  return std::max(wanted, 2 * relative_way_if_stopped(proximity, pair));
}

Incidence triangles_at_vertices(const ContactGeometry& geometry) {
  std::vector<int> corners;
  for (const Triangle& triangle : geometry.triangles)
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return build_incidence(static_cast<int>(geometry.vertex_body.size()), corners);
}

}  // namespace

double relative_way(const Proximity& proximity, const PatchPair& pair) {
  return relative_way(proximity.ways[pair.first], proximity.ways[pair.second]);
}

double relative_way_if_stopped(const Proximity& proximity, const PatchPair& pair) {
  return relative_way(with_rest(proximity.ways[pair.first]), with_rest(proximity.ways[pair.second]));
}

Proximity start_proximity(const ContactGeometry& geometry) {
  Proximity proximity;
  proximity.patches = cut_into_patches(geometry);
  proximity.triangles_at = triangles_at_vertices(geometry);
  return proximity;
}

int update_proximity(const ContactGeometry& geometry, const StepMotion& motion,
                     const ProximityMargins& margins, Proximity& proximity) {
  measure_ways(motion, proximity);
  if (!all_in_rooms(proximity)) {
    give_rooms(margins, proximity);
    pair_patches(geometry, motion.start, proximity);
  }
  const std::vector<int> stale = stale_lists(proximity);
  parallel_for_each(stale.size(), 8, [&](std::size_t i) {
    PatchPair& pair = proximity.pairs[stale[i]];
    list_pairs(geometry, proximity.patches, motion.start, margin_for(proximity, margins, pair), pair);
  });
  return static_cast<int>(stale.size());
}

void follow_motion(const StepMotion& motion, Proximity& proximity) {
  measure_ways(motion, proximity);
  parallel_for_each(proximity.pairs.size(), pair_block, [&](std::size_t p) {
    proximity.pairs[p].travelled += relative_way(proximity, proximity.pairs[p]);
  });
  for (std::size_t p = 0; p < proximity.patches.size(); ++p)
    proximity.moved[p] = sum(proximity.moved[p], proximity.ways[p]);
}

}  // namespace drape

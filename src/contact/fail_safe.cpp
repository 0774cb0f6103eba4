#include "contact/fail_safe.h"

#include <algorithm>

#include "contact/conservative_advancement.h"
#include "core/parallel.h"

namespace drape {
namespace {

// The shares of their ways that the vertices and the bodies go so far.
struct Progress {
  std::vector<double> share;
  std::vector<double> body_share;
  std::vector<char> changed;  // vertices whose share this pass has cut
  bool plane_cut = false;  // whether it has cut a plane's, which may tilt: all vertices over it count again
};

struct Work {
  const NarrowPhase& phase;
  const std::vector<Vec3>& end;
  Progress& progress;
};

FourPoints reached(const Work& work, const ContactPair& pair) {
  FourPoints x;
  for (int i = 0; i < 4; ++i) {
    const int v = pair.vertices[i];
    const Vec3& start = work.phase.motion.start[v];
    x[i] = start + work.progress.share[v] * (work.end[v] - start);
  }
  return x;
}

// What parts the sides of a pair: points of the first side keep n.x >= first, those of the second n.x <=
// second.
struct Separation {
  Vec3 normal;
  double first, second;
};

double approach(const FourPoints& way, const Vec3& normal, int begin, int end) {
  double fastest = 0;
  for (int i = begin; i < end; ++i) fastest = std::max(fastest, normal.dot(way[i]));
  return fastest;
}

// The room between the sides beyond the gap, shared by speed of approach; a collider takes what it needs
// first.
double share_of_room(const ContactGeometry& geometry, const ContactPair& pair, double first_speed,
                     double second_speed, double room) {
  const auto bodies = pair_bodies(geometry, pair.kind, pair.vertices);
  const bool first_is_collider = !geometry.bodies[bodies[0]].is_cloth;
  const bool second_is_collider = !geometry.bodies[bodies[1]].is_cloth;
  const double total = first_speed + second_speed;
  double share = total > 0 ? first_speed / total : 0.5;
  if (first_is_collider && room > 0) share = first_speed / room;
  if (second_is_collider && room > 0) share = 1 - second_speed / room;
  return std::clamp(share, 0.05, 0.95);
}

Separation separate(const Work& work, const ContactPair& pair, const FourPoints& start,
                    const ClosestPoints& closest, double gap) {
  const int n = first_side(pair.kind);
  FourPoints way;
  for (int i = 0; i < 4; ++i) way[i] = work.end[pair.vertices[i]] - start[i];
  Separation planes{closest.difference / closest.distance, 0, 0};
  double low = 1e300, high = -1e300;
  for (int i = 0; i < n; ++i) low = std::min(low, planes.normal.dot(start[i]));
  for (int i = n; i < 4; ++i) high = std::max(high, planes.normal.dot(start[i]));
  const double room = std::max(0.0, low - high - gap);
  const double share = share_of_room(work.phase.geometry, pair, approach(way, -planes.normal, 0, n),
                                     approach(way, planes.normal, n, 4), room);
  planes.first = low - share * room;
  planes.second = high + (1 - share) * room;
  return planes;
}

// Cuts the vertex's way where `height` (its room above a plane at the start) is used up by its `fall`.
void limit(Progress& progress, int vertex, double height, double fall) {
  if (fall <= 0 || fall * progress.share[vertex] <= height) return;
  progress.share[vertex] = std::max(0.0, height) / fall * (1 - 1e-12);
  progress.changed[vertex] = 1;
}

void lock(const Work& work, const ContactPair& pair, const FourPoints& start, const Separation& planes) {
  const int n = first_side(pair.kind);
  for (int i = 0; i < 4; ++i) {
    const double sign = i < n ? 1 : -1;
    const double plane = i < n ? planes.first : planes.second;
    const double height = sign * (planes.normal.dot(start[i]) - plane);
    const double fall = -sign * planes.normal.dot(work.end[pair.vertices[i]] - start[i]);
    limit(work.progress, pair.vertices[i], height, fall);
  }
}

// Sides that touch in a point have no direction to part them.
void stop(const Work& work, const ContactPair& pair) {
  for (const int v : pair.vertices) {
    work.progress.changed[v] |= work.progress.share[v] > 0;
    work.progress.share[v] = 0;
  }
}

// The distance that the closest points keep.
double kept_gap(const Work& work, const ContactPair& pair, double distance) {
  return std::min(pair.radius + work.phase.least_gap, distance);
}

struct RiskyPair {
  ContactPair pair;
  double least_distance;  // m: at the start its points are no nearer than this
};

// The listed pairs that may come close in this step at all, wherever their vertices stop.
std::vector<RiskyPair> pairs_at_risk(const Work& work, const Proximity& proximity) {
  std::vector<RiskyPair> risky;
  constexpr std::size_t block = 256;
  parallel_collect(proximity.pairs.size(), block, risky,
                   [&](std::size_t begin, std::size_t end, std::vector<RiskyPair>& out) {
                     for (std::size_t p = begin; p < end; ++p) {
                       const PatchPair& patches = proximity.pairs[p];
                       const double way = patches.travelled + relative_way_if_stopped(proximity, patches) +
                                          2 * work.phase.least_gap;
                       if (way < patches.next_collision) continue;
                       for (std::size_t i = 0; i < patches.pairs.size(); ++i)
                         if (way >= patches.pairs[i].expiry + patches.pairs[i].thickness)
                           out.push_back({contact_pair(patches, i), least_distance(patches, i)});
                     }
                   });
  return risky;
}

// The pairs that may collide, and which of them are locked.
struct Watch {
  std::vector<RiskyPair> pairs;
  std::vector<char> locked;
};

// Whether the pair, as far as its vertices go now, loses its gap on the way.
bool collides(const Work& work, const RiskyPair& risky) {
  const ContactPair& pair = risky.pair;
  const FourPoints start = gather(work.phase.motion.start, pair.vertices), x = reached(work, pair);
  const double motion = relative_motion(pair.kind, start, x);
  if (risky.least_distance - motion > pair.radius + work.phase.least_gap) return false;
  const double distance = closest_points(pair.kind, start).distance, gap = kept_gap(work, pair, distance);
  return distance - motion <= gap && time_of_contact(pair.kind, start, x, gap, 0.01 * work.phase.least_gap);
}

// The watched pairs that collide as far as the vertices go now. After the first pass only those need a look
// of which a vertex was cut in the pass before.
std::vector<int> colliding_pairs(const Work& work, const Watch& watch, bool first_pass,
                                 const std::vector<char>& cut_before) {
  constexpr std::size_t block = 256;
  std::vector<int> colliding;
  parallel_collect(
      watch.pairs.size(), block, colliding, [&](std::size_t begin, std::size_t end, std::vector<int>& out) {
        for (std::size_t w = begin; w < end; ++w) {
          const auto& v = watch.pairs[w].pair.vertices;
          const bool cut = cut_before[v[0]] || cut_before[v[1]] || cut_before[v[2]] || cut_before[v[3]];
          if (!watch.locked[w] && (first_pass || cut) && collides(work, watch.pairs[w]))
            out.push_back(static_cast<int>(w));
        }
      });
  return colliding;
}

void lock_colliding_pairs(const Work& work, Watch& watch, bool first_pass,
                          const std::vector<char>& cut_before) {
  for (const int w : colliding_pairs(work, watch, first_pass, cut_before)) {
    const ContactPair& pair = watch.pairs[w].pair;
    const FourPoints start = gather(work.phase.motion.start, pair.vertices);
    const ClosestPoints closest = closest_points(pair.kind, start);
    watch.locked[w] = 1;
    if (closest.distance > 0)
      lock(work, pair, start, separate(work, pair, start, closest, kept_gap(work, pair, closest.distance)));
    else
      stop(work, pair);
  }
}

// What a vertex has over a plane at the start, beyond the gap, and how much of it each of them uses up.
struct OverPlane {
  double room, vertex_fall, plane_rise;  // m
};

OverPlane over_plane(const Work& work, const BodyMotion& plane, int v) {
  const Vec3& start = work.phase.motion.start[v];
  const Vec3 up = plane.end.rotation.col(1);
  const double height = plane.start.rotation.col(1).dot(start - plane.start.translation);
  return {std::max(0.0, height - work.phase.least_gap), -up.dot(work.end[v] - start),
          height - up.dot(start - plane.end.translation)};
}

// The plane goes as far as it can if the vertex stays, the vertex what room is left.
void hold_over_plane(const Work& work, const ContactPlane& plane, int v) {
  const auto [room, vertex_fall, plane_rise] = over_plane(work, work.phase.bodies[plane.body], v);
  Progress& progress = work.progress;
  double& plane_share = progress.body_share[plane.body];
  const auto fall = [&, vertex_fall = vertex_fall, plane_rise = plane_rise] {
    return progress.share[v] * vertex_fall + plane_share * plane_rise;
  };
  if (fall() <= room) return;
  if (vertex_fall > 0) limit(progress, v, room - plane_share * plane_rise, vertex_fall);
  if (fall() <= room || plane_rise <= 0) return;
  plane_share = std::max(0.0, room - progress.share[v] * vertex_fall) / plane_rise * (1 - 1e-12);
  progress.plane_cut = true;
}

// Those of a cloth's vertices that may use up their room. What is left out need not be held later either:
// vertices and planes only go shorter ways.
std::vector<int> vertices_short_of_room(const Work& work, const ContactPlane& plane,
                                        const ContactBody& cloth) {
  constexpr std::size_t block = 1024;
  const double plane_share = work.progress.body_share[plane.body];
  const BodyMotion& motion = work.phase.bodies[plane.body];
  std::vector<int> result;
  parallel_collect(
      cloth.vertex_end - cloth.vertex_begin, block, result,
      [&](std::size_t begin, std::size_t end, std::vector<int>& out) {
        for (std::size_t i = begin; i < end; ++i) {
          const int v = cloth.vertex_begin + static_cast<int>(i);
          const auto [room, vertex_fall, plane_rise] = over_plane(work, motion, v);
          if (work.progress.share[v] * std::max(0.0, vertex_fall) + plane_share * std::max(0.0, plane_rise) >
              room)
            out.push_back(v);
        }
      });
  return result;
}

void hold_over_planes(const Work& work) {
  for (const ContactPlane& plane : work.phase.geometry.planes)
    for (const ContactBody& body : work.phase.geometry.bodies) {
      if (!body.is_cloth) continue;
      for (const int v : vertices_short_of_room(work, plane, body)) hold_over_plane(work, plane, v);
    }
}

// A rigid collider goes one share: the least of its vertices'. One that deforms yields where it must.
void keep_colliders_rigid(const Work& work) {
  Progress& progress = work.progress;
  for (std::size_t b = 0; b < work.phase.geometry.bodies.size(); ++b) {
    const ContactBody& body = work.phase.geometry.bodies[b];
    if (!body.is_rigid) continue;
    double& least = progress.body_share[b];
    for (int v = body.vertex_begin; v < body.vertex_end; ++v) least = std::min(least, progress.share[v]);
    for (int v = body.vertex_begin; v < body.vertex_end; ++v)
      if (progress.share[v] > least) {
        progress.share[v] = least;
        progress.changed[v] = 1;
      }
  }
}

// Returns how many were cut.
int cut_ways(const std::vector<Vec3>& start, const std::vector<double>& shares, std::vector<Vec3>& end) {
  int cut = 0;
  for (std::size_t v = 0; v < end.size(); ++v)
    if (shares[v] < 1) {
      end[v] = start[v] + shares[v] * (end[v] - start[v]);
      ++cut;
    }
  return cut;
}

}  // namespace

FailSafeResult hold_back(const NarrowPhase& phase, const Proximity& proximity, std::vector<Vec3>& end) {
  const std::size_t vertices = end.size();
  Progress progress{
      std::vector<double>(vertices, 1.0), std::vector<double>(phase.geometry.bodies.size(), 1.0), {}, false};
  const Work work{phase, end, progress};
  Watch watch{pairs_at_risk(work, proximity), {}};
  watch.locked.assign(watch.pairs.size(), 0);
  FailSafeResult result;
  std::vector<char> cut_before;
  do {
    cut_before.swap(progress.changed);
    cut_before.resize(vertices, 0);
    progress.changed.assign(vertices, 0);
    progress.plane_cut = false;
    lock_colliding_pairs(work, watch, result.passes == 0, cut_before);
    hold_over_planes(work);
    keep_colliders_rigid(work);
    ++result.passes;
  } while (progress.plane_cut ||
           std::find(progress.changed.begin(), progress.changed.end(), 1) != progress.changed.end());

  if (result.passes > 1)  // one pass alone has cut nothing
    result.limited_vertices = cut_ways(phase.motion.start, progress.share, end);
  result.vertex_progress = std::move(progress.share);
  result.body_progress = std::move(progress.body_share);
  return result;
}

}  // namespace drape

#include "deformation/tethers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "core/parallel.h"
#include "deformation/convex_pieces.h"
#include "deformation/membrane_material.h"

namespace drape {
namespace {

// Edges at each vertex, as neighbour and length.
struct EdgeGraph {
  std::vector<std::vector<std::pair<int, double>>> neighbours;
};

EdgeGraph edge_graph(const Sheet& sheet) {
  EdgeGraph graph{std::vector<std::vector<std::pair<int, double>>>(sheet.rest_positions.size())};
  for (const Edge& edge : sheet.topology.edges) {
    const double length = rest_length(sheet, edge);
    graph.neighbours[edge.vertices[0]].push_back({edge.vertices[1], length});
    graph.neighbours[edge.vertices[1]].push_back({edge.vertices[0], length});
  }
  return graph;
}

// The pinned vertices, in groups that are connected by edges between pinned vertices.
std::vector<std::vector<int>> pinned_groups(const EdgeGraph& graph, const std::vector<char>& pinned) {
  std::vector<std::vector<int>> groups;
  std::vector<char> seen(pinned.size(), 0);
  for (int v = 0; v < static_cast<int>(pinned.size()); ++v) {
    if (!pinned[v] || seen[v]) continue;
    std::vector<int> group{v};
    seen[v] = 1;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (const auto& [next, length] : graph.neighbours[group[i]])
        if (pinned[next] && !seen[next]) {
          seen[next] = 1;
          group.push_back(next);
        }
    groups.push_back(std::move(group));
  }
  return groups;
}

// For each vertex that a group reaches along edges: the way, and the pinned vertex at its end (Dijkstra).
struct Reach {
  std::vector<double> distance;
  std::vector<int> source;
};

Reach reach_of(const EdgeGraph& graph, const std::vector<int>& group) {
  Reach reach{std::vector<double>(graph.neighbours.size(), std::numeric_limits<double>::infinity()),
              std::vector<int>(graph.neighbours.size(), -1)};
  std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
  for (const int v : group) {
    reach.distance[v] = 0;
    reach.source[v] = v;
    queue.push({0, v});
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > reach.distance[v]) continue;
    for (const auto& [next, length] : graph.neighbours[v])
      if (distance + length < reach.distance[next]) {
        reach.distance[next] = distance + length;
        reach.source[next] = reach.source[v];
        queue.push({distance + length, next});
      }
  }
  return reach;
}

// How far the material stretches between a pin and a point at `distance`, where `weight` hangs on the pin: at
// r the tension is weight over the front, a quarter circle of radius r that is no longer than the piece is
// wide, summed up from an edge's length on. (Along warp or weft that is the stretch stiffness, on the bias
// mostly the shear stiffness.)
double slack(double weight, double stiffness, double edge_length, double distance, double width) {
  constexpr double quarter = std::numbers::pi / 2;
  const double reach = std::max(distance, edge_length), whole_width = std::max(width / quarter, edge_length);
  const double first_edge = std::max(1 / quarter, edge_length / width);
  const double arcs = std::log(std::min(reach, whole_width) / edge_length) / quarter;
  return weight / stiffness * (first_edge + arcs + std::max(reach - whole_width, 0.0) / width);
}

// Of each piece, in m2.
std::vector<double> piece_areas(const Sheet& sheet, const std::vector<int>& piece_of, std::size_t pieces) {
  std::vector<double> areas(pieces, 0.0);
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    areas[piece_of[sheet.triangles[t][0]]] += rest_area(sheet, t);
  return areas;
}

// The mean length of the fronts that a group's reach passes.
double mean_width(const Reach& reach, double area) {
  double farthest = 0;
  for (const double distance : reach.distance)
    if (std::isfinite(distance)) farthest = std::max(farthest, distance);
  return area / farthest;
}

// In N/m along a direction of the rest shape, free to contract across; on the bias where there is none in its
// plane.
double stiffness_along(const Sheet& sheet, int triangle, const std::optional<Vec3>& direction) {
  const double along_warp =
      direction ? std::abs(warp_in_plane(sheet, triangle).dot(*direction)) : std::sqrt(0.5);
  const double cosine = std::min(1.0, along_warp);
  const double sine = std::sqrt(1 - cosine * cosine);
  const Vec3 strain(cosine * cosine, sine * sine, cosine * sine);
  return 1 / strain.dot(membrane_tensor(material_of(sheet, triangle), Vec2(1, 0)).inverse() * strain);
}

}  // namespace

namespace {

// What the lengths of tethers are made from, besides the way.
struct TetherSlack {
  const Sheet& sheet;
  const EdgeGraph& graph;
  std::vector<int> piece_of;
  std::vector<char> convex;
  std::vector<double> weights, areas;  // of each piece, in N and m2
};

TetherSlack tether_slack(const Sheet& sheet, const EdgeGraph& graph, const std::vector<double>& masses,
                         double gravity) {
  TetherSlack result{sheet, graph, connected_pieces(static_cast<int>(masses.size()), sheet.triangles),
                     {},    {},    {}};
  result.convex = convex_pieces(sheet, result.piece_of);
  result.weights.resize(result.convex.size(), 0.0);
  for (std::size_t v = 0; v < masses.size(); ++v) result.weights[result.piece_of[v]] += gravity * masses[v];
  result.areas = piece_areas(sheet, result.piece_of, result.weights.size());
  return result;
}

// `width` of the fronts between the pin's group and the vertex; `way` along edges.
Tether tether_of(const TetherSlack& by, int vertex, int pin, double way, double width) {
  const std::vector<Vec3>& x = by.sheet.rest_positions;
  const int piece = by.piece_of[vertex];
  std::optional<Vec3> direction;
  if (by.convex[piece]) {
    way = (x[vertex] - x[pin]).norm();
    direction = (x[vertex] - x[pin]) / way;
  }
  const Topology& topology = by.sheet.topology;
  const int triangle = topology.vertex_triangles[topology.vertex_triangle_begin[vertex]];
  const double edge_length = by.graph.neighbours[vertex].front().second;
  const double stiffness = stiffness_along(by.sheet, triangle, direction);
  return {vertex, pin,
          static_cast<float>(way + slack(by.weights[piece], stiffness, edge_length, way, width))};
}

// The nearest group's pin for each vertex, and the width of its fronts: one tether a vertex, since two would
// fight where their pins are drawn apart.
struct NearestPins {
  std::vector<double> ways, widths;
  std::vector<int> pins;
};

NearestPins nearest_pins(const EdgeGraph& graph, const std::vector<char>& pinned, const TetherSlack& by) {
  const std::size_t count = pinned.size();
  NearestPins nearest{std::vector<double>(count, std::numeric_limits<double>::infinity()),
                      std::vector<double>(count, 0.0), std::vector<int>(count, -1)};
  for (const std::vector<int>& group : pinned_groups(graph, pinned)) {
    const Reach reach = reach_of(graph, group);
    const double width = mean_width(reach, by.areas[by.piece_of[group[0]]]);
    for (std::size_t v = 0; v < count; ++v) {
      if (!(reach.distance[v] < nearest.ways[v])) continue;
      nearest.ways[v] = reach.distance[v];
      nearest.widths[v] = width;
      nearest.pins[v] = reach.source[v];
    }
  }
  return nearest;
}

}  // namespace

TetherStage build_tethers(const Sheet& sheet, const std::vector<double>& masses,
                          const std::vector<char>& pinned, double gravity) {
  const EdgeGraph graph = edge_graph(sheet);
  const TetherSlack by = tether_slack(sheet, graph, masses, gravity);
  const NearestPins nearest = nearest_pins(graph, pinned, by);
  TetherStage stage;
  for (int v = 0; v < static_cast<int>(pinned.size()); ++v)
    if (nearest.pins[v] >= 0 && !pinned[v])
      stage.tethers.push_back(tether_of(by, v, nearest.pins[v], nearest.ways[v], nearest.widths[v]));
  return stage;
}

void load_tethers(const TetherStage& stage, const SplitPoints& start, std::vector<Point4>& base) {
  base.resize(stage.tethers.size());
  const Point4 *high = start.high.data(), *low = start.low.data();
  parallel_blocks(stage.tethers.size(), 4096, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const int vertex = stage.tethers[i].vertex, pin = stage.tethers[i].pin;
      const PointLanes way = load_point(high[vertex]) - load_point(high[pin]);
      store_point(way + (load_point(low[vertex]) - load_point(low[pin])), base[i]);
    }
  });
}

static void pull_tether(const Tether& tether, const Point4& base, std::vector<Point4>& offsets) {
  Point4& u = offsets[tether.vertex];
  const Point4& pin = offsets[tether.pin];
  const LaneVec3<float> way{base.x + (u.x - pin.x), base.y + (u.y - pin.y), base.z + (u.z - pin.z)};
  const float squared = dot(way, way);
  if (!(squared > tether.length * tether.length)) return;
  const float excess = 1 - tether.length / square_root(squared);
  u = {u.x - excess * way.x, u.y - excess * way.y, u.z - excess * way.z, u.w};
}

void pull_tethers(const TetherStage& stage, const std::vector<Point4>& base, std::vector<Point4>& offsets) {
  parallel_for_each(stage.tethers.size(), 2048,
                    [&](std::size_t i) { pull_tether(stage.tethers[i], base[i], offsets); });
}

}  // namespace drape

#include "mesh/manifold.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "mesh/disjoint_sets.h"
#include "mesh/half_edge.h"
#include "mesh/limits.h"

namespace drape {
namespace {

constexpr std::size_t shown_of_a_kind = 5;

// A triangle whose height is under this part of its longest side has no usable normal or rest shape.
constexpr double least_relative_height = 1e-6;

// The first problems of one kind in words, and the number of all.
struct Findings {
  std::vector<std::string> first;
  std::size_t count = 0;

  template <typename Describe>
  void add(const Describe& describe) {
    if (count++ < shown_of_a_kind) first.push_back(describe());
  }
};

void append(const Findings& found, const std::string& kind, std::vector<std::string>& problems) {
  problems.insert(problems.end(), found.first.begin(), found.first.end());
  if (found.count > found.first.size())
    problems.push_back(fmt::format("and {} more {}", found.count - found.first.size(), kind));
}

void check_sizes(const TriangleMesh& mesh, std::vector<std::string>& problems) {
  if (mesh.triangles.empty()) problems.push_back("the mesh has no triangles");
  if (mesh.positions.size() > most_points)
    problems.push_back(
        fmt::format("the mesh has {} points; the most is {}", mesh.positions.size(), most_points));
  if (mesh.triangles.size() > most_triangles)
    problems.push_back(
        fmt::format("the mesh has {} triangles; the most is {}", mesh.triangles.size(), most_triangles));
  if (!mesh.uv_triangles.empty() && mesh.uv_triangles.size() != mesh.triangles.size())
    problems.push_back(fmt::format("the mesh has {} triangles, but texture coordinates for {}",
                                   mesh.triangles.size(), mesh.uv_triangles.size()));
}

void check_indices(const std::vector<Triangle>& triangles, std::size_t count, const std::string& what,
                   std::vector<std::string>& problems) {
  Findings found;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const int index : triangles[t])
      if (index < 0 || static_cast<std::size_t>(index) >= count)
        found.add([&] {
          return fmt::format("triangle {} names {} {}, but they are numbered 1 to {}", t + 1, what,
                             static_cast<long long>(index) + 1, count);
        });
  append(found, "indices out of range", problems);
}

void check_finite(const TriangleMesh& mesh, std::vector<std::string>& problems) {
  Findings found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const int point : mesh.triangles[t])
      if (!mesh.positions[point].allFinite())
        found.add([&] {
          return fmt::format("triangle {} has a corner, point {}, whose coordinates are not finite", t + 1,
                             point + 1);
        });
  append(found, "corners that are not finite", problems);
}

bool names_a_point_twice(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

bool is_flat(const std::vector<Vec3>& positions, const Triangle& triangle) {
  const Vec3 a = positions[triangle[1]] - positions[triangle[0]];
  const Vec3 b = positions[triangle[2]] - positions[triangle[1]];
  const Vec3 c = positions[triangle[0]] - positions[triangle[2]];
  const double longest = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  return !(a.cross(b).norm() >= least_relative_height * longest && longest > 0);
}

void check_degenerate(const TriangleMesh& mesh, std::vector<std::string>& problems) {
  Findings found;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    const auto say = [&](const char* why) {
      found.add([&] {
        return fmt::format("triangle {} (points {}, {}, {}) {}", t + 1, corners[0] + 1, corners[1] + 1,
                           corners[2] + 1, why);
      });
    };
    if (names_a_point_twice(corners))
      say("names a point twice; delete it");
    else if (is_flat(mesh.positions, corners))
      say("has no area; merge its points or delete it");
  }
  append(found, "degenerate triangles", problems);
}

// Both sides run from the same point: the triangles' fronts are on different sides of the surface.
bool same_direction(const TriangleMesh& mesh, const HalfEdge& a, const HalfEdge& b) {
  return mesh.triangles[a.triangle][a.corner] == mesh.triangles[b.triangle][b.corner];
}

void check_edges(const TriangleMesh& mesh, const std::vector<HalfEdge>& half_edges,
                 std::vector<std::string>& problems) {
  Findings crowded, flipped;
  for_each_edge(half_edges, [&](auto begin, auto end) {
    if (end - begin > 2) {
      crowded.add([&] {
        std::vector<int> numbers;
        std::transform(begin, end, std::back_inserter(numbers), [](const auto& e) { return e.triangle + 1; });
        if (numbers.size() > shown_of_a_kind) numbers.resize(shown_of_a_kind);
        return fmt::format(
            "the edge from point {} to point {} has {} triangles ({}{}); a surface has at most 2",
            begin->low + 1, begin->high + 1, end - begin, fmt::join(numbers, ", "),
            static_cast<std::size_t>(end - begin) > numbers.size() ? ", ..." : "");
      });
    } else if (end - begin == 2 && same_direction(mesh, *begin, *(begin + 1))) {
      flipped.add([&] {
        return fmt::format("triangles {} and {} have opposite orientation; turn one of them over",
                           begin->triangle + 1, (begin + 1)->triangle + 1);
      });
    }
  });
  append(crowded, "edges of more than 2 triangles", problems);
  append(flipped, "pairs of opposite orientation", problems);
}

// The corners of each point, joined where their triangles share an edge at it. Corner k of triangle t is
// number 3 t + k. Needs edges that check_edges accepts.
DisjointSets join_fans(const TriangleMesh& mesh, const std::vector<HalfEdge>& half_edges) {
  DisjointSets corners(static_cast<int>(3 * mesh.triangles.size()));
  for_each_edge(half_edges, [&](auto begin, auto end) {
    if (end - begin != 2) return;
    const HalfEdge& a = *begin;
    const HalfEdge& b = *(begin + 1);
    corners.join(3 * a.triangle + a.corner, 3 * b.triangle + (b.corner + 1) % 3);
    corners.join(3 * a.triangle + (a.corner + 1) % 3, 3 * b.triangle + b.corner);
  });
  return corners;
}

void check_fans(const TriangleMesh& mesh, const std::vector<HalfEdge>& half_edges,
                std::vector<std::string>& problems) {
  DisjointSets corners = join_fans(mesh, half_edges);
  std::vector<int> first_fan(mesh.positions.size(), -1);  // the fan's first triangle
  Findings touching;
  for (int corner = 0; corner < static_cast<int>(corners.parent.size()); ++corner) {
    if (corners.find(corner) != corner) continue;
    const int point = mesh.triangles[corner / 3][corner % 3];
    if (first_fan[point] < 0) {
      first_fan[point] = corner / 3;
      continue;
    }
    touching.add([&] {
      return fmt::format("triangles {} and {} touch at point {} only; give each its own point",
                         first_fan[point] + 1, corner / 3 + 1, point + 1);
    });
  }
  append(touching, "points where fans touch", problems);
}

void check_unused(const TriangleMesh& mesh, std::vector<std::string>& problems) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const Triangle& triangle : mesh.triangles)
    for (const int point : triangle) used[point] = true;
  Findings found;
  for (std::size_t point = 0; point < used.size(); ++point)
    if (!used[point])
      found.add([&] { return fmt::format("point {} belongs to no triangle; delete it", point + 1); });
  append(found, "points of no triangle", problems);
}

}  // namespace

std::vector<std::string> check_manifold(const TriangleMesh& mesh) {
  std::vector<std::string> problems;
  check_sizes(mesh, problems);
  check_indices(mesh.triangles, mesh.positions.size(), "point", problems);
  check_indices(mesh.uv_triangles, mesh.uvs.size(), "texture coordinate", problems);
  if (!problems.empty()) return problems;

  check_finite(mesh, problems);
  if (problems.empty()) check_degenerate(mesh, problems);
  check_unused(mesh, problems);
  if (!problems.empty()) return problems;

  const std::vector<HalfEdge> half_edges = sorted_half_edges(mesh.triangles);
  check_edges(mesh, half_edges, problems);
  if (problems.empty()) check_fans(mesh, half_edges, problems);
  return problems;
}

}  // namespace drape

#include "mesh/polygon_soup.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace drape {

std::vector<int> first_equal_points(const std::vector<Vec3>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::tie(points[i].x(), points[i].y(), points[i].z()); };
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });

  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

std::vector<int> first_equal_points(const std::vector<Vec3>& points, const std::vector<Vec3>& other_points) {
  return first_equal_points(first_equal_points(points), other_points);
}

std::vector<int> first_equal_points(const std::vector<int>& first, const std::vector<Vec3>& points) {
  const std::vector<int> other_first = first_equal_points(points);
  std::map<std::pair<int, int>, int> first_in_both;
  std::vector<int> result(points.size());
  for (int i = 0; i < static_cast<int>(result.size()); ++i)
    result[i] = first_in_both.try_emplace({first[i], other_first[i]}, i).first->second;
  return result;
}

bool have_same_faces(const PolygonSoup& a, const PolygonSoup& b) {
  return a.points.size() == b.points.size() && a.corner_points == b.corner_points &&
         a.polygon_ends == b.polygon_ends;
}

std::string size_text(const PolygonSoup& soup) {
  return fmt::format("{} points and {} faces", soup.points.size(), soup.polygon_ends.size());
}

// Those points that are the first of their place, in their order.
static std::vector<Vec3> keep_first(const std::vector<Vec3>& points, const std::vector<int>& first) {
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (first[i] == static_cast<int>(i)) kept.push_back(points[i]);
  return kept;
}

// The number of each point among those that are kept.
static std::vector<int> number_first(const std::vector<int>& first) {
  std::vector<int> number(first.size());
  int kept = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    number[i] = first[i] == static_cast<int>(i) ? kept++ : number[first[i]];
  return number;
}

std::vector<Triangle> cut_into_fans(const std::vector<int>& corners, const std::vector<int>& polygon_ends) {
  std::vector<Triangle> triangles;
  int begin = 0;
  for (const int end : polygon_ends) {
    for (int k = begin + 1; k + 1 < end; ++k)
      triangles.push_back({corners[begin], corners[k], corners[k + 1]});
    begin = end;
  }
  return triangles;
}

static TriangleMesh weld(const PolygonSoup& soup, const std::vector<int>& first) {
  TriangleMesh mesh;
  mesh.positions = keep_first(soup.points, first);
  const std::vector<int> number = number_first(first);
  const bool has_uvs = !soup.corner_uvs.empty();
  const std::vector<Triangle> triangles = cut_into_fans(soup.corner_points, soup.polygon_ends);
  const std::vector<Triangle> uv_triangles =
      has_uvs ? cut_into_fans(soup.corner_uvs, soup.polygon_ends) : std::vector<Triangle>();
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Triangle welded{number[a], number[b], number[c]};
    if (!has_three_corners(welded)) continue;
    mesh.triangles.push_back(welded);
    if (has_uvs) mesh.uv_triangles.push_back(uv_triangles[t]);
  }
  if (has_uvs) mesh.uvs = soup.uvs;
  return mesh;
}

TriangleMesh weld(const PolygonSoup& soup) { return weld(soup, first_equal_points(soup.points)); }

ShapedMesh weld(const PolygonSoup& rest, const PolygonSoup& start) {
  const std::vector<int> first = first_equal_points(rest.points, start.points);
  ShapedMesh shaped{weld(start, first), keep_first(start.points, first)};
  shaped.mesh.positions = keep_first(rest.points, first);
  return shaped;
}

MeshInShapes weld(const SoupInShapes& in_shapes) {
  std::vector<int> first = first_equal_points(in_shapes.soup.points);
  for (const std::vector<Vec3>& shape : in_shapes.shapes) first = first_equal_points(first, shape);
  MeshInShapes result{weld(in_shapes.soup, first), {}};
  for (const std::vector<Vec3>& shape : in_shapes.shapes) result.shapes.push_back(keep_first(shape, first));
  return result;
}

}  // namespace drape

#include "mesh/polygon_soup.h"

#include <algorithm>
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

// Keeps the points that are the first of their position, in their order; gives all points their new numbers.
static std::vector<int> weld_points(const std::vector<Vec3>& points, std::vector<Vec3>& welded) {
  const std::vector<int> first = first_equal_points(points);
  std::vector<int> number(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (first[i] == static_cast<int>(i)) {
      number[i] = static_cast<int>(welded.size());
      welded.push_back(points[i]);
    } else {
      number[i] = number[first[i]];
    }
  }
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

TriangleMesh weld(const PolygonSoup& soup) {
  TriangleMesh mesh;
  const std::vector<int> number = weld_points(soup.points, mesh.positions);
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

}  // namespace drape

#include "mesh/polygon_soup.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace drape {

// For each point the first point of equal position.
static std::vector<int> first_equal_points(const std::vector<Vec3>& points) {
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

static bool has_three_corners(const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

TriangleMesh weld(const PolygonSoup& soup) {
  TriangleMesh mesh;
  const std::vector<int> number = weld_points(soup.points, mesh.positions);
  const bool has_uvs = !soup.corner_uvs.empty();
  int begin = 0;
  for (const int end : soup.polygon_ends) {
    for (int k = begin + 1; k + 1 < end; ++k) {
      const auto fan = [&](const std::vector<int>& corners) {
        return Triangle{corners[begin], corners[k], corners[k + 1]};
      };
      Triangle triangle = fan(soup.corner_points);
      for (int& point : triangle) point = number[point];
      if (!has_three_corners(triangle)) continue;
      mesh.triangles.push_back(triangle);
      if (has_uvs) mesh.uv_triangles.push_back(fan(soup.corner_uvs));
    }
    begin = end;
  }
  if (has_uvs) mesh.uvs = soup.uvs;
  return mesh;
}

}  // namespace drape

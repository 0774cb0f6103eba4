#include "contact/intersections.h"

#include <algorithm>
#include <cmath>

#include "contact/spatial_hash.h"

namespace drape {
namespace {

using Point = Vec3f;

// Differences and products of floats in a 113-bit mantissa: the determinant of three differences of floats is
// exact there while the coordinates' exponents are within some 2^17 of each other, as in a scene of one
// scale.
__extension__ typedef __float128 Exact;

int sign(double value) { return (value > 0) - (value < 0); }

int exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  Exact m[3][3];
  const Point* rows[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) m[i][k] = static_cast<Exact>((*rows[i])[k]) - static_cast<Exact>(d[k]);
  const Exact determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                            m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                            m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return (determinant > 0) - (determinant < 0);
}

// On which side of the plane (a, b, c) d lies: the sign of det(a - d, b - d, c - d). In double where that is
// sure.
int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Vec3 u = a.cast<double>() - d.cast<double>(), v = b.cast<double>() - d.cast<double>(),
             w = c.cast<double>() - d.cast<double>();
  const double determinant = u.dot(v.cross(w));
  const double bound = 1e-14 * u.lpNorm<1>() * v.lpNorm<1>() * w.lpNorm<1>();
  return std::abs(determinant) > bound ? sign(determinant) : exact_orientation(a, b, c, d);
}

// Whether the closed segment (p, q) meets the closed triangle (a, b, c); p and q not both in its plane.
bool segment_meets_triangle(const Point& p, const Point& q, const Point& a, const Point& b, const Point& c) {
  const int side_p = orientation(a, b, c, p), side_q = orientation(a, b, c, q);
  if (side_p * side_q > 0 || (side_p == 0 && side_q == 0)) return false;
  const int ab = orientation(p, q, a, b), bc = orientation(p, q, b, c), ca = orientation(p, q, c, a);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool edges_meet(const std::vector<Point>& x, const Triangle& from, const Triangle& to, int skipped_vertex) {
  for (int k = 0; k < 3; ++k) {
    const int p = from[k], q = from[(k + 1) % 3];
    if (p == skipped_vertex || q == skipped_vertex) continue;
    if (segment_meets_triangle(x[p], x[q], x[to[0]], x[to[1]], x[to[2]])) return true;
  }
  return false;
}

// Triangles that share a vertex meet beyond it where the edge across it, of one of them, meets the other.
bool intersect(const std::vector<Point>& x, const Triangle& s, const Triangle& t) {
  int shared = 0, vertex = -1;
  for (const int v : s)
    if (std::find(t.begin(), t.end(), v) != t.end()) {
      ++shared;
      vertex = v;
    }
  if (shared >= 2) return false;
  return edges_meet(x, s, t, vertex) || edges_meet(x, t, s, vertex);
}

Box triangle_box(const std::vector<Point>& x, const Triangle& triangle) {
  Box box = empty_box();
  for (const int v : triangle) include(box, {{x[v].x(), x[v].y(), x[v].z()}, {x[v].x(), x[v].y(), x[v].z()}});
  return box;
}

double mean_extent(const std::vector<Box>& boxes) {
  double sum = 0;
  for (const Box& box : boxes)
    sum += (box.upper[0] - box.lower[0]) + (box.upper[1] - box.lower[1]) + (box.upper[2] - box.lower[2]);
  return boxes.empty() || !(sum > 0) ? 1 : sum / static_cast<double>(boxes.size());
}

}  // namespace

std::vector<std::pair<int, int>> intersecting_triangles(const std::vector<Vec3f>& positions,
                                                        const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes;
  for (const Triangle& triangle : triangles) boxes.push_back(triangle_box(positions, triangle));
  const SpatialHash hash(boxes, mean_extent(boxes));
  std::vector<std::pair<int, int>> pairs;
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    hash.find(boxes[t], [&](int s) {
      if (s < t && intersect(positions, triangles[s], triangles[t])) pairs.emplace_back(s, t);
    });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace drape

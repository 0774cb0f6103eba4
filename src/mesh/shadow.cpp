#include "mesh/shadow.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/rigid_motion.h"

namespace drape {
namespace {

// Seen from above: x to the right, z downward.
using Corners = std::array<Vec2, 3>;

Vec2 from_above(const Vec3& point) { return {point.x(), point.z()}; }

Corners corners_from_above(const std::vector<Vec3>& positions, const Triangle& triangle) {
  return {from_above(positions[triangle[0]]), from_above(positions[triangle[1]]),
          from_above(positions[triangle[2]])};
}

// Lines along x, in the middles of equal strips of the shadow's extent in z.
struct Lines {
  double begin = 0;
  double spacing = 0;
  int count = 0;

  double z(int line) const { return begin + (line + 0.5) * spacing; }
  // The first line at or above z, between 0 and count.
  int first_from(double z) const {
    return std::clamp(static_cast<int>(std::ceil((z - begin) / spacing - 0.5)), 0, count);
  }
};

Lines lines_across(const std::vector<Vec3>& positions) {
  constexpr int count = 4096;
  const auto by_z = [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); };
  const auto [least, greatest] = std::minmax_element(positions.begin(), positions.end(), by_z);
  return {least->z(), (greatest->z() - least->z()) / count, count};
}

using Interval = std::pair<double, double>;

// Where a line crosses a triangle that reaches to both sides of it.
Interval crossing(const Corners& corners, double z) {
  Interval interval{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 3; ++k) {
    const Vec2 &a = corners[k], &b = corners[(k + 1) % 3];
    if ((a.y() < z) == (b.y() < z)) continue;
    const double x = a.x() + (b.x() - a.x()) * ((z - a.y()) / (b.y() - a.y()));
    interval = {std::min(interval.first, x), std::max(interval.second, x)};
  }
  return interval;
}

double length_of_union(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end());
  double length = 0, covered_to = -std::numeric_limits<double>::infinity();
  for (const auto& [begin, end] : intervals) {
    length += std::max(0.0, end - std::max(begin, covered_to));
    covered_to = std::max(covered_to, end);
  }
  return length;
}

// How far from the origin along a ray an edge crosses it; 0 where it does not.
double reach(const Vec2& ray, const Vec2& a, const Vec2& b) {
  const double side_a = ray.x() * a.y() - ray.y() * a.x();
  const double side_b = ray.x() * b.y() - ray.y() * b.x();
  if ((side_a < 0) == (side_b < 0)) return 0;
  return std::max(0.0, ray.dot(a + (b - a) * (side_a / (side_a - side_b))));
}

}  // namespace

double shadow_area(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  if (positions.empty()) return 0;
  const Lines lines = lines_across(positions);
  if (lines.spacing == 0) return 0;
  std::vector<std::vector<Interval>> intervals(lines.count);
  for (const Triangle& triangle : triangles) {
    const Corners corners = corners_from_above(positions, triangle);
    const auto [least, greatest] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
    for (int line = lines.first_from(least); line < lines.first_from(greatest); ++line) {
      const Interval interval = crossing(corners, lines.z(line));
      if (interval.first < interval.second) intervals[line].push_back(interval);
    }
  }
  double area = 0;
  for (std::vector<Interval>& line : intervals) area += length_of_union(line) * lines.spacing;
  return area;
}

double surface_area(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles)
    area += 0.5 * (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm();
  return area;
}

std::vector<double> shadow_outline(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                                   const Vec3& centre, int directions) {
  std::vector<double> outline(directions);
  const Vec2 origin = from_above(centre);
  for (int i = 0; i < directions; ++i) {
    const auto [s, c] = sin_cos_degrees(360.0 * i / directions);
    const Vec2 ray(c, -s);
    for (const Triangle& triangle : triangles) {
      const Corners corners = corners_from_above(positions, triangle);
      for (int k = 0; k < 3; ++k)
        outline[i] = std::max(outline[i], reach(ray, corners[k] - origin, corners[(k + 1) % 3] - origin));
    }
  }
  return outline;
}

// From the least value on, once round: after a rise of `prominence` the curve counts once it has fallen by as
// much.
int count_maxima(const std::vector<double>& closed_curve, double prominence) {
  assert(prominence > 0);
  const std::size_t size = closed_curve.size();
  const std::size_t start = std::min_element(closed_curve.begin(), closed_curve.end()) - closed_curve.begin();
  int count = 0;
  bool rising = true;
  double low = size > 0 ? closed_curve[start] : 0, high = low;
  for (std::size_t i = 1; i <= size; ++i) {
    const double value = closed_curve[(start + i) % size];
    low = std::min(low, value);
    high = std::max(high, value);
    if (rising && high - value >= prominence) ++count, rising = false, low = value;
    if (!rising && value - low >= prominence) rising = true, high = value;
  }
  return count;
}

}  // namespace drape

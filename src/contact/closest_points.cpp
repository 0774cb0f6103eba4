#include "contact/closest_points.h"

#include <algorithm>

namespace drape {
namespace {

ClosestPoints with_weights(const FourPoints& x, const std::array<double, 4>& weights, bool inside_edges) {
  const Vec3 difference = weights[0] * x[0] + weights[1] * x[1] + weights[2] * x[2] + weights[3] * x[3];
  return {weights, difference, difference.norm(), inside_edges};
}

ClosestPoints on_triangle(const FourPoints& x, double b0, double b1, double b2) {
  return with_weights(x, {1, -b0, -b1, -b2}, false);
}

}  // namespace

ClosestPoints closest_point_triangle(const FourPoints& x) {
  const Vec3 ab = x[2] - x[1], ac = x[3] - x[1], ap = x[0] - x[1];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return on_triangle(x, 1, 0, 0);

  const Vec3 bp = x[0] - x[2];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return on_triangle(x, 0, 1, 0);

  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) {
    const double t = d1 - d3 > 0 ? d1 / (d1 - d3) : 0;
    return on_triangle(x, 1 - t, t, 0);
  }

  const Vec3 cp = x[0] - x[3];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return on_triangle(x, 0, 0, 1);

  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) {
    const double t = d2 - d6 > 0 ? d2 / (d2 - d6) : 0;
    return on_triangle(x, 1 - t, 0, t);
  }

  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double sum = (d4 - d3) + (d5 - d6);
    const double t = sum > 0 ? (d4 - d3) / sum : 0;
    return on_triangle(x, 0, 1 - t, t);
  }

  const double sum = va + vb + vc;
  return on_triangle(x, va / sum, vb / sum, vc / sum);
}

ClosestPoints closest_edge_edge(const FourPoints& x) {
  const Vec3 d1 = x[1] - x[0], d2 = x[3] - x[2], r = x[0] - x[2];
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r), c = d1.dot(r), b = d1.dot(d2);
  const double determinant = a * e - b * b;
  const auto clamped = [](double value) { return std::clamp(value, 0.0, 1.0); };

  double s = determinant > 1e-14 * a * e ? clamped((b * f - c * e) / determinant) : 0;
  double t = e > 0 ? (b * s + f) / e : 0;
  if (t < 0 || t > 1 || !(e > 0)) {
    t = clamped(t);
    s = a > 0 ? clamped((b * t - c) / a) : 0;
  }
  const bool inside = s > 0 && s < 1 && t > 0 && t < 1;
  return with_weights(x, {1 - s, s, t - 1, -t}, inside);
}

ClosestPoints closest_points(PairKind kind, const FourPoints& x) {
  return kind == PairKind::point_triangle ? closest_point_triangle(x) : closest_edge_edge(x);
}

}  // namespace drape

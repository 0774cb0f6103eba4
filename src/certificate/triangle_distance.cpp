#include "certificate/triangle_distance.h"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double clamp_to_segment(double parameter) { return std::clamp(parameter, 0.0, 1.0); }

// Source: C. Ericson, Real-Time Collision Detection, 2005, section 5.1.9: the parameter on the first segment
// from the two lines, clamped, then the second's from it, clamped, and the first's once more from that.
double squared_segment_distance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  const Vec3 u = q - p, v = b - a, r = p - a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), ur = u.dot(r), vr = v.dot(r);
  if (uu == 0 && vv == 0) return r.squaredNorm();
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 0 ? clamp_to_segment((uv * vr - ur * vv) / determinant) : 0;
  const double t = vv > 0 ? clamp_to_segment((uv * s + vr) / vv) : 0;
  if (uu > 0) s = clamp_to_segment((uv * t - ur) / uu);
  return (r + s * u - t * v).squaredNorm();
}

// A triangle as far as it is the same for all points.
struct Facet {
  explicit Facet(const TrianglePoints& t)
      : corner(t[0]), u(t[1] - t[0]), v(t[2] - t[0]), normal(u.cross(v)) {}
  Vec3 corner, u, v, normal;
};

// From a point straight above or below the triangle; infinite from others, to which an edge is nearer.
double squared_distance_above(const Vec3& p, const Facet& facet) {
  const double size = facet.normal.squaredNorm();
  if (size == 0) return infinity;
  const Vec3 r = p - facet.corner;
  const double along_u = r.cross(facet.v).dot(facet.normal), along_v = facet.u.cross(r).dot(facet.normal);
  if (along_u < 0 || along_v < 0 || along_u + along_v > size) return infinity;
  const double height = r.dot(facet.normal);
  return height * height / size;
}

double squared_edge_distance(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  return std::min({squared_segment_distance(p, q, t[0], t[1]), squared_segment_distance(p, q, t[1], t[2]),
                   squared_segment_distance(p, q, t[2], t[0])});
}

}  // namespace

double segment_distance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  return std::sqrt(squared_segment_distance(p, q, a, b));
}

double segment_triangle_distance(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  if (segment_meets_triangle(p, q, t)) return 0;
  const Facet facet(t);
  return std::sqrt(std::min(
      {squared_distance_above(p, facet), squared_distance_above(q, facet), squared_edge_distance(p, q, t)}));
}

double triangle_distance(const TrianglePoints& a, const TrianglePoints& b) {
  const Facet facet_a(a), facet_b(b);
  double least = infinity;
  for (int k = 0; k < 3; ++k) {
    least = std::min({least, squared_distance_above(a[k], facet_b), squared_distance_above(b[k], facet_a)});
    least = std::min(least, squared_edge_distance(a[k], a[(k + 1) % 3], b));
  }
  return std::sqrt(least);
}

}  // namespace drape

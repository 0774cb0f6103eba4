#include "deformation/bending_angle.h"

#include <cmath>

namespace drape {

// BMF03 has sqrt((1 - n1 . n2) / 2) for sin(theta / 2), which loses angles of less than 1e-8 to rounding;
// |n1 - n2| / 2 is equal and loses nothing.
static double half_sine_between(const Vec3& n1, const Vec3& n2, const Vec3& edge) {
  return std::copysign(0.5 * (n1 - n2).norm(), n1.cross(n2).dot(edge));
}

BendingAngle bending_angle(const std::array<int, 4>& vertices, const std::vector<Vec3>& x) {
  const Vec3 &x1 = x[vertices[0]], &x2 = x[vertices[1]], &x3 = x[vertices[2]], &x4 = x[vertices[3]];
  const Vec3 normal1 = (x1 - x3).cross(x1 - x4), normal2 = (x2 - x4).cross(x2 - x3);  // N1, N2
  const Vec3 edge = x4 - x3;                                                          // E
  const double length1 = normal1.norm(), length2 = normal2.norm(), length = edge.norm();
  if (!(length1 > 0 && length2 > 0)) return {0, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
  const Vec3 n1 = normal1 / length1, n2 = normal2 / length2, e = edge / length;
  const Vec3 m1 = n1 / length1, m2 = n2 / length2;  // N / |N|2
  const auto share = [&](const Vec3& end) { return Vec3((x1 - end).dot(e) * m1 + (x2 - end).dot(e) * m2); };
  return {half_sine_between(n1, n2, e), {-length * m1, -length * m2, -share(x4), share(x3)}};
}

}  // namespace drape

#include "deformation/triangle_match.h"

#include <cassert>

namespace drape {

// The coordinates of the rest points in their own plane, relative to the centre of mass.
static std::array<Vec2, 3> flattened(const std::array<Vec3, 3>& rest, const std::array<double, 3>& masses) {
  const Vec3 e1 = rest[1] - rest[0];
  const Vec3 e2 = rest[2] - rest[0];
  const Vec3 x_axis = e1.normalized();
  const Vec3 y_axis = e1.cross(e2).cross(e1).normalized();
  std::array<Vec2, 3> q = {Vec2(0, 0), Vec2(e1.norm(), 0), Vec2(e2.dot(x_axis), e2.dot(y_axis))};
  const double total = masses[0] + masses[1] + masses[2];
  const Vec2 centre = (masses[0] * q[0] + masses[1] * q[1] + masses[2] * q[2]) / total;
  for (Vec2& point : q) point -= centre;
  return q;
}

MatchConstants<double> match_constants(const std::array<Vec3, 3>& rest, const std::array<double, 3>& masses) {
  const auto q = flattened(rest, masses);
  const Vec2 up = q[2].normalized();
  const Vec2 right(up.y(), -up.x());
  const auto turned = [&](int i) { return Vec2(right.dot(q[i]), up.dot(q[i])); };
  const Vec2 q1 = turned(0), q2 = turned(1);
  const double q3y = q[2].norm();
  assert(q2.x() > 0);
  const double total = masses[0] + masses[1] + masses[2];
  return {q1.x(),
          q1.y(),
          q2.x(),
          q2.y(),
          q3y,
          q2.y() / q2.x(),
          (masses[2] * q3y) / (masses[1] * q2.x()),
          masses[1] / total,
          masses[2] / total};
}

}  // namespace drape

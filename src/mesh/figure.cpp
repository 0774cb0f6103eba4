#include "mesh/figure.h"

#include <algorithm>

#include "mesh/turn_between.h"

namespace drape {
namespace {

Vec3 between(const Vec3& a, const Vec3& b, double share) { return a + share * (b - a); }
Quaternion between(const Quaternion& a, const Quaternion& b, double share) {
  return turn_between(a.normalized(), b.normalized(), share);
}

template <typename Value>
Value value_at(const TimedValues<Value>& timed, double time) {
  const auto after = std::upper_bound(timed.times.begin(), timed.times.end(), time);
  if (after == timed.times.begin()) return timed.values.front();
  if (after == timed.times.end()) return timed.values.back();
  const std::size_t i = static_cast<std::size_t>(after - timed.times.begin());
  const double share = (time - timed.times[i - 1]) / (timed.times[i] - timed.times[i - 1]);
  return between(timed.values[i - 1], timed.values[i], share);
}

Mat4 placement_at(const NodeMotion& motion, double time) {
  Mat4 placement = Mat4::Identity();
  placement.topLeftCorner<3, 3>() =
      value_at(motion.turn, time).normalized().toRotationMatrix() * value_at(motion.scale, time).asDiagonal();
  placement.topRightCorner<3, 1>() = value_at(motion.place, time);
  return placement;
}

// Of each node, to the world.
std::vector<Mat4> place_nodes(const Figure& figure, double time) {
  std::vector<Mat4> placements;
  for (const FigureNode& node : figure.nodes) {
    const Mat4 own = node.motion < 0 ? node.rest : placement_at(figure.motions[node.motion], time);
    placements.push_back(node.parent < 0 ? own : Mat4(placements[node.parent] * own));
  }
  return placements;
}

Vec3 transform(const Mat4& placement, const Vec3& point) {
  return placement.topLeftCorner<3, 3>() * point + placement.topRightCorner<3, 1>();
}

void append_posed(const FigureSurface& surface, const std::vector<Mat4>& nodes, std::vector<Vec3>& out) {
  std::vector<Vec3> sums(surface.points.size(), Vec3::Zero());
  std::vector<double> shares(surface.points.size(), 0);
  for (const Bone& bone : surface.bones) {
    const Mat4 placement = nodes[bone.node] * bone.from_surface;
    for (const auto& [point, share] : bone.shares) {
      sums[point] += share * transform(placement, surface.points[point]);
      shares[point] += share;
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    out.push_back(shares[i] > 0 ? Vec3(sums[i] / shares[i])
                                : transform(nodes[surface.node], surface.points[i]));
}

}  // namespace

std::vector<Vec3> pose_figure(const Figure& figure, double time) {
  const std::vector<Mat4> nodes = place_nodes(figure, time);
  std::vector<Vec3> points;
  for (const FigureSurface& surface : figure.surfaces) append_posed(surface, nodes, points);
  return points;
}

}  // namespace drape

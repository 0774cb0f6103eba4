#include "deformation/split_points.h"

#include "core/parallel.h"
#include "deformation/sweep_order.h"

namespace drape {

void split_points(const std::vector<Vec3>& points, std::size_t count, SplitPoints& split) {
  split.high.resize(count);
  split.low.resize(count);
  parallel_for_each(points.size(), 1024, [&](std::size_t v) {
    const Eigen::Vector3f high = points[v].cast<float>();
    const Eigen::Vector3f low = (points[v] - high.cast<double>()).cast<float>();
    split.high[v] = {high.x(), high.y(), high.z(), 0};
    split.low[v] = {low.x(), low.y(), low.z(), 0};
  });
  constexpr Point4 filler_corners[fillers_a_patch] = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}};
  for (std::size_t v = points.size(); v < count; ++v) {
    split.high[v] = filler_corners[(v - points.size()) % fillers_a_patch];
    split.low[v] = {};
  }
}

}  // namespace drape

#pragma once

#include <vector>

#include "core/lanes.h"
#include "core/vector.h"

namespace drape {

// Points in double precision as sums of two floats. A difference of two of them is right to about a float's
// last digit however far from the origin they lie, and vector instructions take it as it comes.
struct SplitPoints {
  std::vector<Point4> high, low;
};

// `points`, then fillers up to `count`: corners of one triangle over and over (fillers_a_patch).
void split_points(const std::vector<Vec3>& points, std::size_t count, SplitPoints& split);

template <typename Number>
struct SplitPoint {
  LaneVec3<Number> high, low;
};
template <typename Number>
SplitPoint<Number> gather(const LaneAccess<Number>& access, const SplitPoints& points,
                          const IndexRow& indices) {
  return {access.gather(points.high.data(), indices).p, access.gather(points.low.data(), indices).p};
}
template <typename Number>
LaneVec3<Number> operator-(const SplitPoint<Number>& a, const SplitPoint<Number>& b) {
  return (a.high - b.high) + (a.low - b.low);
}

}  // namespace drape

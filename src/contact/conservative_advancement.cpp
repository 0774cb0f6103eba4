#include "contact/conservative_advancement.h"

#include <algorithm>
#include <cmath>

namespace drape {

static FourPoints displacements_less_mean(const FourPoints& start, const FourPoints& end) {
  FourPoints motion;
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < 4; ++i) {
    motion[i] = end[i] - start[i];
    mean += 0.25 * motion[i];
  }
  for (Vec3& m : motion) m -= mean;
  return motion;
}

static double motion_bound(PairKind kind, const FourPoints& motion) {
  double largest[2] = {0, 0};
  for (int i = 0; i < 4; ++i) {
    double& side = largest[i < first_side(kind) ? 0 : 1];
    side = std::max(side, motion[i].squaredNorm());
  }
  return std::sqrt(largest[0]) + std::sqrt(largest[1]);
}

double relative_motion(PairKind kind, const FourPoints& start, const FourPoints& end) {
  return motion_bound(kind, displacements_less_mean(start, end));
}

std::optional<double> time_of_contact(PairKind kind, const FourPoints& start, const FourPoints& end,
                                      double distance, double tolerance) {
  const FourPoints motion = displacements_less_mean(start, end);
  const double bound = motion_bound(kind, motion);
  constexpr int most_advances = 100;  // a pair that takes more is all but touching
  double time = 0;
  for (int i = 0; i < most_advances; ++i) {
    FourPoints x;
    for (int k = 0; k < 4; ++k) x[k] = start[k] + time * motion[k];
    const double room = closest_points(kind, x).distance - distance;
    if (room <= tolerance) return time;
    if (room > bound * (1 - time)) return std::nullopt;
    time += 0.9 * room / bound;
  }
  return time;
}

}  // namespace drape

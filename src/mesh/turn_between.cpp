#include "mesh/turn_between.h"

namespace drape {

// The arc is halved, towards the share, until the straight line across what is left is as good: its error is
// under a hundredth of the cube of an angle of 4e-5.
Quaternion turn_between(const Quaternion& from, const Quaternion& to, double share) {
  constexpr int halvings = 16;
  Vec4 begin = from.coeffs(), end = to.coeffs();
  if (begin.dot(end) < 0) end = -end;  // the same turn, written the other way
  for (int i = 0; i < halvings; ++i) {
    const Vec4 middle = (begin + end).normalized();
    const bool is_behind = share >= 0.5;
    (is_behind ? begin : end) = middle;
    share = 2 * share - (is_behind ? 1 : 0);
  }
  return Quaternion(Vec4(begin + share * (end - begin)).normalized());
}

}  // namespace drape

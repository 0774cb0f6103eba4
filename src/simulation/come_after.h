#pragma once

#include "core/vector.h"

namespace drape {

// Where a point at `place` gets in `duration` seconds that is to go from `from` to `to`. Most are at `from`.
// One that contact has kept from it comes after with haste, half a metre a second more, and not in one leap.
inline Vec3 come_after(const Vec3& place, const Vec3& from, const Vec3& to, double duration) {
  constexpr double haste = 0.5;  // m/s
  const Vec3 way = to - place;
  const double longest = (to - from).norm() + haste * duration, length = way.norm();
  return length > longest ? Vec3(place + way * (longest / length)) : to;
}

}  // namespace drape

#pragma once

#include <cmath>

#include "core/vector.h"

namespace drape::render {

// Right-handed axes of unit length.
struct Axes {
  Vec3f right;
  Vec3f up;
  Vec3f forward;
};

// With `up` as near to +y as it can be; straight up and down, as near to -z.
inline Axes axes_along(const Vec3f& direction) {
  const Vec3f forward = direction.normalized();
  const bool is_vertical = std::abs(forward.y()) > 0.9999f;
  const Vec3f hint = is_vertical ? Vec3f(0, 0, -1) : Vec3f(0, 1, 0);
  const Vec3f right = hint.cross(forward).normalized();
  return {right, forward.cross(right), forward};
}

}  // namespace drape::render

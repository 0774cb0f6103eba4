#include "certificate/orientation.h"

#include <cmath>

#include "certificate/expansion.h"

namespace drape {

// Bounds of the rounding errors of the determinants below as shares of the sums of their terms' sizes
// (Shewchuk 1997, figures 21 and 22), with half the distance from 1 to the next double.
static constexpr double unit = 0x1p-53;
static constexpr double bound_in_space = (7 + 56 * unit) * unit;
static constexpr double bound_in_plane = (3 + 16 * unit) * unit;

static int sign(double value) { return (value > 0) - (value < 0); }

static int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto row = [&](const Vec3& p, int k) { return exact_difference(p[k], d[k]); };
  const auto minor = [&](const Vec3& p, const Vec3& q) {
    return row(p, 0) * row(q, 1) - row(q, 0) * row(p, 1);
  };
  return (minor(b, c) * row(a, 2) + minor(c, a) * row(b, 2) + minor(a, b) * row(c, 2)).sign();
}

// Terms of 0 alone come from differences that are 0, which is exact: cloth that lies in a plane of the axes.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double vw = v.x() * w.y(), wv = w.x() * v.y(), wu = w.x() * u.y(), uw = u.x() * w.y(),
               uv = u.x() * v.y(), vu = v.x() * u.y();
  const double determinant = u.z() * (vw - wv) + v.z() * (wu - uw) + w.z() * (uv - vu);
  const double sizes = std::abs(u.z()) * (std::abs(vw) + std::abs(wv)) +
                       std::abs(v.z()) * (std::abs(wu) + std::abs(uw)) +
                       std::abs(w.z()) * (std::abs(uv) + std::abs(vu));
  const bool is_sure = std::abs(determinant) > bound_in_space * sizes || sizes == 0;
  return is_sure ? sign(determinant) : exact_orientation(a, b, c, d);
}

int orientation_without(int axis, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int i = (axis + 1) % 3, k = (axis + 2) % 3;
  const double left = (a[i] - c[i]) * (b[k] - c[k]), right = (a[k] - c[k]) * (b[i] - c[i]);
  const double determinant = left - right, sizes = std::abs(left) + std::abs(right);
  if (std::abs(determinant) > bound_in_plane * sizes || sizes == 0) return sign(determinant);
  const auto row = [&](const Vec3& p, int j) { return exact_difference(p[j], c[j]); };
  return (row(a, i) * row(b, k) - row(a, k) * row(b, i)).sign();
}

int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int axis = 0; axis < 3; ++axis)
    if (orientation_without(axis, a, b, c) != 0) return axis;
  return -1;
}

}  // namespace drape

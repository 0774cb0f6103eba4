#include "certificate/whole_numbers.h"

#include <algorithm>
#include <vector>

namespace drape::test {

static Whole minus(const Whole& a, const Whole& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

static Whole cross(const Whole& a, const Whole& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

static Long dot(const Whole& a, const Whole& b) {
  return Long{a[0]} * b[0] + Long{a[1]} * b[1] + Long{a[2]} * b[2];
}

static bool is_zero(const Whole& a) { return a == Whole{0, 0, 0}; }

Vec3 to_vector(const Whole& p, double scale, double offset) {
  const auto at = [&](int k) { return offset + scale * static_cast<double>(p[k]); };
  return {at(0), at(1), at(2)};
}

Long determinant(const Whole& a, const Whole& b, const Whole& c, const Whole& d) {
  const Whole u = minus(a, d), v = minus(b, d), w = minus(c, d);
  const auto minor = [&](int i, int k) { return Long{v[i]} * w[k] - Long{v[k]} * w[i]; };
  return u[0] * minor(1, 2) - u[1] * minor(0, 2) + u[2] * minor(0, 1);
}

static bool separates(const Whole& axis, const WholeTriangle& a, const WholeTriangle& b) {
  const auto range = [&](const WholeTriangle& t) {
    return std::minmax({dot(axis, t[0]), dot(axis, t[1]), dot(axis, t[2])});
  };
  const auto [low_a, high_a] = range(a);
  const auto [low_b, high_b] = range(b);
  return high_a < low_b || high_b < low_a;
}

// The difference of the two sets is a polytope of up to three dimensions. Where it does not hold the origin,
// an axis across one of its faces separates them, or one across all of it where it is flat.
bool no_axis_separates(const WholeTriangle& a, const WholeTriangle& b) {
  std::vector<Whole> edges;
  for (const WholeTriangle& t : {a, b})
    for (int k = 0; k < 3; ++k) edges.push_back(minus(t[(k + 1) % 3], t[k]));
  const Whole between = minus(a[0], b[0]);
  std::vector<Whole> axes = edges;
  axes.push_back(between);
  for (const Whole& d : edges) {
    axes.push_back(cross(cross(between, d), d));
    for (const Whole& e : edges) {
      axes.push_back(cross(d, e));
      for (const Whole& f : edges) axes.push_back(cross(cross(d, e), f));
    }
  }
  return std::none_of(axes.begin(), axes.end(), [&](const Whole& axis) { return separates(axis, a, b); });
}

bool has_area(const WholeTriangle& t) { return !is_zero(cross(minus(t[1], t[0]), minus(t[2], t[0]))); }

// Whether the direction lies in the wedge from u to v, in whose plane it is.
static bool is_in_wedge(const Whole& direction, const Whole& u, const Whole& v) {
  const Whole normal = cross(u, v);
  return dot(cross(u, direction), normal) >= 0 && dot(cross(direction, v), normal) >= 0;
}

bool wedges_overlap(const WholeTriangle& a, const WholeTriangle& b) {
  const Whole u = minus(a[1], a[0]), v = minus(a[2], a[0]), p = minus(b[1], b[0]), q = minus(b[2], b[0]);
  const Whole line = cross(cross(u, v), cross(p, q)), back = minus({0, 0, 0}, line);
  const auto in_both = [&](const Whole& d) { return is_in_wedge(d, u, v) && is_in_wedge(d, p, q); };
  if (!is_zero(line)) return in_both(line) || in_both(back);
  return is_in_wedge(u, p, q) || is_in_wedge(v, p, q) || is_in_wedge(p, u, v) || is_in_wedge(q, u, v);
}

}  // namespace drape::test

#include <gtest/gtest.h>

#include "contact/intersections.h"
#include "scene.h"

namespace drape {
namespace {

using test::Random;
using Pairs = std::vector<std::pair<int, int>>;

// Two triangles of six points, or of five with the first in common.
Pairs of_two(const std::vector<Vec3f>& x) {
  const Triangle second = x.size() == 6 ? Triangle{3, 4, 5} : Triangle{0, 3, 4};
  return intersecting_triangles(x, {{0, 1, 2}, second});
}

double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).dot((c - a).cross(d - a));
}

// Whether the segment (p, q) passes through the triangle: by the point where it meets the plane.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double at_p = volume(a, b, c, p), at_q = volume(a, b, c, q);
  if (at_p * at_q > 0) return false;
  const Vec3 x = p + at_p / (at_p - at_q) * (q - p);
  return closest_point_triangle({x, a, b, c}).distance < 1e-12;
}

bool by_double(const std::vector<Vec3f>& points, const Triangle& s, const Triangle& t) {
  const auto x = [&](int v) { return Vec3(points[v].cast<double>()); };
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    if (pierces(x(s[k]), x(s[l]), x(t[0]), x(t[1]), x(t[2]))) return true;
    if (pierces(x(t[k]), x(t[l]), x(s[0]), x(s[1]), x(s[2]))) return true;
  }
  return false;
}

TEST(Intersections, EqualBruteForceOnRandomTriangles) {
  Random random(1);
  std::vector<Vec3f> x;
  std::vector<Triangle> triangles;
  for (int t = 0; t < 150; ++t) {
    const Vec3 centre = random.vector();
    for (int k = 0; k < 3; ++k) x.push_back((centre + random.vector(0.4)).cast<float>());
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  Pairs wanted;
  for (int s = 0; s < 150; ++s)
    for (int t = s + 1; t < 150; ++t)
      if (by_double(x, triangles[s], triangles[t])) wanted.emplace_back(s, t);
  EXPECT_GT(wanted.size(), 50u);
  EXPECT_EQ(intersecting_triangles(x, triangles), wanted);
}

TEST(Intersections, TouchingCountsAndTheNextFloatDoesNot) {
  for (const float height : {0.0f, std::nextafter(0.0f, 1.0f)}) {
    const Pairs pairs =
        of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2f, 0.2f, height}, {0.2f, 0.3f, 1}, {0.3f, 0.2f, 1}});
    EXPECT_EQ(pairs.size(), height == 0 ? 1u : 0u);
  }
}

// Far from the origin, where sums of products round.
TEST(Intersections, SignsAreExactForFloatsFarOut) {
  const float far = 4096, unit = std::nextafter(far, 2 * far) - far;
  for (const float height : {-unit, 0.0f, unit}) {
    const Pairs pairs = of_two({{far, far, far},
                                {far + 64, far, far + 64},
                                {far, far + 64, far + 64},
                                {far + 16, far + 16, far + 32 + height},
                                {far + 16, far + 17, far + 128},
                                {far + 17, far + 16, far + 128}});
    EXPECT_EQ(pairs.size(), height > 0 ? 0u : 1u);
  }
}

// Whole numbers of 22 bits: their determinants have more bits than a double.
TEST(Intersections, APointExactlyInATrianglesPlaneTouchesIt) {
  Random random(2);
  const auto whole = [&] { return Vec3(4 * random.vector(1 << 20).array().round()); };
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3 a = whole(), u = whole() - a, v = whole() - a;
    const Vec3 touching = a + (u + v) / 4, above = touching + u.cross(v).normalized() * (1 << 20);
    std::vector<Vec3f> x;
    for (const Vec3& point : {a, Vec3(a + u), Vec3(a + v), touching, above, Vec3(above + u / 2)})
      x.push_back(point.cast<float>());
    ASSERT_EQ(Vec3(x[3].cast<double>()), touching);
    EXPECT_EQ(of_two(x).size(), 1u) << "trial " << trial;
  }
}

TEST(Intersections, OneCommonVertexIsNoneAndMeetingBeyondItIsOne) {
  EXPECT_TRUE(of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0.5f}, {0, -1, 0.5f}}).empty());
  EXPECT_EQ(of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 0.5f, 0.5f}, {0.2f, 0.2f, -0.5f}}).size(), 1u);
}

TEST(Intersections, ASmoothMeshHasNone) {
  for (const TriangleMesh& mesh : {make_sphere(1, 16, 9), make_grid({1, 1}, {8, 8}), make_box({1, 1, 1})}) {
    std::vector<Vec3f> x;
    for (const Vec3& p : mesh.positions) x.push_back(p.cast<float>());
    EXPECT_TRUE(intersecting_triangles(x, mesh.triangles).empty());
  }
}

}  // namespace
}  // namespace drape

#include "certificate/surface_certificate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "certificate/triangle_meeting.h"
#include "certificate/whole_numbers.h"
#include "contact/scene.h"
#include "core/parallel.h"

namespace drape {
namespace {

using test::Random;
using Pairs = std::vector<TrianglePair>;

const double nan = std::numeric_limits<double>::quiet_NaN();

// Two triangles of six points, or of five with the first in common, or of four with two.
Pairs of_two(const std::vector<Vec3>& x) {
  Triangle second{3, 4, 5};
  if (x.size() == 5) second = {0, 3, 4};
  if (x.size() == 4) second = {1, 0, 3};
  return intersecting_triangles(x, {{0, 1, 2}, second});
}

TEST(IntersectingTriangles, EqualBruteForceOnSoups) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    test::WholeRandom random(seed);
    std::vector<test::WholeTriangle> soup;
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int t = 0; t < 120; ++t) {
      const test::Whole centre = random.point(15);
      soup.push_back(random.triangle(5));
      for (test::Whole& p : soup.back()) {
        for (int k = 0; k < 3; ++k) p[k] += centre[k];
        points.push_back(test::to_vector(p));
      }
      triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    Pairs wanted;
    for (int s = 0; s < 120; ++s)
      for (int t = s + 1; t < 120; ++t)
        if (test::no_axis_separates(soup[s], soup[t])) wanted.emplace_back(s, t);
    EXPECT_GT(wanted.size(), 30u);
    EXPECT_EQ(intersecting_triangles(points, triangles), wanted);
  }
}

TEST(IntersectingTriangles, TouchingCountsAndTheNextNumberDoesNot) {
  for (const double height : {0.0, std::nextafter(0.0, 1.0)}) {
    const Pairs pairs =
        of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, height}, {0.2, 0.3, 1}, {0.3, 0.2, 1}});
    EXPECT_EQ(pairs.size(), height == 0 ? 1u : 0u);
  }
}

// Far from the origin, where sums of products round.
TEST(IntersectingTriangles, SignsAreExactFarOut) {
  const double far = 4096, unit = std::nextafter(far, 2 * far) - far;
  for (const double height : {-unit, 0.0, unit}) {
    const Pairs pairs = of_two({{far, far, far},
                                {far + 64, far, far + 64},
                                {far, far + 64, far + 64},
                                {far + 16, far + 16, far + 32 + height},
                                {far + 16, far + 17, far + 128},
                                {far + 17, far + 16, far + 128}});
    EXPECT_EQ(pairs.size(), height > 0 ? 0u : 1u);
  }
}

TEST(IntersectingTriangles, OneCommonVertexIsNoneAndMeetingBeyondItIsOne) {
  EXPECT_TRUE(of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0.5}, {0, -1, 0.5}}).empty());
  EXPECT_EQ(of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0.5}, {0.2, 0.2, -0.5}}).size(), 1u);
}

TEST(IntersectingTriangles, NeighboursAreOneOnlyWhereFoldedFlat) {
  EXPECT_TRUE(of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}).empty());
  EXPECT_TRUE(of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1e-9}}).empty());
  EXPECT_EQ(of_two({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.5, 0}}).size(), 1u);
}

TEST(IntersectingTriangles, TheSameCornersTwiceAreOne) {
  EXPECT_EQ(intersecting_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}).size(), 1u);
}

TEST(IntersectingTriangles, ASmoothMeshHasNone) {
  for (const TriangleMesh& mesh : {make_sphere(1, 16, 9), make_grid({1, 1}, {8, 8}), make_box({1, 1, 1})})
    EXPECT_TRUE(intersecting_triangles(mesh.positions, mesh.triangles).empty());
}

// A flat sheet, turned so that no coordinate is the same twice: all neighbours are nearly in one plane.
TEST(IntersectingTriangles, ATurnedFlatSheetHasNoneAndFoldedInHalfMany) {
  const Mat3 rotation = Random(4).rotation();
  const TriangleMesh mesh = make_grid({1, 1}, {9, 9});
  std::vector<Vec3> flat, folded;
  for (const Vec3& p : mesh.positions)
    flat.push_back(rotation * p), folded.push_back({std::abs(p.x()), 0, p.z()});
  EXPECT_TRUE(intersecting_triangles(flat, mesh.triangles).empty());
  EXPECT_GT(intersecting_triangles(folded, mesh.triangles).size(), 128u);
}

// Two sheets over each other, the upper one waved.
struct Sheets {
  Sheets() {
    for (const double height : {0.0, 0.02}) {
      const int first = static_cast<int>(positions.size());
      const TriangleMesh mesh = make_grid({1, 1}, {30, 30});
      Random random(3);
      for (const Vec3& p : mesh.positions)
        positions.push_back(p + Vec3(0, height * (1 + 0.5 * std::sin(7 * p.x() + 3 * p.z())), 0) +
                            random.vector(0.002));
      for (const auto& [a, b, c] : mesh.triangles) triangles.push_back({a + first, b + first, c + first});
    }
  }
  std::vector<Vec3> positions;
  std::vector<Triangle> triangles;
};

double brute_gap(const Sheets& sheets) {
  const auto at = [&](int v) { return sheets.positions[v]; };
  double least = 1e300;
  for (const Triangle& s : sheets.triangles)
    for (const Triangle& t : sheets.triangles) {
      if (std::find_first_of(s.begin(), s.end(), t.begin(), t.end()) != s.end()) continue;
      for (int i = 0; i < 3; ++i) {
        least = std::min(least, closest_point_triangle({at(s[i]), at(t[0]), at(t[1]), at(t[2])}).distance);
        for (int k = 0; k < 3; ++k)
          least = std::min(
              least,
              closest_edge_edge({at(s[i]), at(s[(i + 1) % 3]), at(t[k]), at(t[(k + 1) % 3])}).distance);
      }
    }
  return least;
}

TEST(SurfaceCertificate, TheGapEqualsBruteForceAndIsThatOfItsTriangles) {
  const Sheets sheets;
  const SurfaceCertificate certificate = certify_surface(sheets.positions, sheets.triangles);
  EXPECT_TRUE(certificate.is_finite);
  EXPECT_TRUE(certificate.intersecting.empty());
  EXPECT_NEAR(certificate.smallest_gap.distance, brute_gap(sheets), 1e-14);
  Sheets two = sheets;
  const auto [s, t] = certificate.smallest_gap.triangles;
  two.triangles = {sheets.triangles[s], sheets.triangles[t]};
  EXPECT_NEAR(brute_gap(two), certificate.smallest_gap.distance, 1e-14);
}

// In a sheet alone, the nearest triangles that share no vertex are those two rows apart.
TEST(SurfaceCertificate, TheGapOfAFlatSheetIsAboutACell) {
  const TriangleMesh mesh = make_grid({1, 1}, {11, 11});
  EXPECT_NEAR(certify_surface(mesh.positions, mesh.triangles).smallest_gap.distance, 0.1 / std::sqrt(2),
              1e-12);
}

TEST(SurfaceCertificate, TheGapIsZeroWhereTrianglesApartMeetAndNoneWhereAllShareAVertex) {
  const std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}, {0.2, 0.3, 1}, {0.3, 0.2, 1}};
  const SurfaceCertificate crossing = certify_surface(x, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(crossing.smallest_gap.distance, 0);
  EXPECT_EQ(crossing.smallest_gap.triangles, TrianglePair(0, 1));
  EXPECT_TRUE(std::isinf(certify_surface(x, {{0, 1, 2}, {0, 3, 4}}).smallest_gap.distance));
}

TEST(SurfaceCertificate, DoesNotDependOnThreads) {
  Sheets sheets;
  for (std::size_t v = 900; v < 1800; ++v) sheets.positions[v].y() -= 0.02;
  const auto certificate = [&](int threads) {
    const ThreadLimit limit(threads);
    return certify_surface(sheets.positions, sheets.triangles);
  };
  const SurfaceCertificate one = certificate(1), two = certificate(2);
  EXPECT_GT(one.intersecting.size(), 0u);
  EXPECT_EQ(one.intersecting, two.intersecting);
  EXPECT_EQ(one.smallest_gap.distance, two.smallest_gap.distance);
  EXPECT_EQ(one.smallest_gap.triangles, two.smallest_gap.triangles);
}

// Sheets that cross: what is found where some points are nowhere is what was found before, without theirs.
TEST(SurfaceCertificate, KnowsWhatIsNotFiniteAndCertifiesTheRest) {
  for (const double wrong : {nan, std::numeric_limits<double>::infinity()}) {
    Sheets sheets;
    for (std::size_t v = 900; v < 1800; ++v) sheets.positions[v].y() -= 0.02;
    Pairs wanted = certify_surface(sheets.positions, sheets.triangles).intersecting;
    for (std::size_t v = 0; v < 1800; v += 7) sheets.positions[v][v % 3] = wrong;
    const auto has_place = [&](int t) {
      const Triangle& corners = sheets.triangles[t];
      return std::all_of(corners.begin(), corners.end(),
                         [&](int v) { return sheets.positions[v].allFinite(); });
    };
    std::erase_if(wanted, [&](const TrianglePair& p) { return !has_place(p.first) || !has_place(p.second); });
    const SurfaceCertificate certificate = certify_surface(sheets.positions, sheets.triangles);
    EXPECT_FALSE(certificate.is_finite);
    EXPECT_GT(wanted.size(), 100u);
    EXPECT_EQ(certificate.intersecting, wanted);
  }
}

TEST(EdgeStretch, IsTheLeastAndTheMostOfAllEdges) {
  const std::vector<Vec3> rest = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  const StretchRange range = edge_stretch(rest, {{0, 0, 0}, {1.5, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  EXPECT_DOUBLE_EQ(range.largest, 1.5);
  EXPECT_DOUBLE_EQ(range.smallest, 0.5);
  EXPECT_TRUE(std::isnan(edge_stretch(rest, {{0, 0, 0}, {nan, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).largest));
}

TEST(EdgeStretch, LeavesOutEdgesWithoutALength) {
  const StretchRange range =
      edge_stretch({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {5, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  EXPECT_DOUBLE_EQ(range.largest, 4);
  EXPECT_DOUBLE_EQ(range.smallest, 1);
}

TrianglePoints points_of(const TriangleMesh& mesh, const Triangle& t) {
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

TEST(TrianglesThatMeet, AreThoseOfTheSheetThatABallComesThrough) {
  const TriangleMesh sheet = make_grid({1, 1}, {21, 21}), ball = make_sphere(0.2, 32, 16);
  const std::vector<int> found =
      triangles_that_meet(sheet.positions, sheet.triangles, ball.positions, ball.triangles);
  std::vector<int> wanted;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    for (const Triangle& other : ball.triangles)
      if (triangles_meet(points_of(sheet, sheet.triangles[t]), points_of(ball, other))) {
        wanted.push_back(t);
        break;
      }
  EXPECT_GT(wanted.size(), 20u);
  EXPECT_EQ(found, wanted);
  std::vector<Vec3> above = ball.positions;
  for (Vec3& p : above) p.y() += 0.21;
  EXPECT_TRUE(triangles_that_meet(sheet.positions, sheet.triangles, above, ball.triangles).empty());
}

}  // namespace
}  // namespace drape

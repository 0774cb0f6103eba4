#include "certificate/triangle_meeting.h"

#include <gtest/gtest.h>

#include "certificate/whole_numbers.h"

namespace drape {
namespace {

using test::has_area;
using test::no_axis_separates;
using test::to_vector;
using test::wedges_overlap;
using test::Whole;
using test::WholeRandom;
using test::WholeTriangle;

// At a scale and a place where sums of products round, so that signs are decided exactly.
TrianglePoints placed(const WholeTriangle& t) {
  const double scale = 0x1p-30, offset = 4096;
  return {to_vector(t[0], scale, offset), to_vector(t[1], scale, offset), to_vector(t[2], scale, offset)};
}

// In a space of few points, where all kinds of touching, of coplanar and of degenerate triangles are common.
TEST(TriangleMeeting, EqualsSeparatingAxesOnWholeNumbers) {
  WholeRandom random(1);
  int meeting = 0, degenerate = 0;
  for (const long long largest : {1, 2, 3, 6})
    for (int trial = 0; trial < 20000; ++trial) {
      const WholeTriangle a = random.triangle(largest), b = random.triangle(largest);
      const bool wanted = no_axis_separates(a, b);
      meeting += wanted;
      degenerate += !has_area(a) || !has_area(b);
      ASSERT_EQ(triangles_meet(placed(a), placed(b)), wanted) << "trial " << trial << " of " << largest;
    }
  EXPECT_GT(meeting, 10000);
  EXPECT_GT(degenerate, 5000);
}

// All in one plane, which lies across all axes.
TEST(TriangleMeeting, EqualsSeparatingAxesInAPlane) {
  WholeRandom random(2);
  const auto into_plane = [](WholeTriangle t) {
    for (Whole& p : t) p = {p[0] + 2 * p[1], p[1] - p[0], 3 * p[0] + p[1]};
    return t;
  };
  int meeting = 0;
  for (int trial = 0; trial < 40000; ++trial) {
    const WholeTriangle a = into_plane(random.triangle(4)), b = into_plane(random.triangle(4));
    const bool wanted = no_axis_separates(a, b);
    meeting += wanted;
    ASSERT_EQ(triangles_meet(placed(a), placed(b)), wanted) << "trial " << trial;
  }
  EXPECT_GT(meeting, 10000);
  EXPECT_LT(meeting, 39000);
}

TEST(TriangleMeeting, BeyondACommonVertexEqualsOverlappingWedges) {
  WholeRandom random(3);
  int meeting = 0;
  for (const long long largest : {1, 2, 5})
    for (int trial = 0; trial < 20000; ++trial) {
      const WholeTriangle a = random.triangle(largest);
      WholeTriangle b = random.triangle(largest);
      b[0] = a[0];
      if (!has_area(a) || !has_area(b)) continue;
      const bool wanted = wedges_overlap(a, b);
      meeting += wanted;
      ASSERT_EQ(meet_beyond_vertex(placed(a), placed(b)), wanted) << "trial " << trial << " of " << largest;
    }
  EXPECT_GT(meeting, 5000);
}

const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);

TEST(TriangleMeeting, OneWithinAnotherOfItsPlaneMeetsIt) {
  EXPECT_TRUE(triangles_meet({o, 4 * x, 4 * y}, {x + y, 1.5 * x + y, x + 1.5 * y}));
  EXPECT_FALSE(triangles_meet({o, 4 * x, 4 * y}, {4 * x + y, 5 * x + y, 4 * x + 2 * y}));
}

// A needle and a point are what is left of a triangle.
TEST(TriangleMeeting, ANeedleAndAPointMeetWhatTheyTouch) {
  const TrianglePoints square_half{o, 4 * x, 4 * y};
  EXPECT_TRUE(triangles_meet(square_half, {x + y, x + y, x + y}));
  EXPECT_FALSE(triangles_meet(square_half, {3 * x + 3 * y, 3 * x + 3 * y, 3 * x + 3 * y}));
  EXPECT_TRUE(triangles_meet(square_half, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(1, 1, 3)}));
  EXPECT_FALSE(triangles_meet(square_half, {Vec3(1, 1, 1), Vec3(1, 1, 2), Vec3(1, 1, 3)}));
  EXPECT_TRUE(triangles_meet({o, x, 2 * x}, {Vec3(1, -1, 0), Vec3(1, 0, 0), Vec3(1, 1, 0)}));
  EXPECT_FALSE(triangles_meet({o, x, 2 * x}, {Vec3(3, -1, 0), Vec3(3, 0, 0), Vec3(3, 1, 0)}));
}

TEST(TriangleMeeting, ANeedleWithACommonVertexMeetsBeyondItWhereItReachesIntoTheOther) {
  const TrianglePoints t{o, 4 * x, 4 * y};
  EXPECT_TRUE(meet_beyond_vertex(t, {o, x + y, 2 * x + 2 * y}));
  EXPECT_FALSE(meet_beyond_vertex(t, {o, Vec3(-1, -1, 0), Vec3(-2, -2, 0)}));
  // The corner lies between the others.
  EXPECT_TRUE(meet_beyond_vertex(t, {o, Vec3(-1, -1, 0), x + y}));
  EXPECT_FALSE(meet_beyond_vertex(t, {o, Vec3(-1, 1, 0), Vec3(1, -1, 0)}));
  EXPECT_FALSE(meet_beyond_vertex(t, {o, o, Vec3(0, 0, 1)}));
  EXPECT_FALSE(meet_beyond_vertex(t, {o, o, o}));
  EXPECT_TRUE(meet_beyond_vertex({o, x, 2 * x}, {o, 3 * x, 5 * x}));
}

TEST(TriangleMeeting, NeighboursMeetBeyondTheirEdgeWhereOneIsFoldedFlatOntoTheOther) {
  const TrianglePoints t{o, x, y};
  EXPECT_TRUE(meet_beyond_edge(t, {o, x, x + y}));
  EXPECT_TRUE(meet_beyond_edge(t, {o, x, y}));
  EXPECT_FALSE(meet_beyond_edge(t, {o, x, -y}));
  EXPECT_FALSE(meet_beyond_edge(t, {o, x, Vec3(0, 1, 1e-30)}));
  // Flat onto the other, in a plane across all axes.
  EXPECT_TRUE(meet_beyond_edge({Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 3)},
                               {Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(1, 1, 1)}));
  EXPECT_FALSE(meet_beyond_edge({Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 3)},
                                {Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(3, 3, -3)}));
}

TEST(TriangleMeeting, NeedlesWithACommonEdgeMeetBeyondItOnOneSide) {
  EXPECT_FALSE(meet_beyond_edge({o, x, y}, {o, x, 3 * x}));
  EXPECT_TRUE(meet_beyond_edge({o, x, 2 * x}, {o, x, 3 * x}));
  EXPECT_FALSE(meet_beyond_edge({o, x, 2 * x}, {o, x, -x}));
  EXPECT_FALSE(meet_beyond_edge({o, x, 0.5 * x}, {o, x, 3 * x}));
  EXPECT_TRUE(meet_beyond_edge({o, o, x}, {o, o, 2 * x}));
  EXPECT_FALSE(meet_beyond_edge({o, o, x}, {o, o, y}));
}

}  // namespace
}  // namespace drape

#include <gtest/gtest.h>

#include "contact/fail_safe.h"
#include "core/parallel.h"
#include "scene.h"

namespace drape {
namespace {

using test::least_gap;
using test::one_triangle;
using test::Random;
using test::Scene;

constexpr double thickness = 0.01;

FailSafeResult hold(Scene& scene) { return hold_back(scene.phase(), scene.proximity(), scene.end); }

double radius_of(const Scene& scene, const test::AnyPair& pair) {
  const auto [a, b] = pair_bodies(scene.geometry, pair.kind, pair.vertices);
  return scene.geometry.bodies[a].radius + scene.geometry.bodies[b].radius;
}

// No pair comes nearer than the gap on the way, or than it was.
void expect_gaps(const Scene& scene) {
  for (const test::AnyPair& pair : test::all_pairs(scene.geometry)) {
    const FourPoints start = gather(scene.start, pair.vertices), end = gather(scene.end, pair.vertices);
    const double before = closest_points(pair.kind, start).distance;
    const double wanted = std::min(before, least_gap + radius_of(scene, pair));
    EXPECT_GE(test::least_distance(pair.kind, start, end, 8), wanted * (1 - 1e-9));
  }
}

// Whether the segment (p, q) passes through the triangle, by signs of volumes.
bool pierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto volume = [](const Vec3& o, const Vec3& u, const Vec3& v, const Vec3& w) {
    return (u - o).dot((v - o).cross(w - o));
  };
  if (volume(a, b, c, p) * volume(a, b, c, q) >= 0) return false;
  const double ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
  return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
}

int piercings(const Scene& scene, const std::vector<Vec3>& x) {
  int count = 0;
  for (const auto& [p, q] : scene.geometry.edges)
    for (const auto& [a, b, c] : scene.geometry.triangles)
      if (p != a && p != b && p != c && q != a && q != b && q != c)
        count += pierces(x[p], x[q], x[a], x[b], x[c]);
  return count;
}

// Two cloths over each other, a box between them, and a capsule and a sphere beside it: nothing touches.
Scene quiet() {
  Scene scene;
  scene.add_cloth(make_grid({0.6, 0.6}, {7, 7}), thickness);
  scene.add_cloth(test::shifted(make_grid({0.6, 0.6}, {6, 6}), {0, 0.15, 0}), thickness);
  scene.add_mesh(test::shifted(make_box({0.1, 0.05, 0.1}), {0.2, 0.08, 0.2}));
  scene.add_sphere({-0.2, 0.07, 0}, 0.03);
  scene.add_capsule({0, 0.07, -0.2}, {0.1, 0.07, -0.2}, 0.02);
  return scene;
}

void move_cloths(Scene& scene, Random& random, double way) {
  for (std::size_t v = 0; v < scene.start.size(); ++v)
    if (scene.geometry.inverse_masses[v] > 0) scene.end[v] = scene.start[v] + random.vector(way);
}

TEST(FailSafe, FastRandomMotionsWithoutAnyResponseNeverComeNearerThanTheGap) {
  for (unsigned seed = 1; seed <= 3; ++seed)
    for (const double way : {0.15, 0.4}) {
      Random random(seed);
      Scene scene = quiet();
      move_cloths(scene, random, way);
      ASSERT_GT(piercings(scene, scene.end), 10);  // it would go wrong
      const FailSafeResult result = hold(scene);
      EXPECT_GT(result.limited_vertices, 5);
      EXPECT_EQ(piercings(scene, scene.end), 0);
      expect_gaps(scene);
    }
}

TEST(FailSafe, NothingPassesThroughAnythingInManySteps) {
  Random random(4);
  Scene scene = quiet();
  for (int step = 0; step < 40; ++step) {
    move_cloths(scene, random, 0.06);
    hold(scene);
    ASSERT_EQ(piercings(scene, scene.end), 0) << "step " << step;
    scene.start = scene.end;
  }
  move_cloths(scene, random, 0.06);
  hold(scene);
  expect_gaps(scene);
}

TEST(FailSafe, CollidersThatSweepThroughTheClothsNeverComeNearerThanTheGap) {
  Random random(5);
  for (int trial = 0; trial < 4; ++trial) {
    Scene scene = quiet();
    move_cloths(scene, random, 0.03);
    for (int body = 2; body < 5; ++body) {
      const Mat3 turn =
          Eigen::AngleAxisd(random.between(-0.3, 0.3), random.vector().normalized()).toRotationMatrix();
      scene.move_body(body, {turn, Vec3(0, random.between(-0.3, 0.3), 0)});
    }
    hold(scene);
    expect_gaps(scene);
    EXPECT_EQ(piercings(scene, scene.end), 0);
  }
}

TEST(FailSafe, AStepThatNeedsNothingIsLeftToTheBit) {
  Random random(6);
  Scene scene = quiet();
  for (Vec3& x : scene.end) x += Vec3(3, 2, 1);  // all together, and a little
  for (Vec3& x : scene.end) x += random.vector(0.001);
  const std::vector<Vec3> before = scene.end;
  const FailSafeResult result = hold(scene);
  EXPECT_EQ(scene.end, before);
  EXPECT_EQ(result.limited_vertices, 0);
  EXPECT_EQ(result.passes, 1);
  for (const double share : result.vertex_progress) EXPECT_EQ(share, 1);
}

TEST(FailSafe, VerticesKeepToTheirStraightWays) {
  Random random(7);
  Scene scene = quiet();
  move_cloths(scene, random, 0.2);
  const std::vector<Vec3> aims = scene.end;
  const FailSafeResult result = hold(scene);
  for (std::size_t v = 0; v < aims.size(); ++v) {
    const double share = result.vertex_progress[v];
    EXPECT_GE(share, 0);
    EXPECT_LE(share, 1);
    EXPECT_LT((scene.end[v] - scene.start[v] - share * (aims[v] - scene.start[v])).norm(), 1e-15);
  }
}

TEST(FailSafe, APointBeforeATriangleGoesNearlyAsFarAsTheGapAllows) {
  Scene scene;
  scene.add_cloth(one_triangle({0, 0.01, 0}, {0.1, 1, 0}, {-0.1, 1, 0.1}), thickness);
  scene.add_mesh(one_triangle({-1, 0, -1}, {0, 0, 1}, {1, 0, -1}));
  for (int v = 0; v < 3; ++v) scene.end[v].y() -= 0.5;
  hold(scene);
  EXPECT_GE(scene.end[0].y(), least_gap);
  EXPECT_LT(scene.end[0].y(), 0.1 * 0.01);
}

// The ball is large beside the way: a pair's distance is that of its centre, but what counts is its surface.
TEST(FailSafe, ALargeBallIsNotEnteredByASmallWay) {
  Scene scene;
  scene.add_cloth(test::shifted(make_grid({0.1, 0.1}, {3, 3}), {0, 0.51, 0}), thickness);
  scene.add_sphere({0, 0, 0}, 0.5);
  for (int v = 0; v < 9; ++v) scene.end[v].y() -= 0.03;
  hold(scene);
  for (int v = 0; v < 9; ++v) EXPECT_GE(scene.end[v].norm(), 0.5 + 0.99 * least_gap);
  EXPECT_LT(scene.end[4].norm(), 0.5 + 0.1 * thickness);  // all but the room that is left to the ball
}

TEST(FailSafe, AColliderGoesOneShareOfItsWay) {
  Scene scene;
  scene.add_cloth(test::shifted(make_grid({0.3, 0.3}, {4, 4}), {0, 0.1, 0}), thickness);
  const int box = scene.add_mesh(make_box({0.15, 0.15, 0.15}));
  for (int v = 0; v < 16; ++v) scene.geometry.inverse_masses[v] = v == 0 ? 1 : 0;  // all but held
  scene.move_body(box, {Mat3::Identity(), Vec3(0, 0.4, 0)});
  const std::vector<Vec3> aims = scene.end;
  const FailSafeResult result = hold(scene);
  const auto [begin, end] = scene.vertices(box);
  for (int v = begin; v < end; ++v) EXPECT_EQ(result.vertex_progress[v], result.vertex_progress[begin]);
  EXPECT_EQ(result.body_progress[box], result.vertex_progress[begin]);
  EXPECT_LT(result.body_progress[box], 0.1);
  EXPECT_EQ(result.body_progress[0], 1);
  expect_gaps(scene);
}

// Thousands of vertices, some of which fall on a plane that rises, and some of which get out of its way.
TEST(FailSafe, VerticesOverAPlaneAreHeldWhereTheyMustWithAnyNumberOfThreads) {
  constexpr double height = 0.05, rise = 0.03;
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Random random(9);
    Scene scene;
    scene.add_cloth(test::shifted(make_grid({1, 1}, {60, 60}), {0, height, 0}), thickness);
    const int plane = scene.add_plane();
    for (Vec3& x : scene.end) x.y() += random.between(-0.03, 0.03);
    scene.move_body(plane, {Mat3::Identity(), Vec3(0, rise, 0)});
    const std::vector<Vec3> aims = scene.end;
    const FailSafeResult result = hold(scene);
    EXPECT_EQ(result.body_progress[plane], 1);
    EXPECT_GT(result.limited_vertices, 500);
    EXPECT_LT(result.limited_vertices, 2000);
    for (std::size_t v = 0; v < aims.size(); ++v)
      EXPECT_NEAR(scene.end[v].y(), std::max(aims[v].y(), rise + least_gap), 1e-12) << v;
    results.push_back(scene.end);
  }
  EXPECT_EQ(results[1], results[0]);
  EXPECT_EQ(results[2], results[0]);
}

TEST(FailSafe, AColliderTakesTheRoomFirst) {
  Scene scene;
  scene.add_cloth(test::shifted(make_grid({0.3, 0.3}, {4, 4}), {0, 0.2, 0}), thickness);
  const int box = scene.add_mesh(make_box({0.1, 0.1, 0.1}));  // its top is 0.15 below the cloth
  scene.move_body(box, {Mat3::Identity(), Vec3(0, 0.1, 0)});
  for (int v = 0; v < 16; ++v) scene.end[v].y() -= 0.1;
  const FailSafeResult result = hold(scene);
  EXPECT_NEAR(result.body_progress[box], 1, 1e-9);
  EXPECT_GT(result.limited_vertices, 0);
  expect_gaps(scene);
}

// They do not move towards each other, until the plane holds up the lower one.
TEST(FailSafe, LayersOfAClothThatFallTogetherStayApartWhereTheLowerOneIsHeld) {
  Scene scene;
  TriangleMesh layers = test::shifted(make_grid({0.3, 0.3}, {4, 4}), {0, 0.1, 0});
  const TriangleMesh upper = test::shifted(make_grid({0.33, 0.33}, {4, 4}), {0.01, 0.15, 0});
  layers.positions.insert(layers.positions.end(), upper.positions.begin(), upper.positions.end());
  for (const auto& [a, b, c] : upper.triangles) layers.triangles.push_back({a + 16, b + 16, c + 16});
  scene.add_cloth(layers, thickness);
  scene.add_plane();
  for (Vec3& x : scene.end) x.y() -= 1;
  hold(scene);
  expect_gaps(scene);
  EXPECT_EQ(piercings(scene, scene.end), 0);
  for (int v = 16; v < 32; ++v) EXPECT_GT(scene.end[v].y(), least_gap);
}

TEST(FailSafe, TheSameBitsWithAnyNumberOfThreads) {
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Random random(8);
    Scene scene = quiet();
    move_cloths(scene, random, 0.2);
    hold(scene);
    results.push_back(scene.end);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

// A cloth of free points at these heights, along x.
Scene over_plane(const std::vector<double>& heights) {
  Scene scene;
  TriangleMesh mesh;
  for (std::size_t i = 0; i < heights.size(); ++i)
    mesh.positions.emplace_back(static_cast<double>(i), heights[i], 0);
  scene.add_cloth(mesh, thickness);
  scene.add_plane();
  return scene;
}

TEST(FailSafePlane, AFallingVertexStopsOverIt) {
  Scene scene = over_plane({0.5, 0.5, 0.5});
  scene.end[0].y() = -1;
  scene.end[1].y() = 0.2;
  const FailSafeResult result = hold(scene);
  EXPECT_GE(scene.end[0].y(), least_gap);
  EXPECT_LT(scene.end[0].y(), 2 * least_gap);
  EXPECT_EQ(scene.end[1].y(), 0.2);
  EXPECT_EQ(result.limited_vertices, 1);
  EXPECT_EQ(result.body_progress[1], 1);
}

TEST(FailSafePlane, ARisingPlaneStopsUnderAVertexThatDoesNotGiveWay) {
  Scene scene = over_plane({0.5, 2, 2});
  scene.bodies[1].end.translation.y() = 1;
  const FailSafeResult result = hold(scene);
  EXPECT_NEAR(result.body_progress[1], 0.5 - least_gap, 1e-9);
  EXPECT_EQ(scene.end, scene.start);
}

TEST(FailSafePlane, BetweenTwoPlanesThatCloseEachStopsAtTheVertex) {
  Scene scene = over_plane({0.5, 0.4, 0.6});
  scene.add_plane();
  const Mat3 down = Eigen::AngleAxisd(std::acos(-1.0), Vec3(1, 0, 0)).toRotationMatrix();
  scene.bodies[1].end.translation.y() = 0.7;
  scene.bodies[2] = {{down, Vec3(0, 1, 0)}, {down, Vec3(0, 0.2, 0)}};
  scene.end[0].y() += 2;  // flees from the one into the other
  const FailSafeResult result = hold(scene);
  const double floor = 0.7 * result.body_progress[1], ceiling = 1 - 0.8 * result.body_progress[2];
  for (const Vec3& x : scene.end) {
    EXPECT_GE(x.y(), floor + least_gap * (1 - 1e-6));
    EXPECT_LE(x.y(), ceiling - least_gap * (1 - 1e-6));
  }
}

// A pin is not obeyed into a collider, nor a collider through what is pinned.
TEST(FailSafePlane, PinnedVerticesHoldItUpAndAreHeldOverIt) {
  Scene scene = over_plane({0.5, 2, 2});
  scene.geometry.inverse_masses[0] = 0;
  scene.bodies[1].end.translation.y() = 1;
  const FailSafeResult result = hold(scene);
  EXPECT_LT(result.body_progress[1], 0.5);
  EXPECT_GE(scene.end[0].y(), result.body_progress[1] + least_gap * (1 - 1e-6));
}

// It sinks at one side and rises at the other, where it meets a vertex that does not give way.
TEST(FailSafePlane, APlaneThatIsHeldUpAsItTiltsHoldsUpWhatSinksWithIt) {
  Scene scene = over_plane({0.02, 0.02, 0.02});
  for (int v = 0; v < 3; ++v) scene.end[v].x() = scene.start[v].x() -= 1;  // at -1, 0 and 1
  const auto tilt = [](double angle) {
    return Mat3(Eigen::AngleAxisd(angle, Vec3(0, 0, 1)).toRotationMatrix());
  };
  scene.bodies[1].end.rotation = tilt(0.04);
  scene.end[0].y() = -0.039;
  const double share = hold(scene).body_progress[1];
  EXPECT_LT(share, 0.6);
  for (const Vec3& x : scene.end) EXPECT_GT(tilt(0.04 * share).col(1).dot(x), 0);
}

}  // namespace
}  // namespace drape

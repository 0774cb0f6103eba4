#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <set>

#include "deformation/bending.h"
#include "sheets.h"

namespace drape {
namespace {

using test::equilateral_pair;
using test::Random;
using test::sheet_of;

constexpr double short_time_squared = 1e-9;

struct Bending {
  Sheet sheet;
  std::vector<double> masses, inverse_masses;
  BendingStage stage;
};

Bending bending_of(const Sheet& sheet, const std::vector<double>& masses, double duration_squared,
                   const std::vector<int>& pins = {}) {
  std::vector<double> inverse_masses = test::inverses(masses);
  for (const int v : pins) inverse_masses[v] = 0;
  const std::vector<double> durations(sheet.materials.size(), duration_squared);
  return {sheet, masses, inverse_masses,
          build_bending(sheet, test::one_patch(masses.size()), inverse_masses, duration_squared, durations)};
}

Bending bending_of(const TriangleMesh& mesh, double rigidity, double duration_squared) {
  const Sheet sheet = sheet_of(mesh, {.bend_stiffness = {rigidity, rigidity}});
  return bending_of(sheet, std::vector<double>(mesh.positions.size(), 1), duration_squared);
}

// What one sweep does to points at `x`.
std::vector<Vec3> displacements(const Bending& bending, const std::vector<Vec3>& x) {
  std::vector<LaneRow> base;
  load_bending(bending.stage, test::split_of(x), base);
  std::vector<Point4> offsets = test::points_of(test::zeros(x.size()), bending.inverse_masses);
  pull_bending(bending.stage, base, offsets);
  return test::vectors_of(offsets, x.size());
}

std::vector<Vec3> pulled(const Bending& bending, std::vector<Vec3> x, int times = 1) {
  for (int i = 0; i < times; ++i) x = test::sum_of(x, displacements(bending, x));
  return x;
}

TEST(BendingCorners, AreATrianglesOwnAndThoseAcrossItsEdges) {
  // Figure 2 of the paper: a triangle (0, 1, 2) and the corners 3, 4, 5 across its edges.
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, -2, 0}, {3, 2, 0}, {-1, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}};
  const Sheet sheet = sheet_of(mesh);
  EXPECT_EQ(bending_corners(sheet, 0), (std::array{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(bending_corners(sheet, 1), (std::array{1, 0, 3, 2, -1, -1}));
}

TEST(BendingCorners, InsideAGridAllSixAreThereAndTouchTheTriangle) {
  const Sheet sheet = sheet_of(make_grid({1, 1}, {7, 7}));
  int whole = 0;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    const std::array<int, 6> corners = bending_corners(sheet, t);
    const std::set<int> distinct(corners.begin(), corners.end());
    if (distinct.count(-1) > 0) continue;
    EXPECT_EQ(distinct.size(), 6u);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(corners[3 + k], opposite_vertex(sheet.topology, sheet.triangles, t, k));
    ++whole;
  }
  EXPECT_EQ(whole, 2 * 36 - 22);
}

TEST(BendingCorners, ThoseThatCoincideCountOnce) {
  const Sheet sheet = sheet_of(test::tetrahedron());
  EXPECT_EQ(bending_corners(sheet, 0), (std::array{0, 1, 2, 3, -1, -1}));
}

TEST(Bending, AnAffineImageOfAFlatSheetIsNotPulled) {
  Random random(1);
  const std::vector<Vec3> bump = test::shaken(test::zeros(64), 0.01, random);
  for (const TriangleMesh& mesh : {test::jittered_grid(8), test::alternating_grid({0.7, 0.7}, {8, 8})}) {
    const Bending bending = bending_of(mesh, 1e3, 1e-2);
    const std::vector<Vec3> x = test::moved(mesh.positions, random.matrix(), random.vector());
    EXPECT_LT(test::longest(displacements(bending, x)), 1e-6);
    EXPECT_GT(test::longest(displacements(bending, test::sum_of(x, bump))), 1e-3);
  }
}

TEST(Bending, APullGrowsWithTheFirstPowerOfTheAngle) {
  const Bending bending = bending_of(equilateral_pair(0.1, 0), 1e-3, 1e-4);
  const auto pull = [&](double angle) {
    return test::longest(displacements(bending, equilateral_pair(0.1, angle).positions));
  };
  for (const double angle : {1e-4, 1e-2, 0.2}) EXPECT_NEAR(pull(angle) / pull(angle / 2), 2, 0.005) << angle;
  EXPECT_NEAR(pull(1.0) / pull(1e-2), 2 * std::sin(0.5) / 1e-2, 0.5);
}

// The energy is a quadratic form of the points, so half of x . dE/dx; and a short step moves a point by -h2 w
// dE/dx.
double energy(const Bending& bending, const std::vector<Vec3>& x) {
  const std::vector<Vec3> d = displacements(bending, x);
  double sum = 0;
  for (std::size_t v = 0; v < x.size(); ++v)
    sum -= 0.5 * bending.masses[v] / short_time_squared * x[v].dot(d[v]);
  return sum;
}

// Triangles at the boundary bend more softly, as their corners miss: they get a material that does not bend
// at all.
Sheet sheet_that_bends_inside(const TriangleMesh& mesh, const ElasticMaterial& material, const Vec3& warp,
                              double& area) {
  Sheet sheet = sheet_of(mesh, material, warp);
  sheet.materials.push_back({.bend_stiffness = {0, 0}});
  sheet.warp_directions.push_back(warp);
  area = 0;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    const std::array<int, 6> corners = bending_corners(sheet, t);
    const bool inside = std::find(corners.begin(), corners.end(), -1) == corners.end();
    sheet.triangle_materials[t] = inside ? 0 : 1;
    if (inside) area += rest_area(sheet, t);
  }
  return sheet;
}

// The energy per area of a sheet whose heights over the plane y = 0 are those of a curved surface.
template <typename Surface>
double energy_per_area(const TriangleMesh& mesh, const ElasticMaterial& material, const Vec3& warp,
                       const Surface& surface) {
  double area = 0;
  const Sheet sheet = sheet_that_bends_inside(mesh, material, warp, area);
  const Bending bending =
      bending_of(sheet, std::vector<double>(mesh.positions.size(), 1), short_time_squared);
  std::vector<Vec3> x;
  for (const Vec3& p : mesh.positions) x.push_back(surface(p));
  return energy(bending, x) / area;
}

// Rolls the plane y = 0 up round an axis in it: an isometry, so that nothing but bending stores energy.
auto cylinder(double curvature, const Vec3& round) {
  const Vec3 along = round.normalized(), across = along.cross(Vec3(0, 1, 0));
  return [=](const Vec3& p) -> Vec3 {
    const double angle = curvature * across.dot(p);
    return along.dot(p) * along +
           (std::sin(angle) * across + (1 - std::cos(angle)) * Vec3(0, 1, 0)) / curvature;
  };
}

std::vector<TriangleMesh> bent_meshes() {
  return {make_grid({1.1, 1.1}, {12, 12}), make_grid({2, 0.6}, {12, 12}),
          test::alternating_grid({1.1, 1.1}, {12, 12}), test::jittered_grid(12, 3),
          test::jittered_grid(12, 4)};
}

TEST(Bending, ACylinderRoundAnyAxisStoresHalfTheRigidityTimesItsCurvatureSquared) {
  constexpr double rigidity = 3e-4, curvature = 0.3;
  for (const TriangleMesh& mesh : bent_meshes())
    for (const double angle : {0.0, 0.5, 1.1, std::numbers::pi / 2, 2.3}) {
      const ElasticMaterial material{.bend_stiffness = {rigidity, rigidity}};
      const double stored = energy_per_area(mesh, material, Vec3(1, 0, 0),
                                            cylinder(curvature, Vec3(std::cos(angle), 0, std::sin(angle))));
      EXPECT_NEAR(stored / (0.5 * rigidity * curvature * curvature), 1, 0.01) << "angle " << angle;
    }
}

TEST(Bending, WarpAndWeftHaveRigiditiesOfTheirOwn) {
  constexpr double curvature = 0.3;
  const ElasticMaterial material{.bend_stiffness = {4e-4, 2e-4}};
  const Vec3 warp = Vec3(1, 0, 0.7).normalized(), weft = Vec3(0.7, 0, -1).normalized();
  for (const TriangleMesh& mesh : bent_meshes()) {
    const double per_rigidity = 0.5 * curvature * curvature;
    EXPECT_NEAR(energy_per_area(mesh, material, warp, cylinder(curvature, weft)) / (4e-4 * per_rigidity), 1,
                0.01);
    EXPECT_NEAR(energy_per_area(mesh, material, warp, cylinder(curvature, warp)) / (2e-4 * per_rigidity), 1,
                0.01);
  }
}

TEST(Bending, AMuchStifferWarpKeepsItsRigidity) {
  constexpr double curvature = 0.3;
  const ElasticMaterial material{.bend_stiffness = {1e-3, 1e-4}};
  for (const TriangleMesh& mesh : bent_meshes())
    EXPECT_NEAR(energy_per_area(mesh, material, Vec3(1, 0, 0), cylinder(curvature, Vec3(0, 0, 1))) /
                    (0.5 * 1e-3 * curvature * curvature),
                1, 0.03);
}

// Twist t at right angles: w = t x z, and 1/2 D33 (2 t)2 with D33 = B / (2 (1 + nu)).
TEST(Bending, ATwistStoresWhatAnIsotropicPlateDoes) {
  constexpr double rigidity = 3e-4, twist = 0.05;
  for (const TriangleMesh& mesh : bent_meshes()) {
    const double stored =
        energy_per_area(mesh, {.poisson_ratio = 0.25, .bend_stiffness = {rigidity, rigidity}}, Vec3(1, 0, 0),
                        [](const Vec3& p) { return Vec3(p.x(), twist * p.x() * p.z(), p.z()); });
    EXPECT_NEAR(stored / (rigidity * twist * twist / 1.25), 1, 0.01);
  }
}

// Uniform curvature from a clamp on: the moment is the same along the sheet, up to the clamp, and needs no
// force but at the free end. With a softer clamp there would be one in the first row, and in the second.
TEST(Bending, ASheetBentUniformlyFromItsClampIsInBalance) {
  constexpr double rigidity = 3e-4, curvature = 0.3;
  const int columns = 11;
  const TriangleMesh mesh =
      make_grid({1, 1.2}, {columns, 13});  // the clamp: rows 0 to 6, of which row 6 is at z = 0
  std::vector<int> pins(7 * columns);
  std::iota(pins.begin(), pins.end(), 0);
  const Sheet sheet = sheet_of(mesh, {.bend_stiffness = {rigidity, rigidity}});
  const std::vector<double> masses(mesh.positions.size(), 1);
  std::vector<Vec3> x = mesh.positions;
  for (Vec3& p : x)
    if (p.z() > 0) p = cylinder(curvature, Vec3(1, 0, 0))(p);
  const std::vector<Vec3> d = displacements(bending_of(sheet, masses, short_time_squared, pins), x);
  const double force =
      rigidity * curvature;  // of a moment that ends in one row, B k width / edge with width = edge
  for (int row = 7; row < 11; ++row)
    EXPECT_LT(d[row * columns + 5].norm() / short_time_squared, 0.02 * force) << "row " << row;
}

TEST(Bending, AClusterKeepsBothMomenta) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Sheet sheet = sheet_of(equilateral_pair(1, 0), {.bend_stiffness = {1e3, 1e3}});
    const Bending bending = bending_of(sheet, test::random_masses(4, random), 1e-2);
    const std::vector<Vec3> before = test::shaken(sheet.rest_positions, 0.5, random);
    const std::vector<Vec3> after = pulled(bending, before);
    ASSERT_GT(test::farthest(before, after), 1e-3);
    EXPECT_LT(test::relative_momentum(bending.masses, before, after), 2e-6);
    EXPECT_LT(test::relative_angular_momentum(bending.masses, before, after), 2e-6);
  }
}

// A closed mesh's lone cluster: one triangle of a tetrahedron, its only outer corner the fourth point.
TEST(Bending, ACurvedClusterKeepsBothMomentaWhereverItsPointsAre) {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    Sheet sheet = sheet_of(test::tetrahedron(), {.bend_stiffness = {1e3, 1e3}});
    sheet.materials.push_back({.bend_stiffness = {0, 0}});
    sheet.warp_directions.push_back({1, 0, 0});
    sheet.triangle_materials = {0, 1, 1, 1};
    const Bending bending = bending_of(sheet, test::random_masses(4, random), 1e-2);
    const std::vector<Vec3> before = test::shaken(sheet.rest_positions, 0.4, random);
    const std::vector<Vec3> after = pulled(bending, before);
    ASSERT_GT(test::farthest(before, after), 1e-3);
    EXPECT_LT(test::relative_momentum(bending.masses, before, after), 3e-6);
    EXPECT_LT(test::relative_angular_momentum(bending.masses, before, after), 3e-6);
  }
}

TEST(Bending, ASheetKeepsLinearMomentum) {
  Random random(4);
  for (const TriangleMesh& mesh : {test::jittered_grid(10), make_sphere(0.5, 14, 9)}) {
    const Sheet sheet = sheet_of(mesh, {.bend_stiffness = {1, 1}});
    const Bending bending = bending_of(sheet, test::random_masses(mesh.positions.size(), random), 1e-4);
    const std::vector<Vec3> x = test::shaken(mesh.positions, 0.03, random);
    EXPECT_LT(test::relative_momentum(bending.masses, x, pulled(bending, x)), 2e-6);
  }
}

TEST(Bending, NoPullLeadsAwayFromTheFlatShape) {
  Random random(5);
  const Sheet sheet = sheet_of(test::jittered_grid(10), {.bend_stiffness = {0.1, 0.05}});
  const Bending bending = bending_of(sheet, lumped_masses(sheet), 1e-5);
  const auto distance = [&](const std::vector<Vec3>& x) {
    double sum = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
      sum += bending.masses[v] * (x[v] - sheet.rest_positions[v]).squaredNorm();
    return sum;
  };
  std::vector<Vec3> x = test::shaken(sheet.rest_positions, 0.05, random);
  for (int sweep = 0; sweep < 50; ++sweep) {
    const double before = distance(x);
    x = pulled(bending, x);
    ASSERT_LE(distance(x), before * (1 + 1e-6));
  }
}

TEST(Bending, CurvedRestShapesStayWhereverTheyAreMoved) {
  Random random(6);
  TriangleMesh rolled = make_grid({1, 1}, {11, 11});
  for (Vec3& x : rolled.positions) x = cylinder(3, Vec3(1, 0, 0.3))(x);
  for (const TriangleMesh& mesh :
       {make_sphere(0.3, 14, 9), rolled, make_box({1, 1, 1}), test::tetrahedron()}) {
    const Bending bending = bending_of(mesh, 1, 1);
    ASSERT_TRUE(bending.stage.curved);
    const std::vector<Vec3> x = test::moved(mesh.positions, random.rotation(), random.vector());
    EXPECT_LT(test::longest(displacements(bending, x)), 3e-6);
  }
}

TEST(Bending, MeshesOfFewTrianglesAreFiniteAndAtRest) {
  Random random(7);
  const TriangleMesh lone = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}};
  for (const TriangleMesh& mesh :
       {lone, equilateral_pair(1, 0), equilateral_pair(1, 1), test::fan(3), test::fan(9), test::tetrahedron(),
        make_box({1, 1, 1}), make_grid({1, 1}, {2, 2})}) {
    const Bending bending = bending_of(mesh, 10, 1e-2);
    EXPECT_LT(test::longest(displacements(bending, mesh.positions)), 3e-6);
    EXPECT_TRUE(test::all_finite(pulled(bending, test::shaken(mesh.positions, 0.5, random), 50)));
    EXPECT_TRUE(test::all_finite(pulled(bending, test::zeros(mesh.positions.size()), 5)));
  }
}

TEST(Bending, PinnedPointsStay) {
  const Sheet sheet = sheet_of(equilateral_pair(1, 0), {.bend_stiffness = {1e3, 1e3}});
  const std::vector<Vec3> x = equilateral_pair(1, 1).positions;
  const std::vector<Vec3> d = displacements(bending_of(sheet, {1, 1, 1, 1}, 1e-2, {0, 3}), x);
  EXPECT_EQ(d[0], Vec3(0, 0, 0));
  EXPECT_EQ(d[3], Vec3(0, 0, 0));
  EXPECT_GT(d[2].norm(), 1e-3);
  EXPECT_EQ(test::longest(displacements(bending_of(sheet, {1, 1, 1, 1}, 1e-2, {0, 1, 2, 3}), x)), 0);
}

TEST(Bending, WithoutRigidityThereIsNothingToPull) {
  EXPECT_EQ(bending_of(test::jittered_grid(5), 0, 1).stage.order.row_count(), 0u);
}

BendingStage damping_stage(const Sheet& sheet, const std::vector<double>& masses, double duration_squared) {
  return build_bending(sheet, test::one_patch(masses.size()), test::inverses(masses), 1, {duration_squared});
}

std::vector<Vec3> damped(const BendingStage& stage, const std::vector<double>& masses,
                         const std::vector<Vec3>& v) {
  std::vector<Point4> points = test::points_of(v, test::inverses(masses));
  damp_bending(stage, points);
  return test::vectors_of(points, v.size());
}

TEST(BendingDamping, LeavesAffineMotionOfAFlatSheet) {
  Random random(8);
  const Sheet sheet = sheet_of(test::jittered_grid(8), {.bend_stiffness = {1, 1}});
  const std::vector<double> masses = lumped_masses(sheet);
  const std::vector<Vec3> rates = test::moved(sheet.rest_positions, random.matrix(), random.vector());
  EXPECT_LT(test::farthest(damped(damping_stage(sheet, masses, 1), masses, rates), rates), 2e-5);
}

TEST(BendingDamping, KeepsLinearMomentumAndTakesKineticEnergy) {
  Random random(10);
  const Sheet sheet = sheet_of(test::jittered_grid(8), {.bend_stiffness = {1, 1}});
  const std::vector<double> masses = lumped_masses(sheet);
  const std::vector<Vec3> before = test::shaken(std::vector<Vec3>(64, Vec3(1, 2, 3)), 1, random);
  const std::vector<Vec3> after = damped(damping_stage(sheet, masses, 1e-2), masses, before);
  EXPECT_LT(test::relative_momentum(masses, before, after), 1e-6);
  const auto kinetic = [&](const std::vector<Vec3>& v) {
    double sum = 0;
    for (std::size_t i = 0; i < 64; ++i) sum += masses[i] * v[i].squaredNorm();
    return sum;
  };
  EXPECT_LT(kinetic(after), 0.99 * kinetic(before));
}

}  // namespace
}  // namespace drape

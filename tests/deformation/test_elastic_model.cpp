#include <gtest/gtest.h>

#include <numeric>

#include "core/parallel.h"
#include "deformation/elastic_model.h"
#include "deformation/momentum.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using test::sheet_of;

constexpr double step = 1.0 / 240;

TEST(Sheet, PointsShareTheMassOfTheirTriangles) {
  const Sheet sheet = sheet_of(make_grid({2, 3}, {9, 7}), {.density = 0.3});
  const std::vector<double> masses = lumped_masses(sheet);
  EXPECT_NEAR(std::accumulate(masses.begin(), masses.end(), 0.0), 0.3 * 6, 1e-13);
  EXPECT_NEAR(masses[4 * 9 + 4], 0.3 * 0.25 * 0.5, 1e-15);  // inside: one cell
  EXPECT_NEAR(masses[1], masses[4 * 9 + 4] / 2, 1e-15);     // on an edge: half of one
}

TEST(Sheet, MassFollowsTheMaterialOfEachTriangle) {
  Sheet sheet = sheet_of(test::equilateral_pair(1, 0));
  sheet.materials = {{.density = 1}, {.density = 10}};
  sheet.triangle_materials = {0, 1};
  const std::vector<double> masses = lumped_masses(sheet);
  EXPECT_NEAR(masses[3] / masses[2], 10, 1e-13);
  EXPECT_NEAR(masses[0] / masses[2], 11, 1e-13);
  EXPECT_NEAR(rest_area(sheet, 0), std::sqrt(3) / 4, 1e-15);
}

TEST(Sheet, TheWarpLiesInTheTrianglesPlane) {
  const TriangleMesh mesh = test::equilateral_pair(1, 0.4);
  const Sheet sheet = sheet_of(mesh, {}, Vec3(1, 2, 3));
  for (int t : {0, 1}) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Vec3& x = mesh.positions[a];
    const Vec3 normal = (mesh.positions[b] - x).cross(mesh.positions[c] - x).normalized();
    const Vec3 warp = warp_in_plane(sheet, t);
    EXPECT_NEAR(warp.norm(), 1, 1e-14);
    EXPECT_NEAR(warp.dot(normal), 0, 1e-14);
    EXPECT_NEAR(Vec3(1, 2, 3).dot(normal.cross(warp)), 0,
                1e-14);  // what is left of the direction is along the normal
    EXPECT_GT(warp.dot(Vec3(1, 2, 3)), 0);
  }
  const Vec3 along_edge = warp_in_plane(sheet_of(mesh, {}, Vec3(0, 5, 0)), 0);
  EXPECT_NEAR(along_edge.cross(mesh.positions[2] - mesh.positions[0]).norm(), 0, 1e-14);
}

// A sheet on its way, with accelerations of its own.
struct Motion {
  std::vector<double> masses;
  ElasticModel model;
  std::vector<Vec3> x, v, a;
  int parts;  // of a test's step
  ElasticScratch scratch;
};

Motion motion_of(const Sheet& sheet, const std::vector<int>& pins = {}, int parts = 1,
                 double gravity = 9.81) {
  std::vector<char> pinned(sheet.rest_positions.size(), 0);
  for (const int v : pins) pinned[v] = 1;
  const std::vector<double> masses = lumped_masses(sheet);
  const std::vector<Vec3> zeros = test::zeros(masses.size());
  return {masses,
          build_elastic_model(sheet, masses, pinned, gravity, step / parts),
          sheet.rest_positions,
          zeros,
          zeros,
          parts,
          {}};
}

void advance(Motion& motion, int steps = 1) {
  for (int i = 0; i < steps * motion.parts; ++i) {
    const std::vector<Vec3> start = motion.x;
    advance_elastic(motion.model, motion.a, start, motion.scratch, motion.x, motion.v);
  }
}

double kinetic_energy(const Motion& motion) {
  double sum = 0;
  for (std::size_t i = 0; i < motion.x.size(); ++i) sum += 0.5 * motion.masses[i] * motion.v[i].squaredNorm();
  return sum;
}

ElasticMaterial stiff(double stretch, double bend) {
  ElasticMaterial material;
  material.stretch_stiffness = {stretch, stretch};
  material.bend_stiffness = {bend, bend};
  return material;
}

double steps_a_second(double size, const ElasticMaterial& material) {
  return 1 / longest_elastic_step(sheet_of(make_grid({size, size}, {11, 11}), material));
}

TEST(LongestElasticStep, OfStretchFallsWithTheRootOfStiffnessAndWithFineness) {
  const double some = steps_a_second(0.1, stiff(4e4, 1e-12));
  ASSERT_GT(some, 100);
  EXPECT_NEAR(steps_a_second(0.05, stiff(4e4, 1e-12)) / some, 2, 0.02);
  EXPECT_NEAR(steps_a_second(0.1, stiff(16e4, 1e-12)) / some, 2, 0.02);
  ElasticMaterial weft = stiff(4e4, 1e-12);
  weft.stretch_stiffness[1] = 16e4;
  EXPECT_NEAR(steps_a_second(0.1, weft) / some, 2, 0.02);
  weft.density *= 4;
  EXPECT_NEAR(steps_a_second(0.1, weft) / some, 1, 0.02);
}

TEST(LongestElasticStep, OfBendingFallsWithTheRootOfRigidityAndWithTheSquareOfFineness) {
  const double some = steps_a_second(0.1, stiff(1e-3, 1e-2));
  ASSERT_GT(some, 100);
  EXPECT_NEAR(steps_a_second(0.05, stiff(1e-3, 1e-2)) / some, 4, 0.04);
  EXPECT_NEAR(steps_a_second(0.1, stiff(1e-3, 4e-2)) / some, 2, 0.02);
}

TEST(LongestElasticStep, IsThatOfTheStiffestMaterial) {
  Sheet sheet = sheet_of(make_grid({0.1, 0.1}, {11, 11}), stiff(1, 1e-9));
  const double soft = longest_elastic_step(sheet);
  sheet.materials.push_back(stiff(1e6, 1e-9));
  sheet.warp_directions.push_back({1, 0, 0});
  sheet.triangle_materials.back() = 1;
  EXPECT_LT(longest_elastic_step(sheet), 0.5 * soft);
}

TEST(ElasticModel, TheSameBitsWithAnyNumberOfThreads) {
  Random random(1);
  const Sheet sheet = sheet_of(test::jittered_grid(60));
  const std::vector<Vec3> start = test::shaken(sheet.rest_positions, 0.01, random);
  std::vector<std::vector<Vec3>> results;
  for (const int threads : {1, 2, 4}) {
    const ThreadLimit limit(threads);
    Motion motion = motion_of(sheet, {0, 59}, 2);
    motion.x = start;
    advance(motion, 3);
    results.push_back(motion.x);
    results.back().insert(results.back().end(), motion.v.begin(), motion.v.end());
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
  EXPECT_TRUE(test::all_finite(results[0]));
}

TEST(ElasticModel, PiecesThatAreNotConnectedDoNotInfluenceEachOther) {
  Random random(2);
  TriangleMesh mesh = test::jittered_grid(8);
  const TriangleMesh other = test::jittered_grid(7, 9);
  for (const Vec3& x : other.positions) mesh.positions.push_back(x + Vec3(0.2, 0, 0.1));
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + 64, b + 64, c + 64});
  const Sheet sheet = sheet_of(mesh);
  Motion calm = motion_of(sheet, {0}, 2);
  for (Vec3& x : calm.x) x += random.vector(0.01);
  Motion wild = calm;
  for (std::size_t i = 64; i < mesh.positions.size(); ++i) wild.x[i] += random.vector(0.1);
  advance(calm, 20);
  advance(wild, 20);
  for (std::size_t i = 0; i < 64; ++i) {
    ASSERT_EQ(calm.x[i], wild.x[i]);
    ASSERT_EQ(calm.v[i], wild.v[i]);
  }
  EXPECT_NE(calm.x[70], wild.x[70]);
}

TEST(ElasticModel, AClothAtRestStaysWhereverItIsMoved) {
  Random random(3);
  for (const TriangleMesh& mesh : {test::jittered_grid(9), make_sphere(0.4, 12, 9), test::tetrahedron()}) {
    Motion motion = motion_of(sheet_of(mesh), {}, 3);
    motion.x = test::moved(mesh.positions, random.rotation(), random.vector());
    const std::vector<Vec3> start = motion.x;
    advance(motion, 20);
    EXPECT_LT(test::farthest(start, motion.x), 1e-5);
  }
}

TEST(ElasticModel, AFreeClothFallsAsAPoint) {
  Motion motion = motion_of(sheet_of(test::jittered_grid(9)), {}, 2);
  const std::vector<Vec3> start = motion.x;
  motion.a.assign(motion.x.size(), Vec3(0, -9.81, 0));
  advance(motion, 240);
  const double part = step / 2;
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(motion.v[i].y(), -9.81, 1e-3);
    EXPECT_NEAR(motion.x[i].y() - start[i].y(), -0.5 * 9.81 * (1 + part), 1e-3);
  }
}

TEST(ElasticModel, AStepKeepsLinearMomentum) {
  Random random(4);
  for (const TriangleMesh& mesh : {test::jittered_grid(12), make_sphere(0.4, 12, 9)}) {
    Motion motion = motion_of(sheet_of(mesh), {}, 2);
    motion.x = test::shaken(motion.x, 0.02, random);
    const std::vector<Vec3> start = motion.x;
    advance(motion);
    ASSERT_GT(test::farthest(start, motion.x), 1e-3);
    EXPECT_LT(test::relative_momentum(motion.masses, start, motion.x), 2e-6);
  }
}

TEST(ElasticModel, PinnedPointsGoWhereTheyAreTakenAndHoldTheirNeighbours) {
  Random random(5);
  const Sheet sheet = sheet_of(make_grid({1, 1}, {11, 11}));
  Motion motion = motion_of(sheet, {0, 10});
  EXPECT_EQ(motion.model.inverse_masses[0].w, 0);
  EXPECT_NEAR(motion.model.inverse_masses[5].w * motion.masses[5], 1, 1e-6);
  const std::vector<Vec3> start = motion.x;
  const Vec3 way(0.002, 0, 0.001);
  for (const int pin : {0, 10}) motion.x[pin] += way;
  advance_elastic(motion.model, motion.a, start, motion.scratch, motion.x, motion.v);
  for (const int pin : {0, 10}) {
    EXPECT_EQ(motion.x[pin], start[pin] + way);
    EXPECT_LT((motion.v[pin] - way / step).norm(), 1e-9);
  }
  EXPECT_GT((motion.x[1] - start[1]).norm(), 1e-4);
}

// The energy of motion of a shaken free sheet never exceeds what it began with, and falls.
TEST(ElasticModel, AFreeSheetGainsNoEnergy) {
  for (const TriangleMesh& mesh :
       {make_grid({1, 1}, {9, 9}), test::jittered_grid(9), make_sphere(0.3, 12, 9)})
    for (const int parts : {1, 4}) {
      Random random(6);
      Motion motion = motion_of(sheet_of(mesh), {}, parts);
      motion.v = test::shaken(motion.v, 0.5, random);
      const double most = kinetic_energy(motion);
      for (int n = 0; n < 480; ++n) {
        advance(motion);
        ASSERT_LE(kinetic_energy(motion), most) << "step " << n;
      }
      EXPECT_LT(kinetic_energy(motion), 0.5 * most);
    }
}

Vec3 angular_momentum(const Motion& motion) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < motion.x.size(); ++i) sum += motion.masses[i] * motion.x[i].cross(motion.v[i]);
  return sum;
}

TEST(ElasticModel, WithRestoredMomentaASpinningSheetKeepsItsAngularMomentum) {
  Random random(7);
  const Sheet sheet = sheet_of(make_grid({1, 1}, {9, 9}));
  Motion motion = motion_of(sheet);
  FreePiece piece;
  piece.vertices.resize(81);
  std::iota(piece.vertices.begin(), piece.vertices.end(), 0);
  for (std::size_t i = 0; i < 81; ++i)
    motion.v[i] = Vec3(0.3, 1, 0.2).cross(motion.x[i]) + random.vector(0.3);
  const Vec3 at_first = angular_momentum(motion);
  for (int n = 0; n < 480; ++n) {
    const std::vector<Vec3> start = motion.x, velocities = motion.v;
    advance(motion);
    restore_momenta(piece, motion.masses, start, velocities, motion.a, step, motion.x, motion.v);
  }
  EXPECT_LT((angular_momentum(motion) - at_first).norm(), 0.01 * at_first.norm());
}

double volume(const TriangleMesh& mesh, const std::vector<Vec3>& x) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) sum += x[a].dot(x[b].cross(x[c])) / 6;
  return sum;
}

// The largest change of any distance between two points.
double misshape(const std::vector<Vec3>& rest, const std::vector<Vec3>& x) {
  double largest = 0;
  for (std::size_t a = 0; a < x.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      largest = std::max(largest, std::abs((x[a] - x[b]).norm() - (rest[a] - rest[b]).norm()));
  return largest;
}

TEST(ElasticModel, ACurvedShapeReturnsAfterAPushEvenInsideOut) {
  Random random(8);
  const TriangleMesh sphere = make_sphere(0.1, 16, 11);
  TriangleMesh shell = make_grid({0.2, 0.3}, {9, 13});
  for (Vec3& x : shell.positions) x = Vec3(0.1 * std::sin(x.x() / 0.1), 0.1 * std::cos(x.x() / 0.1), x.z());
  for (const TriangleMesh& mesh : {sphere, shell})
    for (const double dent : {0.005, 0.03}) {
      Motion motion = motion_of(sheet_of(mesh, stiff(2000, 2e-3)), {}, 4);
      motion.x = test::shaken(motion.x, 0.002, random);
      const std::size_t pushed = mesh.positions.size() / 2;
      motion.x[pushed] -= dent * motion.x[pushed].normalized();
      ASSERT_GT(misshape(mesh.positions, motion.x), 0.3 * dent);
      advance(motion, 480);
      EXPECT_LT(misshape(mesh.positions, motion.x), 5e-4) << mesh.positions.size() << " " << dent;
      EXPECT_GT(volume(mesh, motion.x) * volume(mesh, mesh.positions), 0);
    }
}

struct StripMesh {
  TriangleMesh mesh;
  std::vector<int> pinned, pulled;  // the rows at its ends
};

// A strip of 0.1 m x 0.3 m along z, with `cells` across; its points inside shaken where `irregular`.
StripMesh strip(int cells, bool irregular) {
  const int columns = cells + 1, rows = 3 * cells + 1;
  StripMesh result{make_grid({0.1, 0.3}, {columns, rows}), {}, {}};
  Random random(9);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int v = row * columns + column;
      if (row == 0) result.pinned.push_back(v);
      if (row == rows - 1) result.pulled.push_back(v);
      const bool inside = row > 0 && row < rows - 1 && column > 0 && column < columns - 1;
      const double shift = inside && irregular ? 0.25 * 0.1 / cells : 0;
      result.mesh.positions[v] += shift * Vec3(random.between(-1, 1), 0, random.between(-1, 1));
    }
  return result;
}

// Strain of the strip where `force` pulls at its end, shared out among the points there as its width is.
double strain_under(const StripMesh& strip, const Sheet& sheet, double force, int parts) {
  Motion motion = motion_of(sheet, strip.pinned, parts, 1e4);  // weight enough that no tether holds
  const auto cells = static_cast<double>(strip.pulled.size() - 1);
  for (const int v : strip.pulled) {
    const bool corner = v == strip.pulled.front() || v == strip.pulled.back();
    motion.a[v] = Vec3(0, 0, (corner ? 0.5 : 1) * force / cells / motion.masses[v]);
  }
  advance(motion, 960);
  double way = 0;
  for (const int v : strip.pulled) way += motion.x[v].z() - sheet.rest_positions[v].z();
  return way / static_cast<double>(strip.pulled.size()) / 0.3;
}

ElasticMaterial strip_material() {
  ElasticMaterial material;
  material.stretch_stiffness = {800, 1500};
  material.shear_stiffness = 300;
  return material;
}

// The strain over what the material says, in so many times the steps that it wants.
double relative_strain(int cells, bool irregular, int along, int times) {
  const StripMesh mesh = strip(cells, irregular);
  const Sheet sheet = sheet_of(mesh.mesh, strip_material(), along == 0 ? Vec3(0, 0, 1) : Vec3(1, 0, 0));
  constexpr double force = 1, width = 0.1;
  const int parts = times * static_cast<int>(std::ceil(step / longest_elastic_step(sheet)));
  return strain_under(mesh, sheet, force, parts) * width * strip_material().stretch_stiffness[along] / force;
}

TEST(ElasticModel, InFineSubstepsAPulledStripStretchesByTheForceOverStiffnessAndWidth) {
  for (const int cells : {3, 6})
    for (const bool irregular : {false, true})
      for (const int along : {0, 1})
        EXPECT_NEAR(relative_strain(cells, irregular, along, 16), 1, 0.02)
            << cells << (irregular ? " irregular " : " regular ") << along;
}

// One sweep a substep lets a strip give more than it should; that grows with the square of the substep.
TEST(ElasticModel, WhatAPulledStripGivesTooMuchGrowsWithTheSquareOfTheSubstep) {
  for (const bool irregular : {false, true}) {
    const double coarse = relative_strain(4, irregular, 1, 8) - 1,
                 fine = relative_strain(4, irregular, 1, 16) - 1;
    EXPECT_GT(fine, 0);
    EXPECT_NEAR(coarse / fine, 4.3, 0.7);
  }
}

TEST(ElasticModel, AFoldReturnsToItsAngleEvenFromInsideOut) {
  const TriangleMesh rest = test::equilateral_pair(0.1, 0.8);
  for (const double angle : {1.2, 0.3, 0.01, -0.3}) {
    Motion motion = motion_of(sheet_of(rest, stiff(2000, 0.1)), {}, 4);
    motion.x = test::equilateral_pair(0.1, angle).positions;
    advance(motion, 480);
    EXPECT_LT(misshape(rest.positions, motion.x), 5e-4) << angle;
    EXPECT_GT((motion.x[1] - motion.x[0]).cross(motion.x[2] - motion.x[0]).dot(motion.x[3] - motion.x[0]) *
                  (rest.positions[1]).cross(rest.positions[2]).dot(rest.positions[3]),
              0);
  }
}

}  // namespace
}  // namespace drape

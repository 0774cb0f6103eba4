#include <gtest/gtest.h>

#include "deformation/membrane.h"
#include "deformation/membrane_material.h"
#include "deformation/triangle_match.h"
#include "sheets.h"

namespace drape {
namespace {

using test::Random;
using test::sheet_of;

struct Membrane {
  Sheet sheet;
  std::vector<double> masses, inverse_masses;
  MembraneStage stage;
};

Membrane membrane_of(const Sheet& sheet, const std::vector<double>& masses, double duration_squared,
                     const std::vector<int>& pins = {}) {
  std::vector<Mat3> tensors;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t)
    tensors.push_back(membrane_tensor(material_of(sheet, t), rest_frame(sheet, t, masses).warp));
  std::vector<double> inverse_masses = test::inverses(masses);
  for (const int v : pins) inverse_masses[v] = 0;
  const std::vector<int> patches = test::one_patch(masses.size());
  return {sheet, masses, inverse_masses,
          build_membrane(sheet, patches, masses, inverse_masses, {tensors, duration_squared},
                         {tensors, duration_squared})};
}

// What one sweep does to points at `x`.
std::vector<Vec3> displacements(const Membrane& membrane, const std::vector<Vec3>& x) {
  std::vector<LaneRow> base;
  load_membrane(membrane.stage, test::split_of(x), base);
  std::vector<Point4> offsets = test::points_of(test::zeros(x.size()), membrane.inverse_masses);
  pull_membrane(membrane.stage, base, offsets);
  return test::vectors_of(offsets, x.size());
}

std::vector<Vec3> pulled(const Membrane& membrane, std::vector<Vec3> x, int times = 1) {
  for (int i = 0; i < times; ++i) x = test::sum_of(x, displacements(membrane, x));
  return x;
}

// 1/2 A e^T C e in double, the strains taken in the frame that matches best.
double energy(const Membrane& membrane, int t, const std::vector<Vec3>& x) {
  const RestFrame frame = rest_frame(membrane.sheet, t, membrane.masses);
  const auto& [a, b, c] = membrane.sheet.triangles[t];
  const auto [r1, r2] = matched_frame<double>(frame.k1, frame.k2, x[b] - x[a], x[c] - x[a]);
  Eigen::Matrix2d edges, rest;
  edges << r1.dot(x[b] - x[a]), r1.dot(x[c] - x[a]), r2.dot(x[b] - x[a]), r2.dot(x[c] - x[a]);
  rest << frame.edge1, frame.edge2;
  const Eigen::Matrix2d gradient = edges * rest.inverse();
  const Vec3 strain(gradient(0, 0) - 1, gradient(1, 1) - 1, gradient(0, 1) + gradient(1, 0));
  return 0.5 * frame.area * strain.dot(membrane_tensor(material_of(membrane.sheet, t), frame.warp) * strain);
}

double energy(const Membrane& membrane, const std::vector<Vec3>& x) {
  double sum = 0;
  for (int t = 0; t < static_cast<int>(membrane.sheet.triangles.size()); ++t) sum += energy(membrane, t, x);
  return sum;
}

// dE/dx by differences.
std::vector<Vec3> energy_gradient(const Membrane& membrane, std::vector<Vec3> x) {
  constexpr double difference = 1e-6;
  std::vector<Vec3> gradient = test::zeros(x.size());
  for (std::size_t v = 0; v < x.size(); ++v)
    for (int i = 0; i < 3; ++i) {
      const double at = x[v][i];
      x[v][i] = at + difference;
      const double above = energy(membrane, x);
      x[v][i] = at - difference;
      gradient[v][i] = (above - energy(membrane, x)) / (2 * difference);
      x[v][i] = at;
    }
  return gradient;
}

ElasticMaterial fabric() {
  ElasticMaterial material;
  material.stretch_stiffness = {5000, 2000};
  material.shear_stiffness = 300;
  material.poisson_ratio = 0.2;
  return material;
}

TEST(Membrane, ARestShapeMovedRigidlyStays) {
  Random random(1);
  for (const TriangleMesh& mesh : {test::jittered_grid(9), make_sphere(0.4, 12, 9), test::tetrahedron()}) {
    const Sheet sheet = sheet_of(mesh, fabric());
    const Membrane membrane = membrane_of(sheet, test::random_masses(mesh.positions.size(), random), 1);
    EXPECT_LT(test::longest(displacements(membrane, mesh.positions)), 5e-6);
    const std::vector<Vec3> x = test::moved(mesh.positions, random.rotation(), random.vector(100));
    EXPECT_LT(test::longest(displacements(membrane, x)), 5e-6);
  }
}

TEST(Membrane, OffsetsThatTurnTheRestShapeStay) {
  Random random(2);
  const TriangleMesh mesh = test::jittered_grid(6);
  const Membrane membrane = membrane_of(sheet_of(mesh, fabric()), std::vector<double>(36, 0.01), 1);
  const std::vector<Vec3> turned = test::moved(mesh.positions, random.rotation(), random.vector());
  std::vector<LaneRow> base;
  load_membrane(membrane.stage, test::split_of(mesh.positions), base);
  std::vector<Vec3> ways;
  for (std::size_t v = 0; v < 36; ++v) ways.push_back(turned[v] - mesh.positions[v]);
  std::vector<Point4> offsets = test::points_of(ways, membrane.inverse_masses);
  pull_membrane(membrane.stage, base, offsets);
  EXPECT_LT(test::farthest(test::vectors_of(offsets, 36), ways), 2e-6);
}

// One implicit step of a very short duration h moves a point by -h2 w dE/dx. The pull leaves out that the
// frame turns with the points, which is of the order of the strain.
TEST(Membrane, APullIsTheGradientOfTheMembranesEnergy) {
  Random random(3);
  constexpr double duration_squared = 1e-12;
  for (int trial = 0; trial < 20; ++trial) {
    ElasticMaterial material = fabric();
    material.shear_stiffness = random.between(100, 2000);
    const TriangleMesh mesh = test::jittered_grid(4, static_cast<unsigned>(trial));
    const Sheet sheet = sheet_of(mesh, material, Vec3(1, 0, random.between(-2, 2)));
    const Membrane membrane = membrane_of(sheet, test::random_masses(16, random), duration_squared);
    const std::vector<Vec3> strained = test::shaken(mesh.positions, 1e-4, random);
    const std::vector<Vec3> x = test::moved(strained, random.rotation(), random.vector());
    const std::vector<Vec3> d = displacements(membrane, x), gradient = energy_gradient(membrane, x);
    for (std::size_t v = 0; v < 16; ++v) {
      const Vec3 wanted = -duration_squared / membrane.masses[v] * gradient[v];
      EXPECT_LT((d[v] - wanted).norm(), 0.01 * test::longest(d)) << "trial " << trial;
    }
  }
}

// What stays of a uniform strain, in a triangle alone, times the inverse of a short duration: the force.
double force_of(const Vec3& strain, const ElasticMaterial& material) {
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const Membrane membrane = membrane_of(sheet_of(mesh, material), {1, 1, 1}, 1e-8);
  std::vector<Vec3> x = mesh.positions;
  for (Vec3& p : x)
    p +=
        Vec3(strain.x() * p.x() + 0.5 * strain.z() * p.y(), strain.y() * p.y() + 0.5 * strain.z() * p.x(), 0);
  return test::longest(displacements(membrane, x)) * 1e8;
}

TEST(Membrane, WarpWeftAndShearHaveStiffnessesOfTheirOwn) {
  ElasticMaterial material;
  material.stretch_stiffness = {5000, 2000};
  material.shear_stiffness = 300;
  constexpr double strain = 1e-3;
  const double warp = force_of({strain, 0, 0}, material), weft = force_of({0, strain, 0}, material);
  const double shear = force_of({0, 0, strain}, material);
  EXPECT_NEAR(warp, 0.5 * 5000 * strain, 0.002 * warp);
  EXPECT_NEAR(weft, 0.5 * 2000 * strain, 0.002 * weft);
  EXPECT_NEAR(shear, 0.5 * 300 * strain * std::sqrt(2),
              0.002 * shear);  // both forces meet at the first corner
}

TEST(Membrane, ASweepKeepsLinearMomentum) {
  Random random(4);
  const TriangleMesh mesh = test::jittered_grid(12);
  const Membrane membrane = membrane_of(sheet_of(mesh, fabric()), test::random_masses(144, random), 1e-3);
  const std::vector<Vec3> x = test::shaken(mesh.positions, 0.03, random);
  ASSERT_GT(test::longest(displacements(membrane, x)), 1e-3);
  EXPECT_LT(test::relative_momentum(membrane.masses, x, pulled(membrane, x)), 1e-6);
}

TEST(Membrane, ATriangleKeepsAngularMomentumToFirstOrder) {
  Random random(5);
  for (const double size : {0.1, 0.01, 0.001}) {
    double worst = 0;
    for (int trial = 0; trial < 100; ++trial) {
      const TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0.2}, {0.3, 0, -1}}, {{0, 1, 2}}, {}, {}};
      const Membrane membrane = membrane_of(sheet_of(mesh, fabric()), test::random_masses(3, random), 1e-3);
      const std::vector<Vec3> x = test::shaken(mesh.positions, size, random);
      worst = std::max(worst, test::relative_angular_momentum(membrane.masses, x, pulled(membrane, x)));
    }
    EXPECT_LT(worst, 3 * size);
  }
}

void expect_rest_lengths(const Sheet& sheet, const std::vector<Vec3>& x, double tolerance) {
  ASSERT_TRUE(test::all_finite(x));
  for (const Edge& edge : sheet.topology.edges)
    EXPECT_NEAR((x[edge.vertices[1]] - x[edge.vertices[0]]).norm(), rest_length(sheet, edge), tolerance);
}

TEST(Membrane, ASheetStretchedAlongWarpReturns) {
  const TriangleMesh mesh = make_grid({1, 1}, {9, 9});
  const Sheet sheet = sheet_of(mesh, fabric());
  const Membrane membrane = membrane_of(sheet, lumped_masses(sheet), 1e-4);
  const std::vector<Vec3> stretched =
      test::moved(mesh.positions, Vec3(1.01, 1, 1).asDiagonal(), Vec3::Zero());
  expect_rest_lengths(sheet, pulled(membrane, stretched, 2000), 1e-5);
}

TEST(Membrane, EnergyNeverGrowsOverSweeps) {
  Random random(6);
  const TriangleMesh mesh = test::jittered_grid(8);
  for (const double duration_squared : {1e-8, 1e-5, 1e-2}) {
    const Sheet sheet = sheet_of(mesh, fabric());
    const Membrane membrane = membrane_of(sheet, lumped_masses(sheet), duration_squared);
    std::vector<Vec3> x = test::shaken(mesh.positions, 0.005, random);
    for (int sweep = 0; sweep < 30; ++sweep) {
      const double before = energy(membrane, x);
      x = pulled(membrane, x);
      ASSERT_LE(energy(membrane, x), before * (1 + 1e-6)) << "sweep " << sweep;
    }
  }
}

const Sheet& lone_triangle() {
  static const TriangleMesh mesh = {{{0, 0, 0}, {1, 0, 0.1}, {0.3, 0, -0.8}}, {{0, 1, 2}}, {}, {}};
  static const Sheet sheet = sheet_of(mesh, fabric());
  return sheet;
}

TEST(Membrane, CollapsedTrianglesRecoverTheirShape) {
  const Membrane membrane = membrane_of(lone_triangle(), {0.1, 0.2, 0.15}, 1e-3);
  const std::vector<std::vector<Vec3>> collapsed = {
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},          {{1, 0, 0}, {0, 0, 0}, {2, 0, 0}},
      {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}},          {{1, 2, 3}, {4, 5, 6}, {4, 5, 6}},
      {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}},          {{7, 7, 7}, {7, 7, 7}, {7, 7, 7}},
      {{0, 0, 0}, {1, 1e-6, 0}, {0.5, -1e-7, 0}}, {{0, 0, 0}, {1e-9, 0, 0}, {0, 1e-9, 0}},
      {{0, 0, 0}, {1e-20, 0, 0}, {0, 1e-20, 0}},  {{0, 0, 0}, {1, 0, 0}, {0, 2e-4, 0}}};
  for (const std::vector<Vec3>& x : collapsed)
    expect_rest_lengths(membrane.sheet, pulled(membrane, x, 2000), 1e-4);
}

TEST(Membrane, AMirroredTriangleIsTheSameTriangleTurnedOver) {
  const Membrane membrane = membrane_of(lone_triangle(), {0.1, 0.2, 0.15}, 1e-3);
  std::vector<Vec3> mirrored =
      test::moved(lone_triangle().rest_positions, Vec3(1, 1, -1).asDiagonal(), Vec3::Zero());
  EXPECT_LT(test::longest(displacements(membrane, mirrored)), 1e-6);
  std::swap(mirrored[0], mirrored[2]);
  expect_rest_lengths(membrane.sheet, pulled(membrane, mirrored, 2000), 1e-4);
}

TEST(Membrane, CollapsedTrianglesOfEverySizeStayFiniteAndBounded) {
  Random random(7);
  const Membrane membrane = membrane_of(lone_triangle(), {0.1, 0.2, 0.15}, 1e-3);
  for (double size = 1e-25; size < 1e6; size *= 10)
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<Vec3> x = {random.vector(size), random.vector(size), random.vector(size)};
      if (trial % 2 == 0) x[2] = x[0] + random.between(-2, 2) * (x[1] - x[0]);
      const std::vector<Vec3> d = displacements(membrane, x);
      ASSERT_TRUE(test::all_finite(d)) << size;
      EXPECT_LT(test::longest(d), 4 * (1 + size)) << size;
    }
}

TEST(Membrane, PointsWithoutInverseMassStay) {
  Random random(8);
  const TriangleMesh mesh = test::jittered_grid(8);
  const Membrane membrane =
      membrane_of(sheet_of(mesh, fabric()), test::random_masses(64, random), 1e-3, {0, 20, 21});
  const std::vector<Vec3> d = displacements(membrane, test::shaken(mesh.positions, 0.03, random));
  for (const int pin : {0, 20, 21}) EXPECT_EQ(d[pin], Vec3(0, 0, 0));
  EXPECT_NE(d[1], Vec3(0, 0, 0));
}

TEST(Membrane, NoDurationAndNoStiffnessOvershoots) {
  for (const double duration_squared : {1.0, 1e4, 1e8}) {
    const Membrane membrane = membrane_of(lone_triangle(), {0.1, 3, 0.15}, duration_squared);
    const std::vector<Vec3> stretched =
        test::moved(lone_triangle().rest_positions, 1.01 * Mat3::Identity(), Vec3::Zero());
    expect_rest_lengths(membrane.sheet, pulled(membrane, stretched), 1e-5);
  }
}

std::vector<Vec3> damped(const Membrane& membrane, const std::vector<Vec3>& x,
                         const std::vector<Vec3>& velocities) {
  std::vector<LaneRow> base;
  load_membrane(membrane.stage, test::split_of(x), base);
  std::vector<Point4> points = test::points_of(velocities, membrane.inverse_masses);
  damp_membrane(membrane.stage, base, points);
  return test::vectors_of(points, x.size());
}

double kinetic_energy(const std::vector<double>& masses, const std::vector<Vec3>& velocities) {
  double sum = 0;
  for (std::size_t v = 0; v < masses.size(); ++v) sum += 0.5 * masses[v] * velocities[v].squaredNorm();
  return sum;
}

TEST(MembraneDamping, LeavesARigidMotion) {
  Random random(9);
  const TriangleMesh mesh = test::jittered_grid(8);
  const Membrane membrane = membrane_of(sheet_of(mesh, fabric()), test::random_masses(64, random), 1e-2);
  const Vec3 spin = random.vector(), drift = random.vector();
  std::vector<Vec3> velocities;
  for (const Vec3& x : mesh.positions) velocities.push_back(spin.cross(x) + drift);
  EXPECT_LT(test::farthest(damped(membrane, mesh.positions, velocities), velocities), 1e-5);
}

TEST(MembraneDamping, KeepsLinearMomentumAndTakesKineticEnergy) {
  Random random(10);
  const TriangleMesh mesh = test::jittered_grid(8);
  const Membrane membrane = membrane_of(sheet_of(mesh, fabric()), test::random_masses(64, random), 1e-2);
  const std::vector<Vec3> before = test::shaken(test::zeros(64), 1, random);
  const std::vector<Vec3> after = damped(membrane, mesh.positions, before);
  EXPECT_LT(test::relative_momentum(membrane.masses, before, after), 1e-6);
  EXPECT_LT(kinetic_energy(membrane.masses, after), 0.9 * kinetic_energy(membrane.masses, before));
}

TEST(MembraneDamping, MotionAcrossAFlatSheetIsNotDamped) {
  const TriangleMesh mesh = test::jittered_grid(5);
  const Membrane membrane = membrane_of(sheet_of(mesh, fabric()), std::vector<double>(25, 1), 1e-2);
  Random random(11);
  std::vector<Vec3> velocities;
  for (int v = 0; v < 25; ++v) velocities.emplace_back(0, random.between(-1, 1), 0);
  EXPECT_LT(test::farthest(damped(membrane, mesh.positions, velocities), velocities), 1e-6);
}

}  // namespace
}  // namespace drape

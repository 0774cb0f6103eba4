#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "mass_spring_cloth.h"

namespace drape {
namespace {

using test::equilateral_grid;
using test::Random;
using test::spring_material;
using test::SpringCloth;

TEST(MassSpring, HasASpringAnEdgeAndABendingElementAPairOfTriangles) {
  const SpringCloth cloth(make_grid({1, 1}, {6, 5}), {});
  EXPECT_EQ(cloth.model.springs.size(), 5u * 5 + 4 * 6 + 20);
  EXPECT_EQ(cloth.model.bending.size(), cloth.model.springs.size() - 18);  // less the edges of the boundary
}

TEST(MassSpring, AShapeAtRestHasNoForceWhereverItIsMoved) {
  Random random(1);
  for (const TriangleMesh& mesh : {test::jittered_grid(9), make_sphere(0.4, 12, 9), test::tetrahedron()}) {
    SpringCloth cloth(mesh, spring_material(100, 0.1, 0));
    cloth.x = test::moved(cloth.x, random.rotation(), random.vector());
    for (const Vec3& force : cloth.forces()) EXPECT_LT(force.norm(), 1e-10);
  }
}

// As long as no triangle is squeezed.
TEST(MassSpring, ForcesAreTheGradientOfTheEnergy) {
  Random random(2);
  constexpr double h = 1e-6;
  SpringCloth cloth(make_sphere(0.4, 7, 5), spring_material(10, 0.3, 0));
  cloth.x = test::shaken(cloth.x, 0.02, random);
  const std::vector<Vec3> forces = cloth.forces();
  for (std::size_t v = 0; v < cloth.x.size(); ++v)
    for (int axis = 0; axis < 3; ++axis) {
      SpringCloth more = cloth, less = cloth;
      more.x[v][axis] += h;
      less.x[v][axis] -= h;
      EXPECT_NEAR(forces[v][axis], (less.energy() - more.energy()) / (2 * h), 1e-6);
    }
}

// A membrane pulled by a strain e stores 1/2 Y e2 an area where it may contract and shear as it likes.
// Springs on an equilateral mesh contract by a third of e (Poisson's ratio 1/3), on a grid they shear by e.
double stored_by_pulling(const TriangleMesh& mesh, const Mat3& strain) {
  SpringCloth cloth(mesh, spring_material(300, 0, 0));
  cloth.x = test::moved(cloth.x, Mat3::Identity() + strain, Vec3::Zero());
  return cloth.spring_energy() / cloth.area();
}

Mat3 strain_of(double xx, double zz, double xz) {
  Mat3 strain = Mat3::Zero();
  strain(0, 0) = xx;
  strain(2, 2) = zz;
  strain(0, 2) = strain(2, 0) = xz;
  return strain;
}

TEST(MassSpring, AnEquilateralMeshHasTheMaterialsStiffnessInEveryDirection) {
  constexpr double e = 1e-4;
  const double wide = stored_by_pulling(equilateral_grid(40, 40, 0.01), strain_of(e, -e / 3, 0));
  EXPECT_NEAR(wide / (0.5 * 300 * e * e), 1, 0.03);  // springs on the boundary have one triangle
  for (const double angle : {0.2, 0.5, 1.3})
    EXPECT_NEAR(stored_by_pulling(equilateral_grid(40, 40, 0.01, angle), strain_of(e, -e / 3, 0)) / wide, 1,
                1e-2);
}

TEST(MassSpring, AGridHasTheMaterialsStiffnessAlongItsRowsAndColumns) {
  constexpr double e = 1e-4;
  const TriangleMesh mesh = make_grid({1, 0.7}, {9, 12});  // cells of 0.125 m x 0.0636 m
  const double ratio = (1.0 / 8) / (0.7 / 11), unit = 0.5 * 300 * e * e;
  EXPECT_NEAR(stored_by_pulling(mesh, strain_of(e, 0, -e / 2 * ratio)) / unit, 1, 1e-3);
  EXPECT_NEAR(stored_by_pulling(mesh, strain_of(0, e, -e / 2 / ratio)) / unit, 1, 1e-3);
}

// A strip of `rows` rows of points along x, clamped at both ends of each row and pulled by 1 %, when it
// has come to rest: the springs' tension at one end, over the strip's width and strain.
double strip_stiffness(const TriangleMesh& mesh, int rows, double length) {
  const int points = static_cast<int>(mesh.positions.size()), columns = points / rows;
  std::vector<int> pins;
  for (int i = 0; i < points; i += columns) pins.insert(pins.end(), {i, i + columns - 1});
  SpringCloth cloth(mesh, spring_material(300, 0, 0), pins);
  for (int i = columns - 1; i < points; i += columns) cloth.x[i].x() += 0.01 * length;
  for (int n = 0; n < 2000; ++n) {
    cloth.advance(cloth.model.stable_step);
    for (Vec3& v : cloth.v) v *= 0.95;
  }
  double tension = 0;
  for (const Spring& spring : cloth.model.springs) {
    const auto& [a, b] = spring.vertices;
    if ((a % columns == 0) == (b % columns == 0)) continue;
    const Vec3 along = cloth.x[b] - cloth.x[a];
    tension += spring.stiffness * (along.norm() - spring.rest_length) * std::abs(along.x()) / along.norm();
  }
  return tension / (cloth.area() / length) / 0.01;
}

TEST(MassSpring, AClampedStripIsAboutAsStiffAsItsMaterial) {
  EXPECT_NEAR(strip_stiffness(make_grid({0.5, 0.1}, {26, 6}), 6, 0.5) / 300, 1, 0.05);
  EXPECT_NEAR(strip_stiffness(equilateral_grid(25, 5, 0.02), 6, 0.5) / 300, 1, 0.05);
}

TEST(MassSpring, InPlaneMotionOfAFlatSheetCausesNoBendingForce) {
  Random random(3);
  for (const double bend : {1e-5, 1.0}) {
    SpringCloth stiff(test::jittered_grid(8), spring_material(50, bend, 0)),
        limp(test::jittered_grid(8), spring_material(50, 0, 0));
    for (Vec3& x : stiff.x) x += Vec3(random.between(-0.02, 0.02), 0, random.between(-0.02, 0.02));
    limp.x = stiff.x;
    EXPECT_LT(test::farthest(stiff.forces(), limp.forces()), 1e-14);
    for (const Vec3& force : stiff.forces()) EXPECT_EQ(force.y(), 0);
  }
}

TEST(MassSpring, BendingDampingLeavesInPlaneMotion) {
  Random random(4);
  SpringCloth cloth(test::jittered_grid(8), spring_material(50, 1e-3, 30));
  for (Spring& spring : cloth.model.springs) spring.stiffness = spring.damping = 0;
  for (Vec3& v : cloth.v) v = Vec3(random.between(-1, 1), 0, random.between(-1, 1));
  const std::vector<Vec3> before = cloth.v;
  cloth.advance(1e-4);
  EXPECT_EQ(cloth.v, before);
}

TEST(MassSpring, BendingForceRestoresAndGrowsWithTheFirstPowerOfTheAngle) {
  constexpr double side = 0.1, rigidity = 2e-3;
  const double height = 0.5 * std::sqrt(3) * side, area = 0.5 * side * height;
  const SpringCloth flat(test::equilateral_pair(side, 0), spring_material(100, rigidity, 0));
  for (const double angle : {-1.0, -1e-6, 1e-9, 1e-6, 1e-3, 1.0, 3.0}) {
    SpringCloth cloth = flat;
    cloth.x = test::equilateral_pair(side, angle).positions;
    const Vec3 force = cloth.forces()[3];  // across the edge, at (side / 2, sin, -cos)
    const Vec3 outward(0, std::cos(angle), std::sin(angle));
    const double expected = -4 * rigidity * side * side / (4 * area) * std::sin(angle / 2) / height;
    EXPECT_NEAR(force.dot(outward), expected, 1e-10 * std::abs(expected) + 1e-15);
    EXPECT_LT((force - force.dot(outward) * outward).norm(), 1e-12);
  }
}

// 1/2 B curvature2 an area, for a cylinder about the z axis.
double cylinder_energy(const TriangleMesh& mesh, double curvature) {
  SpringCloth cloth(mesh, spring_material(100, 1, 0));
  for (Vec3& x : cloth.x)
    x = {std::sin(curvature * x.x()) / curvature, (1 - std::cos(curvature * x.x())) / curvature, x.z()};
  return cloth.bending_energy() / (0.5 * curvature * curvature * cloth.area());
}

// A bending element is as stiff as the plate it stands for; the boundary, which has none, makes up for 3 %.
TEST(MassSpring, ACylinderStoresTheEnergyOfItsFlexuralRigidity) {
  for (const double angle : {0.0, 0.3, 0.8, 1.2})
    EXPECT_NEAR(cylinder_energy(equilateral_grid(60, 60, 0.01, angle), 1), 1, 0.04);
  EXPECT_NEAR(cylinder_energy(make_grid({0.6, 0.6}, {61, 61}), 1), 1, 0.03);
}

// Hinges depend on the mesh: across its diagonals a grid is up to three times as stiff as its material.
TEST(MassSpring, AGridIsStifferAcrossItsDiagonals) {
  const auto turned = [](double angle) {
    TriangleMesh mesh = make_grid({0.6, 0.6}, {61, 61});
    mesh.positions =
        test::moved(mesh.positions, Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix(), Vec3::Zero());
    return cylinder_energy(mesh, 1);
  };
  const double one = turned(std::numbers::pi / 4), other = turned(-std::numbers::pi / 4);
  EXPECT_NEAR(std::max(one, other), 3, 0.1);
  EXPECT_NEAR(std::min(one, other), 1, 0.05);
}

// k_e |g|2, the stiffness against motion along the gradients, would grow with 1 / height2.
TEST(MassSpring, BendingOfASqueezedTriangleIsAtMostTwiceAsStiffAsAtRest) {
  const SpringCloth rest(test::equilateral_pair(1, 0), spring_material(1e-9, 1, 0));
  const BendingElement& element = rest.model.bending[0];
  double at_rest = 0;
  for (const double length : element.gradient_lengths) at_rest += element.stiffness * length * length;
  for (const double height : {0.9, 0.75, 0.5, 1e-2, 1e-6}) {
    SpringCloth cloth = rest;
    cloth.x = test::equilateral_pair(1, 1e-3).positions;
    for (const int across : {2, 3})
      cloth.x[across] = {0.5, height * cloth.x[across].y(), height * cloth.x[across].z()};
    const BendingAngle angle = bending_angle(element.vertices, cloth.x);
    const std::vector<Vec3> forces = cloth.forces();
    double squeezed = 0;
    for (int i = 0; i < 4; ++i)
      squeezed -= forces[element.vertices[i]].dot(angle.gradients[i]) / angle.half_sine;
    EXPECT_NEAR(squeezed / at_rest, std::min(2.0, 1 / (height * height)), 1e-5);
  }
}

TEST(MassSpring, AFlattenedCurvedShapeIsPushedBackToItsCurvature) {
  SpringCloth cloth(test::equilateral_pair(0.1, 0.8), spring_material(100, 1e-3, 0));
  const double at_rest = bending_angle(cloth.model.bending[0].vertices, cloth.x).half_sine;
  EXPECT_NEAR(std::abs(at_rest), std::sin(0.4), 1e-14);
  cloth.x = test::equilateral_pair(0.1, 0.3).positions;
  EXPECT_GT(cloth.forces()[3].y(), 1e-4);
  cloth.x = test::equilateral_pair(0.1, 1.3).positions;
  EXPECT_LT(cloth.forces()[3].y(), -1e-4);
}

}  // namespace
}  // namespace drape

#include "simulation/strain_limits.h"

#include <gtest/gtest.h>

#include "mesh/primitives.h"

namespace drape {
namespace {

// A square of two triangles with sides along warp (x) and weft (z) and a diagonal.
Sheet square(const ElasticMaterial& material) {
  const TriangleMesh mesh = make_grid({1, 1}, {2, 2});
  Sheet sheet{mesh.positions, mesh.triangles, {0, 0}, {material}, {Vec3::UnitX()}, {}};
  sheet.topology = build_topology(4, mesh.triangles);
  return sheet;
}

// Of the square's side along `direction`, or its diagonal: how much longer and shorter it may be, as shares.
struct Shares {
  double longer, shorter;
};
Shares limits_along(const ElasticMaterial& material, const Vec3& direction) {
  const Sheet sheet = square(material);
  for (const EdgeLimits::Edge& edge : build_strain_limits(sheet).edges) {
    const Vec3 way = sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]];
    if (std::abs(way.normalized().dot(direction)) > 0.99)
      return {edge.longest / way.norm() - 1, 1 - edge.shortest / way.norm()};
  }
  ADD_FAILURE() << "no such edge";
  return {};
}

void expect_shares(const Shares& shares, double longer, double shorter) {
  EXPECT_NEAR(shares.longer, longer, 1e-12);
  EXPECT_NEAR(shares.shorter, shorter, 1e-12);
}

TEST(StrainLimits, OfFirmClothAreTwoAndFivePercent) {
  ElasticMaterial material;
  material.stretch_stiffness = {1e5, 1e5};
  expect_shares(limits_along(material, Vec3::UnitX()), 0.02, 0.05);
}

TEST(StrainLimits, OfSoftClothAreWhat400NewtonAMetreDo) {
  ElasticMaterial material;
  material.stretch_stiffness = {800, 5000};
  expect_shares(limits_along(material, Vec3::UnitX()), 0.5, 0.5);
  expect_shares(limits_along(material, Vec3::UnitZ()), 0.08, 0.08);
  material.stretch_stiffness = {100, 100};
  expect_shares(limits_along(material, Vec3::UnitX()), 4, 1);  // it may fold up, but not turn inside out
}

Vec3 diagonal(const Sheet& sheet) {
  for (const Edge& edge : sheet.topology.edges) {
    const Vec3 way = sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]];
    if (way.norm() > 1.1) return way.normalized();
  }
  return Vec3::Zero();
}

// Pulled along the bias, woven cloth shears: T / (4 S) of strain goes to that, and to the yarns
// T / 4 (1/a + 1/b - 2 nu / sqrt(a b)).
TEST(StrainLimits, AlongTheBiasShearGives) {
  ElasticMaterial material;
  material.stretch_stiffness = {20000, 5000};
  material.shear_stiffness = 500;
  material.poisson_ratio = 0.3;
  const double strain = 100 * (1.0 / 20000 + 1.0 / 5000 - 2 * 0.3 / 10000 + 1.0 / 500);
  expect_shares(limits_along(material, diagonal(square(material))), strain, strain);
}

TEST(StrainLimits, BetweenMaterialsTheTighterOnesHold) {
  for (const bool firm_first : {true, false}) {
    Sheet sheet = square({});
    sheet.materials.resize(2);
    sheet.warp_directions.resize(2, Vec3::UnitX());
    sheet.triangle_materials = {firm_first ? 0 : 1, firm_first ? 1 : 0};
    sheet.materials[0].stretch_stiffness = {1e5, 1e5};
    sheet.materials[0].shear_stiffness = 1e5;
    sheet.materials[1].stretch_stiffness = {800, 800};
    const Vec3 along = diagonal(sheet);
    for (const EdgeLimits::Edge& edge : build_strain_limits(sheet).edges) {
      const Vec3 way = sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]];
      if (way.normalized().dot(along) > 0.99) {
        EXPECT_NEAR(edge.longest / way.norm(), 1.02, 1e-12);
      }
    }
  }
}

TEST(StrainLimits, AMaterialsOwnGoesBefore) {
  ElasticMaterial material;
  material.strain_limit = 0.005;
  expect_shares(limits_along(material, Vec3::UnitX()), 0.005, 0.05);
  material.strain_limit = 0.3;
  expect_shares(limits_along(material, Vec3::UnitX()), 0.3, 0.3);
}

}  // namespace
}  // namespace drape

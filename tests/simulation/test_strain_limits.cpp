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

// Pulled along the bias, woven cloth shears: T / (4 S) of strain goes to that, and T / (2 k) to the yarns.
TEST(StrainLimits, AlongTheBiasShearGives) {
  ElasticMaterial material;
  material.stretch_stiffness = {20000, 20000};
  material.shear_stiffness = 500;
  const double strain = 400 * (0.5 / 20000 + 0.25 / 500);
  for (const double z : {1.0, -1.0}) {
    const Sheet sheet = square(material);
    const Vec3 bias = Vec3(1, 0, z).normalized();
    bool has_diagonal = false;
    for (const Edge& edge : sheet.topology.edges)
      has_diagonal |=
          std::abs((sheet.rest_positions[edge.vertices[1]] - sheet.rest_positions[edge.vertices[0]])
                       .normalized()
                       .dot(bias)) > 0.99;
    if (has_diagonal) expect_shares(limits_along(material, bias), strain, strain);
  }
}

TEST(StrainLimits, AMaterialsOwnGoesBefore) {
  ElasticMaterial material;
  material.strain_limit = 0.005;
  expect_shares(limits_along(material, Vec3::UnitX()), 0.005, 0.05);
  material.strain_limit = 0.3;
  expect_shares(limits_along(material, Vec3::UnitX()), 0.3, 0.05);
}

}  // namespace
}  // namespace drape

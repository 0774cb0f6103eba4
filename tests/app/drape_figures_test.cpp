#include "app/drape_figures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/primitives.h"

namespace drape::app {
namespace {

// A round piece of 30 cm on a table of 18 cm, the second of two cloths.
class DrapeFiguresOfATest : public testing::Test {
 protected:
  DrapeFiguresOfATest() {
    scene.cloths.resize(2);
    scene.cloths[0].input.mesh = make_grid({1, 1}, {3, 3});
    scene.cloths[1].input.mesh = make_disc(0.3, 0.003);
    scene.colliders.resize(1);
    scene.colliders[0].input.shape = CylinderShape{0.09, 0.02};
    scene.drape_test = DrapeTest{1, 0};
    frame.collider_poses.resize(1);
    frame.positions.assign(9, Vec3f(5, 5, 5));
  }

  // The piece shrunk about the table's edge, to a outline of `radius(angle)`.
  template <typename Radius>
  DrapeFigures with_outline(const Radius& radius) {
    for (const Vec3& p : scene.cloths[1].input.mesh.positions) {
      const double flat = p.norm();
      const double outside = (radius(std::atan2(-p.z(), p.x())) - 0.09) / 0.06;
      const double reach = flat > 0.09 ? 0.09 + (flat - 0.09) * outside : flat;
      frame.positions.push_back((flat > 0 ? Vec3(p * (reach / flat)) : p).cast<float>());
    }
    return measure_drape(scene, frame);
  }

  SceneDescription scene;
  CachedFrame frame;
};

TEST_F(DrapeFiguresOfATest, FlatIsAHundredWithoutFolds) {
  const DrapeFigures figures = with_outline([](double) { return 0.15; });
  EXPECT_NEAR(figures.coefficient, 100, 0.1);
  EXPECT_EQ(figures.folds, 0);
}

TEST_F(DrapeFiguresOfATest, HangingStraightDownIsNothing) {
  EXPECT_NEAR(with_outline([](double) { return 0.09; }).coefficient, 0,
              0.3);  // the mesh cuts the rim's corners
}

// The area of r = r0 + a cos(n phi) is pi (r0^2 + a^2 / 2).
TEST_F(DrapeFiguresOfATest, FoldsCountAndCoverTheirShare) {
  const DrapeFigures figures = with_outline([](double phi) { return 0.12 + 0.01 * std::cos(6 * phi); });
  const double shadow = 0.12 * 0.12 + 0.01 * 0.01 / 2;
  EXPECT_NEAR(figures.coefficient, 100 * (shadow - 0.09 * 0.09) / (0.15 * 0.15 - 0.09 * 0.09), 0.1);
  EXPECT_EQ(figures.folds, 6);
}

TEST_F(DrapeFiguresOfATest, RipplesAreNoFolds) {
  EXPECT_EQ(with_outline([](double phi) { return 0.12 + 0.0005 * std::cos(6 * phi); }).folds, 0);
}

}  // namespace
}  // namespace drape::app

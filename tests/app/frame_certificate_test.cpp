#include "app/frame_certificate.h"

#include <gtest/gtest.h>

#include "app/fault_picture.h"
#include "mesh/primitives.h"

namespace drape::app {
namespace {

ClothDescription cloth_of(const TriangleMesh& mesh, int subdivide = 0) {
  ClothDescription cloth;
  cloth.input.mesh = mesh;
  cloth.look.subdivide = subdivide;
  return cloth;
}

// All cloths of the scene as they are at rest, and the colliders at the origin.
CachedFrame at_rest(const SceneDescription& scene) {
  CachedFrame frame;
  frame.frame = 7;
  for (const ClothDescription& cloth : scene.cloths)
    for (const Vec3& position : cloth.input.mesh.positions) frame.positions.push_back(position.cast<float>());
  frame.collider_poses.resize(scene.colliders.size());
  return frame;
}

FrameCertificate certificate_of(const SceneDescription& scene, const CachedFrame& frame) {
  return certify_frame(prepare_certificate(scene), frame);
}

SceneDescription sheet_and(const ColliderShape& shape) {
  SceneDescription scene;
  scene.cloths = {cloth_of(make_grid({1, 1}, {11, 11}))};
  scene.colliders.resize(1);
  scene.colliders[0].input.shape = shape;
  return scene;
}

TEST(FrameCertificate, HasTheStretchAgainstTheRestShape) {
  SceneDescription scene;
  scene.cloths = {cloth_of(make_grid({1, 1}, {3, 3}))};
  CachedFrame frame = at_rest(scene);
  for (Vec3f& p : frame.positions) p.x() *= 1.25f;
  const FrameCertificate certificate = certificate_of(scene, frame);
  EXPECT_EQ(certificate.name, "7");
  EXPECT_TRUE(is_certified(certificate));
  EXPECT_NEAR(certificate.largest_stretch, 1.25, 1e-6);
  EXPECT_NEAR(certificate.smallest_stretch, 1, 1e-6);
  EXPECT_FALSE(certificate.drawn);
}

// The frame says what shape a collider has that deforms: in one of two it reaches through the sheet.
TEST(FrameCertificate, JudgesAgainstTheShapeThatAColliderHasInTheFrame) {
  const TriangleMesh box = make_box({0.2, 0.2, 0.2});
  MeshShape shape{box, {box.positions, box.positions}, 0, 1};
  const SceneDescription scene = sheet_and(shape);
  CachedFrame frame = at_rest(scene);
  for (const Vec3& p : box.positions) frame.collider_points.push_back((p + Vec3(0, -0.2, 0)).cast<float>());
  EXPECT_TRUE(is_certified(certificate_of(scene, frame)));
  for (Vec3f& p : frame.collider_points) p.y() += 0.2f;
  EXPECT_GT(certificate_of(scene, frame).simulated.collider_triangles, 0);
}

TEST(FrameCertificate, SeesOneClothThroughAnother) {
  SceneDescription scene;
  scene.cloths = {cloth_of(make_grid({1, 1}, {5, 5})), cloth_of(make_grid({1, 1}, {5, 5}))};
  CachedFrame frame = at_rest(scene);
  for (std::size_t v = 25; v < 50; ++v)
    frame.positions[v] = {frame.positions[v].x(), 0.05f + frame.positions[v].z(), 0.01f};
  EXPECT_GT(certificate_of(scene, frame).simulated.intersecting_pairs, 4);
}

// A tent, and a small sheet under its top: what is smooth comes down onto it.
TEST(FrameCertificate, CertifiesTheDrawnSurfaceToo) {
  SceneDescription scene;
  TriangleMesh tent = make_grid({1, 1}, {3, 3}), under = make_grid({0.02, 0.02}, {2, 2});
  tent.positions[4].y() = 0.5;
  for (Vec3& p : under.positions) p.y() = 0.45;
  scene.cloths = {cloth_of(tent, 2), cloth_of(under)};
  const FrameCertificate certificate = certificate_of(scene, at_rest(scene));
  EXPECT_EQ(certificate.simulated.intersecting_pairs, 0);
  EXPECT_GT(certificate.simulated.smallest_gap, 0.01);
  ASSERT_TRUE(certificate.drawn);
  EXPECT_LT(certificate.drawn->smallest_gap, 0.45);
  scene.cloths[1].input.mesh.positions[0].y() = 0.0;
  const FrameCertificate torn = certificate_of(scene, at_rest(scene));
  EXPECT_EQ(torn.simulated.intersecting_pairs, 0);
  EXPECT_EQ(torn.drawn->intersecting_pairs, 0) << "a corner as far down as the smooth tent would reach";
}

TEST(FrameCertificate, SeesHowDeepTheSheetIsInEachKindOfCollider) {
  const struct {
    ColliderShape shape;
    double depth;
  } cases[] = {{SphereShape{0.3}, 0.3},
               {BoxShape{{0.6, 0.5, 0.6}}, 0.25},
               {CylinderShape{0.3, 0.4}, 0.2},
               {CapsuleShape{0.2, 0.5}, 0.2}};
  for (const auto& [shape, depth] : cases) {
    const SceneDescription scene = sheet_and(shape);
    CachedFrame frame = at_rest(scene);
    const FrameCertificate certificate = certificate_of(scene, frame);
    EXPECT_NEAR(certificate.simulated.collider_depth, depth, 1e-6) << shape.index();
    EXPECT_GT(certificate.simulated.collider_triangles, 8) << shape.index();
    frame.collider_poses[0].translation = Vec3(0, -1, 0);
    EXPECT_TRUE(is_certified(certificate_of(scene, frame))) << shape.index();
  }
}

TEST(FrameCertificate, FollowsAColliderToItsPose) {
  const SceneDescription scene = sheet_and(PlaneShape{});
  CachedFrame frame = at_rest(scene);
  frame.collider_poses[0].translation = Vec3(0, -0.1, 0);
  EXPECT_TRUE(is_certified(certificate_of(scene, frame)));
  frame.collider_poses[0].rotation = rotation_from_degrees({0, 0, 45});
  EXPECT_NEAR(certificate_of(scene, frame).simulated.collider_depth, (0.5 - 0.1) * std::sqrt(0.5), 1e-6);
}

// Of a mesh only its surface is known.
TEST(FrameCertificate, SeesTheSheetMeetTheSurfaceOfAMesh) {
  const SceneDescription scene = sheet_and(MeshShape{make_sphere(0.2, 16, 9)});
  CachedFrame frame = at_rest(scene);
  const FrameCertificate certificate = certificate_of(scene, frame);
  EXPECT_GT(certificate.simulated.collider_triangles, 8);
  EXPECT_EQ(certificate.simulated.collider_depth, 0);
  frame.collider_poses[0].translation = Vec3(0, 0.21, 0);
  EXPECT_TRUE(is_certified(certificate_of(scene, frame)));
}

TEST(FaultPicture, ShowsThoseThatMeetOrAreInACollider) {
  const ClothSurface surface{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {std::nan(""), 1, 0}},
                             {{0, 1, 2}, {0, 1, 2}, {0, 1, 2}, {0, 1, 3}, {0, 1, 2}}};
  CertifiedSurface certified;
  certified.intersecting = {{0, 2}, {2, 4}};
  certified.in_colliders = {2, 3};
  EXPECT_EQ(faulty_triangles(surface, certified), std::vector<int>({0, 2, 4}));
}

}  // namespace
}  // namespace drape::app

#include "app/start.h"

#include <gtest/gtest.h>

#include "app/manifest.h"
#include "app/run_program.h"
#include "core/file.h"
#include "mesh/primitives.h"
#include "render/png_file.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

constexpr double least_gap = 10e-6;

ClothDescription sheet(const std::string& name, double y) {
  ClothDescription cloth;
  cloth.input.name = name;
  cloth.input.mesh = make_grid({1, 1}, {5, 5});
  cloth.input.start_positions = cloth.input.mesh.positions;
  for (Vec3& p : cloth.input.start_positions) p.y() += y;
  return cloth;
}

SceneDescription scene_of(std::vector<ClothDescription> cloths) {
  SceneDescription scene;
  scene.cloths = std::move(cloths);
  return scene;
}

// Folded flat onto itself along the line z = 0.
ClothDescription folded() {
  ClothDescription cloth = sheet("napkin", 0);
  for (Vec3& p : cloth.input.start_positions) p.z() = std::abs(p.z());
  return cloth;
}

void add_collider(SceneDescription& scene, ColliderShape shape, double y) {
  scene.colliders.emplace_back();
  scene.colliders.back().input.name = "block";
  scene.colliders.back().input.shape = std::move(shape);
  for (int axis = 0; axis < 3; ++axis)
    scene.colliders.back().input.motion.translate[axis] = {{0, axis == 1 ? y : 0}};
}

double farthest_move(const SceneDescription& scene, const Start& start) {
  double farthest = 0;
  std::size_t v = 0;
  for (const ClothDescription& cloth : scene.cloths)
    for (const Vec3& p : cloth.input.start_positions)
      farthest = std::max(farthest, (start.surface.positions[v++] - p).norm());
  return farthest;
}

void expect_set_apart(const SceneDescription& scene) {
  const Start start = find_start(scene);
  EXPECT_TRUE(is_clean(start.certified));
  EXPECT_GE(start.certified.figures.smallest_gap, least_gap);
  EXPECT_GT(farthest_move(scene, start), 0);
  EXPECT_LT(farthest_move(scene, start), 100e-6);
}

TEST(Start, IsLeftAsItIsPlacedWhereNothingTouches) {
  const SceneDescription scene = scene_of({sheet("under", 0), sheet("over", 0.001)});
  EXPECT_EQ(farthest_move(scene, find_start(scene)), 0);
}

TEST(Start, SetsLayersApartThatLieExactlyInEachOther) {
  expect_set_apart(scene_of({sheet("one", 0), sheet("two", 0), sheet("three", 0)}));
}

TEST(Start, SetsLayersApartThatAreNearerThanContactKeeps) {
  expect_set_apart(scene_of({sheet("under", 0), sheet("over", 1e-6)}));
  expect_set_apart(scene_of({sheet("over", 1e-6), sheet("under", 0)}));
}

TEST(Start, SetsAClothApartThatIsFoldedFlatOntoItself) { expect_set_apart(scene_of({folded()})); }

TEST(Start, SetsUprightLayersApart) {
  SceneDescription scene = scene_of({sheet("shirt", 0), sheet("pocket", 0)});
  for (ClothDescription& cloth : scene.cloths)
    for (Vec3& p : cloth.input.start_positions) p = Vec3(p.x(), p.z(), 0);
  expect_set_apart(scene);
}

TEST(Start, SetsClothApartFromAColliderThatItLiesOnOrUnder) {
  SceneDescription on = scene_of({sheet("sheet", 0.05)}), under = scene_of({sheet("sheet", -0.05)});
  add_collider(on, BoxShape{Vec3(0.3, 0.1, 0.3)}, 0);
  add_collider(under, BoxShape{Vec3(0.3, 0.1, 0.3)}, 0);
  expect_set_apart(on);
  expect_set_apart(under);
}

TEST(Start, NamesClothsThatAreThroughEachOther) {
  SceneDescription scene = scene_of({sheet("under", 0), sheet("over", 0.1)});
  scene.cloths[1].place = {std::make_shared<const std::string>("scene.yaml"), 9, 3};
  scene.cloths[1].input.start_positions[12].y() = -0.1;
  const std::vector<Problem> problems = start_problems(scene, find_start(scene));
  ASSERT_EQ(problems.size(), 1u);
  const std::string words = to_string(problems[0]);
  EXPECT_EQ(words.find("scene.yaml:9:3: error: cloths.over starts through cloths.under: triangle "), 0u)
      << words;
  EXPECT_NE(words.find(" of over meets triangle "), std::string::npos) << words;
  EXPECT_NE(words.find(" more pairs; move one of them with `place`"), std::string::npos) << words;
}

TEST(Start, NamesAClothThatIsThroughItself) {
  SceneDescription scene = scene_of({sheet("napkin", 0)});
  scene.cloths[0].input.start_positions[0] = Vec3(0.06, -0.1, 0.04);
  scene.cloths[0].input.start_positions[1] += Vec3(0.2, 0.1, 0.2);
  const std::vector<Problem> problems = start_problems(scene, find_start(scene));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("cloths.napkin starts through itself: triangle "), std::string::npos);
}

TEST(Start, NamesTheColliderThatAClothIsIn) {
  SceneDescription scene = scene_of({sheet("sheet", 0)});
  add_collider(scene, SphereShape{0.2}, 0.1);
  const std::vector<Problem> problems = start_problems(scene, find_start(scene));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("cloths.sheet starts in colliders.block: triangle "), std::string::npos);
}

// Two layers that only touch, and a third that crosses them: what is told is the crossing.
TEST(Start, TellsNothingOfWhatOnlyTouches) {
  SceneDescription scene = scene_of({sheet("one", 0), sheet("two", 0), sheet("three", 0.1)});
  scene.cloths[2].input.start_positions[12].y() = -0.1;
  for (const Problem& problem : start_problems(scene, find_start(scene)))
    EXPECT_NE(problem.message.find("cloths.three starts through"), std::string::npos) << problem.message;
}

TEST(Start, OwnCrossingsAreNobodysFaultWithoutSelfCollision) {
  SceneDescription scene = scene_of({folded(), sheet("other", 0.5)});
  scene.self_collision = false;
  EXPECT_TRUE(start_problems(scene, find_start(scene)).empty());
  scene.cloths[1].input.start_positions[12].y() = -0.1;
  EXPECT_FALSE(start_problems(scene, find_start(scene)).empty());
}

// The napkin of write_scene starts over the ball.
class RefusedStart : public testing::Test {
 protected:
  Finished simulate(const std::string& at) { return run_drape({"simulate", scene, "-o", run, "-D", at}); }

  const TemporaryFolder folder;
  const std::string scene = write_scene(folder, "napkin", 2);
  const std::string run = (folder / "run").string();
};

TEST_F(RefusedStart, IsAMistakeOfTheScenesWithAPicture) {
  const Finished finished = simulate("cloths.napkin.place.at=[0, 0.3, 0]");
  EXPECT_EQ(finished.exit_status, 2);
  EXPECT_NE(
      finished.err.find("place.at=[0, 0.3, 0]: error: cloths.napkin starts in colliders.ball: triangle "),
      std::string::npos)
      << finished.err;
  EXPECT_NE(finished.err.find("(red in " + run + "/start.png)"), std::string::npos) << finished.err;
  EXPECT_TRUE(fs::exists(run + "/start.png"));
}

TEST_F(RefusedStart, LeavesTheFramesOfAnEarlierOne) {
  ASSERT_EQ(simulate("cloths.napkin.place.at=[0, 0.45, 0]").exit_status, 0);
  const std::string before = content_of_folder(run + "/cache");
  EXPECT_EQ(simulate("cloths.napkin.place.at=[0, 0.3, 0]").exit_status, 2);
  EXPECT_EQ(content_of_folder(run + "/cache"), before);
}

TEST_F(RefusedStart, IsFoundByValidate) {
  const Finished finished = run_drape({"validate", scene, "-D", "cloths.napkin.place.at=[0, 0.3, 0]"});
  EXPECT_EQ(finished.exit_status, 2);
  EXPECT_NE(finished.err.find("cloths.napkin starts in colliders.ball"), std::string::npos) << finished.err;
}

TEST_F(RefusedStart, IsToldByInfo) {
  const auto info = [&](const std::string& at) { return run_drape({"info", scene, "-D", at}); };
  const Finished finished = info("cloths.napkin.place.at=[0, 0.3, 0]");
  EXPECT_EQ(finished.exit_status, 0);
  EXPECT_NE(
      finished.out.find("\nstart      will be refused: cloths.napkin starts in colliders.ball: triangle "),
      std::string::npos)
      << finished.out;
  EXPECT_NE(finished.out.find(" more triangles; move one of them with `place`\n"), std::string::npos);
  EXPECT_LT(finished.out.find("\nsimulated  "), finished.out.find("\nstart      ")) << "what is quick to say";
  EXPECT_NE(
      info("cloths.napkin.place.at=[0, 0.45, 0]").out.find("\nstart      nothing is through anything\n"),
      std::string::npos);
}

// Exactly on each other at first; a second later as far apart as their thickness asks, but for a share.
TEST(TouchingStart, GrowsToTheThickness) {
  const TemporaryFolder folder;
  const std::string scene = (folder / "layers.yaml").string();
  write_file(scene, R"(version: 1
time: {fps: 30, frames: 30}
cloths:
  one: {grid: {size: [0.3, 0.3], points: [9, 9]}, place: {at: [0, 0.1, 0]}}
  two: {grid: {size: [0.3, 0.3], points: [9, 9]}, place: {at: [0, 0.1, 0]}}
colliders:
  block: {box: {size: [0.2, 0.1, 0.2]}, place: {at: [0, 0.05, 0]}}
test:
  - {what: smallest_gap, frames: 30-30, least: 0.0035}
)");
  const std::string run = (folder / "run").string();
  ASSERT_EQ(run_drape({"simulate", scene, "-o", run}).exit_status, 0);
  const Finished finished = run_drape({"verify", run});
  EXPECT_EQ(finished.exit_status, 0) << finished.out;
}

}  // namespace
}  // namespace drape::app

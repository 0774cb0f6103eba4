#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "mesh/primitives.h"
#include "scene/scene_text.h"

namespace drape {

static ClothInput cloth_with(const std::string& keys) {
  const std::string text = "version: 1\ntime: {fps: 10}\ncloths: {a: {grid: {size: [2, 2], points: [3, 3]}, ";
  return load_text(text + keys + "}}\n").cloths.at(0).input;
}

static ColliderInput collider_with(const std::string& keys) {
  return load_text("time: {fps: 10}\n" + smallest_scene + "colliders: {c: {" + keys + "}}\n")
      .colliders.at(0)
      .input;
}

TEST(Load, NamesTheSceneAfterItsFile) { EXPECT_EQ(load_text(smallest_scene).name, "scene"); }

TEST(Load, TakesFramesAsARangeOrACount) {
  const auto range = load_text(smallest_scene + "time: {frames: 11-20}\n").time;
  EXPECT_EQ(range.first_frame, 11);
  EXPECT_EQ(range.last_frame, 20);
  const auto count = load_text(smallest_scene + "time: {frames: 25}\n").time;
  EXPECT_EQ(count.first_frame, 1);
  EXPECT_EQ(count.last_frame, 25);
}

TEST(Load, PlacesTheStartAndNotTheRestShape) {
  const ClothInput cloth = cloth_with("place: {at: [0, 5, 0], rotate: [90, 0, 0]}");
  EXPECT_EQ(cloth.mesh.positions[0], Vec3(-1, 0, -1));
  EXPECT_EQ(cloth.start_positions[0], Vec3(-1, 6, 0));  // what was -z is up
}

TEST(Load, ReadsARoundPiece) {
  const auto scene =
      load_text("version: 1\ncloths: {a: {disc: {diameter: 30 cm, edge: 2 cm}, pins: [{corner: [+x]}]}}\n");
  const ClothInput& cloth = scene.cloths.at(0).input;
  EXPECT_EQ(cloth.mesh.triangles, make_disc(0.3, 0.02).triangles);
  EXPECT_NEAR(cloth.mesh.positions.at(cloth.pins.at(0).vertices.at(0)).x(), 0.15, 1e-3);
}

TEST(Load, FindsTheCornerOfTheShapeBeforeItIsPlaced) {
  const std::string corner = "pins: [{corner: [-x, +z]}]";
  EXPECT_EQ(cloth_with(corner).pins.at(0).vertices, std::vector{6});
  EXPECT_EQ(cloth_with("place: {rotate: [0, 90, 0]}, " + corner).pins.at(0).vertices, std::vector{6});
  EXPECT_EQ(cloth_with("pins: [{corner: [+x]}]").pins.at(0).vertices, std::vector{5});
}

TEST(Load, FindsTheVerticesOfABoxOfTheWorld) {
  const ClothInput cloth =
      cloth_with("place: {at: [0, 5, 0]}, pins: [{box: {from: [2, 4, 2], to: [0.5, 6, -2]}}]");
  EXPECT_EQ(cloth.pins.at(0).vertices, (std::vector{2, 5, 8}));
}

TEST(Load, SortsVerticesAndDropsRepeats) {
  EXPECT_EQ(cloth_with("pins: [{vertices: [4, 1, 4]}]").pins.at(0).vertices, (std::vector{1, 4}));
}

TEST(Load, CountsTheTimeOfPinsInFrames) {
  const ClothInput cloth = cloth_with(
      "pins: [{corner: [-x, -z], until: 20, animate: {translate: [[5, [0, 1, 0]], [10, [0, 2, 0]]]}}]");
  const PinInput& pin = cloth.pins.at(0);
  EXPECT_EQ(pin.until, 2.0);
  ASSERT_TRUE(pin.motion);
  EXPECT_EQ(pin.motion->translate[1], (Track{{0.5, 1}, {1, 2}}));
  EXPECT_EQ(pin.motion->translate[0], (Track{{0.5, 0}, {1, 0}}));
}

TEST(Load, FindsTheColliderThatAPinFollowsAndTheFrameOfTheGrab) {
  const auto scene = load_text(
      "version: 1\ntime: {fps: 10}\ncloths: {a: {grid: {size: [2, 2], points: [3, 3]}, "
      "pins: [{vertices: [3], follow: hand, from: 5}]}}\n"
      "colliders: {table: {plane: {}}, hand: {sphere: {radius: 0.1}}}\n");
  const PinInput& pin = scene.cloths.at(0).input.pins.at(0);
  EXPECT_EQ(pin.collider, 1);
  EXPECT_EQ(pin.from, 0.5);
}

TEST(Load, LetsOnePinTakeOverFromAnother) {
  const ClothInput cloth = cloth_with("pins: [{vertices: [3], until: 5}, {vertices: [3, 4], from: 5}]");
  EXPECT_EQ(cloth.pins.size(), 2u);
}

TEST(Load, PairsTheVerticesOfASeam) {
  const auto scene = load_text(
      "version: 1\ntime: {fps: 10}\n"
      "cloths: {a: {grid: {size: [2, 2], points: [3, 3]}}, b: {grid: {size: [2, 2], points: [3, 3]}}}\n"
      "seams: [{between: [{cloth: b, edge: +x}, {cloth: a, edge: -z, reverse: true}], from: 5, close: "
      "20}]\n");
  const SeamInput& seam = scene.seams.at(0);
  EXPECT_EQ(seam.cloths, (std::array{1, 0}));
  EXPECT_EQ(seam.vertices[0], (std::vector{2, 5, 8}));
  EXPECT_EQ(seam.vertices[1], (std::vector{2, 1, 0}));
  EXPECT_EQ(seam.from, 0.5);
  EXPECT_EQ(seam.close, 2);
}

TEST(Load, ReadsEveryShape) {
  EXPECT_EQ(collider_with("plane: {y: 2}").motion.at.y(), 2);
  EXPECT_EQ(std::get<SphereShape>(collider_with("sphere: {radius: 30 cm}").shape).radius, 0.3);
  EXPECT_EQ(std::get<BoxShape>(collider_with("box: {size: [1, 2, 3]}").shape).size, Vec3(1, 2, 3));
  const auto cylinder =
      std::get<CylinderShape>(collider_with("cylinder: {radius: 9 cm, height: 2 cm}").shape);
  EXPECT_EQ(cylinder.radius, 0.09);
  EXPECT_EQ(cylinder.height, 0.02);
  const auto capsule = std::get<CapsuleShape>(collider_with("capsule: {radius: 1, length: 4}").shape);
  EXPECT_EQ(capsule.radius, 1);
  EXPECT_EQ(capsule.length, 4);
}

TEST(Load, ReadsTheMotionOfAColliders) {
  const RigidMotion motion = collider_with(
                                 "sphere: {radius: 1}, place: {at: [1, 2, 3], rotate: [0, 90, 0]}, "
                                 "animate: {rotate_y: [[1, 0], [11, 180 deg]]}")
                                 .motion;
  EXPECT_EQ(motion.at, Vec3(1, 2, 3));
  EXPECT_EQ(motion.rotate.y(), 90);
  EXPECT_EQ(motion.turn[1], (Track{{0.1, 0}, {1.1, 180}}));
}

TEST(Load, ReadsLooks) {
  const Look look =
      load_text(smallest_scene, {"cloths.a.look={color: '#ff0000', pattern: tartan, subdivide: 2}"})
          .cloths[0]
          .look;
  EXPECT_EQ(look.material.color, render::Color(1, 0, 0));
  EXPECT_EQ(look.material.back, render::Color(1, 0, 0));  // as the front
  EXPECT_EQ(look.material.pattern, render::Pattern::tartan);
  EXPECT_EQ(look.subdivide, 2);
}

TEST(Load, TakesShortColors) {
  const auto scene = load_text(smallest_scene, {"render.backdrop='#08f'"});
  EXPECT_EQ(scene.render.backdrop, render::Color(0, 136 / 255.0f, 1));
}

TEST(Load, DarkensTheLightsThatAreNotListed) {
  EXPECT_GT(load_text(smallest_scene).sun.intensity, 0);
  const auto scene = load_text(smallest_scene + "lights: [{sky: {intensity: 2}}]\n");
  EXPECT_EQ(scene.sun.intensity, 0);
  EXPECT_EQ(scene.sky.intensity, 2);
}

TEST(Load, AnOrbitIsThereWhereItIsGiven) {
  EXPECT_FALSE(load_text(smallest_scene).camera.orbit);
  const auto camera = load_text(smallest_scene + "camera: {orbit: {turns: 1}}\n").camera;
  ASSERT_TRUE(camera.orbit);
  EXPECT_EQ(camera.orbit->turns, 1);
}

TEST(Load, FindsMeshesFromTheCurrentFolder) {
  const TemporaryFolder folder;
  folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 0 -1\nf 1 2 3\n");
  folder.write("scene.yaml", "version: 1\ncloths: {a: {mesh: triangle.obj}}\n");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const auto scene = load_scene("scene.yaml");
  std::filesystem::current_path(before);
  EXPECT_EQ(scene.cloths.at(0).input.mesh.triangles.size(), 1u);
}

TEST(Load, ClothMayStartInAnotherShapeThanItHasAtRest) {
  const TemporaryFolder folder;
  folder.write("small.obj", "v 0 0 0\nv 1 0 0\nv 0 0 -1\nf 1 2 3\n");
  folder.write("large.obj", "v 0 0 0\nv 2 0 0\nv 0 0 -2\nf 1 2 3\n");
  folder.write("scene.yaml",
               "version: 1\ncloths: {a: {mesh: large.obj, rest: small.obj, place: {at: [0, 3, 0]}}}\n");
  const SceneDescription scene = load_scene((folder.path() / "scene.yaml").string());
  const ClothInput& cloth = scene.cloths.at(0).input;
  EXPECT_EQ(cloth.mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}));
  EXPECT_EQ(cloth.start_positions, (std::vector<Vec3>{{0, 3, 0}, {2, 3, 0}, {0, 3, -2}}));
}

TEST(Load, ASequenceOfMeshesIsACollidersShapeAtEachFrame) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "body");
  for (int i : {8, 9, 10})
    folder.write(fmt::format("body/b_{:02}.obj", i),
                 fmt::format("v 0 0 0\nv {} 0 0\nv 0 0 -1\nf 1 2 3\n", i));
  folder.write("body/b_x1.obj", "is not one of them");
  folder.write("scene.yaml",
               "version: 1\ntime: {fps: 20}\ncloths: {a: {grid: {size: [1, 1], points: [2, 2]}}}\n"
               "colliders: {b: {mesh: body/b_##.obj}}\n");
  const SceneDescription scene = load_scene((folder.path() / "scene.yaml").string());
  const auto& shape = std::get<MeshShape>(scene.colliders.at(0).input.shape);
  ASSERT_EQ(shape.shapes.size(), 3u);
  EXPECT_EQ(shape.shapes[2][1], Vec3(10, 0, 0));
  EXPECT_EQ(shape.mesh.positions, shape.shapes[0]);
  EXPECT_DOUBLE_EQ(shape.first_time, 0.4);
  EXPECT_DOUBLE_EQ(shape.interval, 0.05);
}

TEST(Load, OfAMissingSceneHasStatusThree) {
  const TemporaryFolder folder;
  const Failure failure = failure_of(folder.path() / "none.yaml", folder.path());
  EXPECT_EQ(failure.exit_status, 3);
  EXPECT_EQ(failure.words, "error: none.yaml: cannot be read: No such file or directory");
}

// A run of a few frames is quick, and most of what a scene must show comes later.
TEST(Load, TakesFactsOfFramesThatTheCommandLineCutsOff) {
  const std::string text =
      "time: {frames: 1-50}\n" + smallest_scene + "test: [{what: lowest, frames: 40-50, least: 0}]\n";
  EXPECT_EQ(load_text(text, {"time.frames=1-5"}).facts.at(0).first_frame, 40);
  EXPECT_EQ(load_text(text, {"time={frames: 1-5}"}).facts.size(), 1u);
  const std::string by_variable =
      "vars: {n: 1-50, last: 50}\n" + smallest_scene + "test: [{what: lowest, frames: 40-50, least: 0}]\n";
  for (const char* time : {"time: {frames: \"${n}\"}\n", "time: {frames: \"1-${last}\"}\n"})
    EXPECT_EQ(load_text(by_variable + time, {"vars.n=1-5", "vars.last=5"}).facts.size(), 1u) << time;
  EXPECT_NE(errors_of(by_variable + "time: {frames: 1-5}\n", {"vars.n=1-5"}).find("has frames 1-5"),
            std::string::npos);
  EXPECT_NE(errors_of(text, {"test.0.frames=51"}).find("-D test.0.frames=51: error: test[0].frames is 1-51"),
            std::string::npos);
}

TEST(Load, SaysNothingOfFactsWhereTheFramesOfTheSceneAreAMistake) {
  const std::string test = "test: [{what: lowest, frames: 100-150, least: 0}]\n" + smallest_scene;
  EXPECT_NE(errors_of(test).find("but the scene has frames 1-90"), std::string::npos);
  EXPECT_EQ(
      errors_of(test + "time: {frames: 0-200}\n"),
      "scene.yaml:4:16: error: time.frames must be `first-last` or a count, of frames from 1 to 100000, "
      "not `0-200`");
  EXPECT_EQ(errors_of(test + "time: 200\n"), "scene.yaml:4:7: error: time must be a map, not `200`");
}

TEST(Load, NamesWhoWantsAMeshThatIsBroken) {
  const TemporaryFolder folder;
  folder.write("bad.obj", "v 0 0 zero\n");
  folder.write("scene.yaml", "version: 1\ncloths: {a: {mesh: none.obj}}\n");
  const Failure failure = failure_of(folder.path() / "scene.yaml", folder.path(), {"cloths.a.mesh=bad.obj"});
  EXPECT_EQ(failure.exit_status, 3);
  EXPECT_EQ(failure.words,
            "bad.obj:1:7: error: 'zero' is not a number (cloths.a.mesh at -D cloths.a.mesh=bad.obj names "
            "this file)");
}

TEST(Load, HandsTheSimulationWhatItNeeds) {
  const auto input = simulation_input(load_text(smallest_scene + "time: {fps: 25, step: 1 ms}\n"));
  EXPECT_EQ(input.cloths.size(), 1u);
  EXPECT_EQ(input.frame_duration, 1.0 / 25);
  EXPECT_EQ(input.largest_step, 0.001);
}

}  // namespace drape

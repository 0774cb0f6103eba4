// Skinned surfaces of glTF files, read by the child.

#include <gtest/gtest.h>

#include "core/error.h"
#include "mesh/gltf_keys.h"
#include "mesh/mesh_file.h"
#include "mesh/skinned_gltf.h"

namespace drape {
namespace {

using test::SkinnedGltf;
using test::TemporaryFolder;

std::vector<std::vector<Vec3>> shapes_of(const SkinnedGltf& gltf, double interval = 0.5) {
  const TemporaryFolder folder;
  return read_clip(write(folder, gltf), {"bend", interval}).shapes;
}

// The words after the file's name.
std::string refusal(const SkinnedGltf& gltf, const std::string& clip = "bend") {
  const TemporaryFolder folder;
  try {
    read_clip(write(folder, gltf), {clip, 0.5});
    return "accepted";
  } catch (const UnknownClip& error) {
    return error.what();
  } catch (const InputError& error) {
    return error.problems().front().message;
  }
}

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-6) << a.transpose(); }

TEST(SkinnedClip, GoesWithItsJoints) {
  const auto shapes = shapes_of({});
  ASSERT_EQ(shapes.size(), 3u);
  for (const std::vector<Vec3>& shape : shapes) expect_near(shape[1], {1, 0, 0});
  expect_near(shapes[0][2], {0, 2, 0});
  expect_near(shapes[1][2], {-std::sqrt(0.5), 1 + std::sqrt(0.5), 0});
  expect_near(shapes[2][2], {-1, 1, 0});
}

// Its joints say where its points are.
TEST(SkinnedClip, DoesNotGoWithTheNodeOfItsMesh) {
  SkinnedGltf gltf;
  gltf.body = R"({"name":"body","mesh":0,"skin":0,"translation":[5,6,7],"scale":[3,3,3]})";
  EXPECT_EQ(shapes_of(gltf), shapes_of({}));
}

TEST(SkinnedClip, GrowsWithTheScaleOverItsJoints) {
  SkinnedGltf gltf;
  gltf.more_nodes = R"(,{"name":"armature","scale":[100,100,100],"translation":[0,0,1],"children":[0,2]})";
  gltf.roots = "3";
  const auto shapes = shapes_of(gltf), unscaled = shapes_of({});
  for (std::size_t s = 0; s < shapes.size(); ++s)
    for (std::size_t v = 0; v < shapes[s].size(); ++v)
      EXPECT_LT((shapes[s][v] - 100 * unscaled[s][v] - Vec3(0, 0, 1)).norm(), 1e-4);
}

// Exporters write a point twice where it has two texture coordinates.
TEST(SkinnedClip, IsJoinedAtTheSeamsOfItsTexture) {
  SkinnedGltf gltf;
  gltf.points = {{0, 0, 0}, {1, 0, 0}, {0.3f, 1.7f, 0.1f}, {0.3f, 1.7f, 0.1f}, {0, 0, 0}, {-1, 0, 0}};
  gltf.uvs = {{0, 0}, {0.4f, 0}, {0, 1}, {1, 1}, {1, 0}, {0.6f, 0}};
  gltf.joints.assign(6, {0, 1, 0, 0});
  gltf.weights.assign(6, {1, 0, 0, 0});
  gltf.weights[2] = gltf.weights[3] = {0.3f, 0.7f, 0, 0};
  gltf.corners = {0, 1, 2, 3, 5, 4};
  const TemporaryFolder folder;
  const MeshInShapes welded = weld(read_clip(write(folder, gltf), {"bend", 0.1}));
  EXPECT_EQ(welded.shapes.size(), 11u);
  EXPECT_EQ(welded.mesh.positions.size(), 4u);
  EXPECT_EQ(welded.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {2, 3, 0}}));
  EXPECT_EQ(welded.mesh.uv_triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 5, 4}}));
}

TEST(SkinnedClip, OfNoLengthIsOneShape) {
  SkinnedGltf gltf;
  gltf.times = {0};
  gltf.turns.erase(gltf.turns.begin());
  const auto shapes = shapes_of(gltf);
  ASSERT_EQ(shapes.size(), 1u);
  expect_near(shapes[0][2], {-1, 1, 0});
}

TEST(SkinnedClip, WithoutAClipIsPosedByItsJointsAtRest) {
  SkinnedGltf gltf;
  gltf.body = R"({"name":"body","mesh":0,"skin":0,"translation":[5,6,7]})";
  gltf.high = R"({"name":"high","translation":[0,1,0],"rotation":[0,0,1,0]})";
  const TemporaryFolder folder;
  const PolygonSoup still = read_polygons(write(folder, gltf));
  ASSERT_EQ(still.points.size(), 3u);
  expect_near(still.points[1], {1, 0, 0});
  expect_near(still.points[2], {0, 0, 0});  // upside down
}

TEST(SkinnedClip, WithWeightsThatTheImporterMisreadsIsRefused) {
  SkinnedGltf gltf;
  gltf.has_byte_weights = true;
  const std::string words = refusal(gltf);
  EXPECT_TRUE(words.starts_with("cannot be imported: the weights of bones for point ")) << words;
  EXPECT_TRUE(words.ends_with(", not 1: write the weights as floats, normalised")) << words;
}

TEST(SkinnedClip, WithWeightsThatDoNotSumUpToOneIsRefused) {
  SkinnedGltf gltf;
  gltf.weights[1] = {0.25f, 0.25f, 0, 0};
  EXPECT_EQ(
      refusal(gltf),
      "cannot be imported: the weights of bones for point 1 of its node 'body' sum up to 0.5, not 1: write "
      "the weights as floats, normalised");
  gltf.weights[1] = {0.45f, 0.5f, 0, 0};
  EXPECT_EQ(refusal(gltf), "accepted");
  gltf.weights[1] = {1.5f, -0.5f, 0, 0};  // negative ones are left out
  EXPECT_EQ(
      refusal(gltf),
      "cannot be imported: the weights of bones for point 1 of its node 'body' sum up to 1.5, not 1: write "
      "the weights as floats, normalised");
}

TEST(SkinnedClip, WithKeysThatAreNoTurnsIsRefused) {
  SkinnedGltf gltf;
  gltf.turns[1] = {0, 0, 0, 0.5f};
  EXPECT_EQ(
      refusal(gltf),
      "cannot be imported: a key of its node 'high' is no rotation: its quaternion has length 0.5, not 1; "
      "write the keys as floats");
  gltf.turns[1] = {0, 0, NAN, 1};
  EXPECT_EQ(refusal(gltf), "cannot be imported: a key of its node 'high' is not a number");
  gltf.turns[1] = {0, 0, 0, 1};
  gltf.times = {1, 0};
  EXPECT_EQ(refusal(gltf), "cannot be imported: the times of the keys of its node 'high' do not rise");
}

// Exporters have keys held (STEP) where all are equal.
TEST(SkinnedClip, WithKeysOnSplinesIsRefused) {
  SkinnedGltf gltf;
  gltf.interpolation = "CUBICSPLINE";
  EXPECT_EQ(refusal(gltf),
            "cannot be imported: the keys of its animations, or of some of them, are joined by cubic "
            "splines, which cannot be read: export them sampled at each frame, and linear");
  gltf.interpolation = "STEP";
  EXPECT_EQ(refusal(gltf), "accepted");
}

TEST(SplineKeys, AreFoundByTheirKeyword) {
  EXPECT_TRUE(has_spline_keys(R"({"interpolation":"LINEAR"},{"interpolation" :
    "CUBICSPLINE"})"));
  EXPECT_FALSE(has_spline_keys(R"({"interpolation":"LINEAR","name":"CUBICSPLINE"})"));
  EXPECT_FALSE(has_spline_keys(R"(["interpolation","CUBICSPLINE"])"));
  EXPECT_FALSE(has_spline_keys(R"("CUBICSPLINE")"));
  EXPECT_FALSE(has_spline_keys(""));
}

TEST(SkinnedClip, WithNodesThatCannotBeToldApartIsRefused) {
  SkinnedGltf gltf;
  gltf.body = R"({"name":"high","mesh":0,"skin":0})";
  const std::string words =
      "cannot be imported: 2 of its nodes are named 'high', which an animation or a skin refers to: give "
      "each a "
      "name of its own";
  EXPECT_EQ(refusal(gltf), words);
  gltf.animations.clear();
  const TemporaryFolder folder;
  EXPECT_THROW(read_polygons(write(folder, gltf)), InputError);  // a bone of that name
}

TEST(SkinnedClip, MayHaveNodesOfOneNameThatNothingRefersTo) {
  SkinnedGltf gltf;
  gltf.more_nodes = R"(,{"name":"body"},{"name":"body"})";
  gltf.roots = "0,2,3,4";
  EXPECT_EQ(refusal(gltf), "accepted");
}

TEST(SkinnedClip, MayHaveJointsWithoutNames) {
  SkinnedGltf gltf;
  gltf.low = R"({"children":[1]})";
  gltf.high = R"({"translation":[0,1,0]})";
  EXPECT_EQ(shapes_of(gltf), shapes_of({}));
}

TEST(SkinnedClip, WithJointsOutsideOfTheSceneIsRefused) {
  SkinnedGltf gltf;
  gltf.roots = "2";
  EXPECT_EQ(refusal(gltf), "cannot be imported: its bone 'low' is no node of the file's scene: put it there");
}

TEST(SkinnedClip, ThatHangsOnSeveralNodesIsRefused) {
  SkinnedGltf gltf;
  gltf.more_nodes = R"(,{"name":"twin","mesh":0,"skin":0})";
  gltf.roots = "0,2,3";
  EXPECT_EQ(
      refusal(gltf),
      "cannot be imported: its skinned mesh 'skin' hangs on several nodes: give each one a mesh of its own");
}

TEST(SkinnedClip, OfAnotherNameIsRefusedWithAListOfThoseThereAre) {
  SkinnedGltf gltf;
  gltf.animations = {"歩く", "", "run"};
  EXPECT_EQ(refusal(gltf), "has no animation 'bend'; it has '歩く' (0), '' (1), 'run' (2)");
  gltf.animations.assign(18, "run");
  const std::string words = refusal(gltf);
  EXPECT_TRUE(words.ends_with(", 'run' (15) and 2 more")) << words;
}

// Motion capture (BVH) says how long a frame is.
std::string bvh(const std::string& frame_time) {
  return "HIERARCHY\nROOT hips\n{\n OFFSET 0 0 0\n CHANNELS 3 Xposition Yposition Zposition\n End Site\n {\n "
         " "
         "OFFSET 0 1 0\n }\n}\nMOTION\nFrames: 2\nFrame Time: " +
         frame_time + "\n0 0 0\n1 0 0\n";
}

std::string bvh_refusal(const std::string& frame_time) {
  const TemporaryFolder folder;
  try {
    read_clip(folder.write("a.bvh", bvh(frame_time)), {"0", 0.5});
    return "accepted";
  } catch (const InputError& error) {
    return error.problems().front().message;
  }
}

TEST(SkinnedClip, OfNoSenseInTimeIsRefused) {
  EXPECT_EQ(bvh_refusal("0.04"), "accepted");
  EXPECT_EQ(
      bvh_refusal("-0.04"),
      "cannot be imported: its animation runs at -25 frames a second: write its frame rate into the file");
  EXPECT_EQ(
      bvh_refusal("0"),
      "cannot be imported: its animation runs at inf frames a second: write its frame rate into the file");
}

}  // namespace
}  // namespace drape

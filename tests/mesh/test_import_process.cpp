#include <fcntl.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/error.h"
#include "mesh/import_process.h"
#include "mesh/manifold.h"
#include "mesh/measure.h"
#include "mesh/mesh_bytes.h"
#include "mesh/mesh_file.h"
#include "mesh/primitives.h"
#include "temporary_folder.h"

namespace drape {
namespace {

using test::TemporaryFolder;

std::string stl_of(const TriangleMesh& mesh) {
  std::string text = "solid box\n";
  for (const Triangle& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int i : triangle) {
      const Vec3& p = mesh.positions[i];
      text += "vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) +
              "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

std::string refusal(const std::filesystem::path& path) {
  try {
    read_mesh(path);
    return "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.exit_status(), 3);
    return error.what();
  }
}

TEST(ImportProcess, StlComesInWelded) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read_mesh(folder.write("box.stl", stl_of(make_box({1, 2, 3}))));
  EXPECT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(check_manifold(mesh), std::vector<std::string>{});
  EXPECT_NEAR(test::volume(mesh), 6, 1e-6);
}

// One triangle whose points are in a file of their own, moved by (0, 0, 5).
std::string gltf_with_buffer(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
    "nodes":[{"mesh":0,"translation":[0,0,5]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
    "buffers":[{"uri":")" +
         uri + R"(","byteLength":36}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
}

std::string triangle_bytes() {
  const float points[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  return {reinterpret_cast<const char*>(points), sizeof points};
}

TEST(ImportProcess, GltfWithItsBufferBesideIt) {
  const TemporaryFolder folder;
  folder.write("parts/points.bin", triangle_bytes());
  const TriangleMesh mesh = read_mesh(folder.write("a.gltf", gltf_with_buffer("parts/points.bin")));
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 5}, {1, 0, 5}, {0, 1, 5}}));
}

TEST(ImportProcess, GltfMustNotLeaveItsFolder) {
  const TemporaryFolder folder;
  folder.write("secret.bin", triangle_bytes());
  const std::string words = refusal(folder.write("inside/a.gltf", gltf_with_buffer("../secret.bin")));
  EXPECT_NE(words.find("a.gltf: error: cannot be imported: "), words.npos) << words;
  EXPECT_NE(words.find("secret.bin, which is not a regular file in its own folder"), words.npos) << words;
  EXPECT_NE(refusal(folder.write("inside/b.gltf", gltf_with_buffer("/etc/passwd"))), "accepted");
  EXPECT_NE(refusal(folder.write("inside/c.gltf", gltf_with_buffer("../../../../../../etc/passwd"))),
            "accepted");
}

TEST(ImportProcess, LinksDoNotLeadOutOfTheFolder) {
  const TemporaryFolder folder;
  folder.write("secret.bin", triangle_bytes());
  const auto path = folder.write("inside/a.gltf", gltf_with_buffer("link.bin"));
  std::filesystem::create_symlink(folder / "secret.bin", folder / "inside/link.bin");
  EXPECT_NE(refusal(path), "accepted");
}

TEST(ImportProcess, DevicesAreNotOpened) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.gltf", gltf_with_buffer("zero.bin"));
  std::filesystem::create_symlink("/dev/zero", folder / "zero.bin");
  EXPECT_NE(refusal(path), "accepted");
}

TEST(ImportProcess, UnknownEnding) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.cloth", "anything");
  EXPECT_EQ(refusal(path),
            path.string() +
                ": error: cannot be imported: '.cloth' is the ending of no format of meshes that can "
                "be read; use .obj, .ply, .stl or .glb");
}

TEST(ImportProcess, GarbageIsRefused) {
  const TemporaryFolder folder;
  for (const char* name : {"a.stl", "a.glb", "a.fbx", "a.dae", "a.3ds", "a.blend", "a.off"})
    EXPECT_NE(refusal(folder.write(name, "garbage \x01\x02\xff")), "accepted") << name;
}

// The triangle, whose node goes from where it is to (0, 2, 5) in the second second of its animation.
std::string moving_gltf(const std::string& name = "go") {
  std::string text = gltf_with_buffer("points.bin");
  const auto insert = [&](const std::string& before, const std::string& what) {
    text.insert(text.find(before) + before.size(), what);
  };
  insert("\"buffers\":[", R"({"uri":"keys.bin","byteLength":32},)");
  insert("\"bufferViews\":[", R"({"buffer":0,"byteLength":8},{"buffer":0,"byteOffset":8,"byteLength":24},)");
  insert("\"accessors\":[",
         R"({"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR","min":[1],"max":[2]},
    {"bufferView":1,"componentType":5126,"count":2,"type":"VEC3"},)");
  insert("\"min\":[0,0,0],\"max\":[1,1,0]}]", R"(,"animations":[{"samplers":[{"input":0,"output":1}],
    "channels":[{"sampler":0,"target":{"node":0,"path":"translation"}}],"name":")" +
                                                  name + "\"}]");
  const auto renumber = [&](const std::string& what, const std::string& with) {
    text.replace(text.find(what), what.size(), with);
  };
  renumber("\"POSITION\":0", "\"POSITION\":2");
  renumber("{\"buffer\":0,\"byteOffset\":0,\"byteLength\":36}",
           "{\"buffer\":1,\"byteOffset\":0,\"byteLength\":36}");
  renumber("\"bufferView\":0,\"componentType\":5126,\"count\":3",
           "\"bufferView\":2,\"componentType\":5126,\"count\":3");
  return text;
}

std::string key_bytes() {
  const float keys[8] = {1, 2, 0, 0, 5, 0, 2, 5};
  return {reinterpret_cast<const char*>(keys), sizeof keys};
}

TEST(ImportedClip, NodesMoveBetweenTheirKeysAndRestOutside) {
  const TemporaryFolder folder;
  folder.write("points.bin", triangle_bytes());
  folder.write("keys.bin", key_bytes());
  const auto path = folder.write("a.gltf", moving_gltf());
  for (const char* name : {"go", "0"}) {
    const SoupInShapes clip = read_clip(path, {name, 0.5});
    ASSERT_EQ(clip.shapes.size(), 5u);  // 0 to 2 s
    for (int i = 0; i < 5; ++i)
      EXPECT_LT((clip.shapes[i][0] - Vec3(0, std::max(0, i - 2), 5)).norm(), 1e-6) << i;
    EXPECT_EQ(clip.soup.points, clip.shapes[0]);
  }
}

std::string clip_refusal(const std::filesystem::path& path, const std::string& name, double interval = 0.5) {
  try {
    read_clip(path, {name, interval});
    return "accepted";
  } catch (const UnknownClip& error) {
    return error.what();
  } catch (const InputError& error) {
    EXPECT_EQ(error.exit_status(), 3);
    return error.what();
  }
}

TEST(ImportedClip, IsRefusedInWordsWhereThereIsNone) {
  const TemporaryFolder folder;
  folder.write("points.bin", triangle_bytes());
  folder.write("keys.bin", key_bytes());
  const auto path = folder.write("a.gltf", moving_gltf("göhn")),
             still = folder.write("b.gltf", gltf_with_buffer("points.bin")),
             obj = folder.write("c.obj", test::square_obj);
  EXPECT_EQ(clip_refusal(path, "歩く"), "has no animation '歩く'; it has 'göhn' (0)");
  EXPECT_EQ(clip_refusal(path, "1"), "has no animation '1'; it has 'göhn' (0)");
  EXPECT_EQ(clip_refusal(still, "go"), "has no animation");
  EXPECT_EQ(clip_refusal(obj, "go"),
            "has no animation: files of its format hold none; use .glb, .fbx or .dae");
  EXPECT_EQ(clip_refusal(path, "göhn"), "accepted");
}

TEST(ImportedClip, OfTooManyPointsIsRefusedWithTheirNumbers) {
  const TemporaryFolder folder;
  folder.write("points.bin", triangle_bytes());
  folder.write("keys.bin", key_bytes());
  const auto path = folder.write("a.gltf", moving_gltf());
  EXPECT_EQ(
      clip_refusal(path, "go", 1e-9),
      path.string() +
          ": error: cannot be imported: its animation would be 2000000001 shapes of 3 points, over the "
          "most of 30000000 points in all: take fewer frames a second, a shorter clip or a simpler mesh");
}

// The eel lies straight along z at time 0, which is how it was modelled; then its joints bend it sideways.
TEST(ImportedClip, ASkinnedSurfaceIsDrawnAlongByItsJoints) {
  const std::filesystem::path eel = std::filesystem::path(DRAPE_SOURCE_DIR) / "scenes/meshes/eel.glb";
  const PolygonSoup modelled = read_polygons(eel);
  const SoupInShapes clip = read_clip(eel, {"swim", 0.25});
  ASSERT_EQ(clip.shapes.size(), 17u);
  for (std::size_t v = 0; v < modelled.points.size(); ++v)
    EXPECT_LT((clip.shapes[0][v] - modelled.points[v]).norm(), 1e-6);
  double most = 0;
  for (const std::vector<Vec3>& shape : clip.shapes) {
    EXPECT_LT((shape[0] - modelled.points[0]).norm(), 1e-6);  // the tail hangs on the joint that rests
    for (std::size_t v = 0; v < shape.size(); ++v)
      EXPECT_NEAR(shape[v].y(), modelled.points[v].y(), 1e-6);  // turns about the vertical
    most = std::max(most, std::abs(shape.back().x()));
  }
  EXPECT_GT(most, 0.05);
  EXPECT_EQ(check_manifold(weld(clip).mesh), std::vector<std::string>{});
}

// Each node is the child of the one before: assimp descends until its stack is full.
std::string gltf_of_nested_nodes(int count) {
  std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)";
  for (int i = 1; i < count; ++i) text += "{\"children\":[" + std::to_string(i) + "]},";
  return text + "{}]}";
}

TEST(ImportProcess, AFileThatCrashesTheImporter) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.gltf", gltf_of_nested_nodes(200000));
  EXPECT_TRUE(refusal(path).starts_with(path.string() + ": error: the importer ")) << refusal(path);
}

// Damaged binary PLY files are known to crash assimp 5.2.
TEST(ImportProcess, DamagedFilesAreReadOrRefused) {
  const TemporaryFolder folder;
  const std::string original = test::square_binary_ply(false);
  for (std::size_t at = 0; at < original.size(); at += 5) {
    std::string damaged = original;
    damaged[at] = static_cast<char>(damaged[at] + 1);
    const auto path = folder.write("a.ply", damaged);
    try {
      import_in_child(path, std::nullopt);
    } catch (const InputError& error) {
      EXPECT_EQ(error.exit_status(), 3);
    }
  }
}

TEST(ImportProcess, AChildDoesNotStartChildren) {
  const TemporaryFolder folder;
  const auto path = folder.write("box.stl", stl_of(make_box({1, 1, 1})));
  ::setenv("DRAPE_IMPORT_CHILD", "1", 1);
  EXPECT_THROW(read_mesh(path), FileError);
  ::unsetenv("DRAPE_IMPORT_CHILD");
}

TEST(ImportProcess, OtherProcessesAreNoChildren) {
  const char* const arguments[] = {"drape", "import-mesh", "a.stl"};
  EXPECT_FALSE(run_import_child(3, arguments));
  EXPECT_FALSE(run_import_child(1, arguments));
}

}  // namespace
}  // namespace drape

#include "app/mesh_sequence.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "temporary_folder.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class MeshSequenceFiles : public testing::Test {
 protected:
  std::vector<std::string> names(const std::vector<std::string>& inputs) {
    std::vector<std::string> result;
    for (const fs::path& file : open_mesh_sequence(inputs, "").files)
      result.push_back(file.filename().string());
    return result;
  }
  std::string path(const std::string& name) { return (folder / name).string(); }
  void write_all(const std::vector<std::string>& all) {
    for (const std::string& name : all) folder.write(name, triangle);
  }
  // What is wrong with a second file after a first one, or where a rest shape is named.
  std::string complaint(const std::string& second, const std::string& rest = "") {
    const std::string named = rest.empty() ? "" : folder.write("rest.obj", rest).string();
    const std::string a = folder.write("a.obj", triangle).string(),
                      b = folder.write("b.obj", second).string();
    try {
      const MeshSequence sequence = open_mesh_sequence({a, b}, named);
      read_mesh_frame(sequence, b);
    } catch (const InputError& error) {
      EXPECT_EQ(error.exit_status(), 3);
      return error.problems().front().file + ": " + error.problems().front().message;
    }
    return "";
  }

  test::TemporaryFolder folder;
};

using Names = std::vector<std::string>;

TEST_F(MeshSequenceFiles, OfAFolderComeInTheOrderOfTheirNumbers) {
  write_all({"f_10.obj", "f_9.obj", "f_0011.OBJ", "notes.txt", "f_2.ply.part"});
  EXPECT_EQ(names({folder.path().string()}), Names({"f_9.obj", "f_10.obj", "f_0011.OBJ"}));
}

TEST_F(MeshSequenceFiles, OfAPatternAreThoseThatFit) {
  write_all({"a.0001.obj", "a.0010.obj", "a.1.obj", "b.0002.obj"});
  EXPECT_EQ(names({path("a.####.obj")}), Names({"a.0001.obj", "a.0010.obj"}));
  EXPECT_EQ(names({path("a.%04d.obj")}), Names({"a.0001.obj", "a.1.obj", "a.0010.obj"}));
  EXPECT_EQ(names({path("*2.obj"), path("a.1.obj")}), Names({"b.0002.obj", "a.1.obj"}));
}

TEST_F(MeshSequenceFiles, ARestShapeAmongThemIsNoFrame) {
  write_all({"a.obj", "rest.obj"});
  const MeshSequence sequence = open_mesh_sequence({folder.path().string()}, "");
  EXPECT_EQ(sequence.files.size(), 1u);
  EXPECT_EQ(sequence.rest_file.filename(), "rest.obj");
  EXPECT_EQ(open_mesh_sequence({path("a.obj")}, "").rest_file.filename(), "rest.obj");
  EXPECT_EQ(open_mesh_sequence({path("a*.obj")}, "").rest_file.filename(), "rest.obj");
  EXPECT_EQ(open_mesh_sequence({path("a.obj")}, path("rest.obj")).rest_file.filename(), "rest.obj");
}

// Many a folder has a file of that name that is of something else.
TEST_F(MeshSequenceFiles, HaveNoRestShapeBesideThemThatDoesNotFit) {
  write_all({"a.obj", "b.obj"});
  for (const char* other : {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n", "v 0 zero 0\n"}) {
    folder.write("rest.obj", other);
    EXPECT_EQ(open_mesh_sequence({path("a*.obj"), path("b.obj")}, "").rest_file.filename(), "a.obj") << other;
    EXPECT_EQ(open_mesh_sequence({path("b.obj"), path("a.obj")}, "").rest_file.filename(), "b.obj") << other;
  }
  EXPECT_THROW(open_mesh_sequence({path("a.obj")}, path("rest.obj")), InputError);
  EXPECT_NE(complaint(triangle, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n")
                .find("b.obj: the corners of its faces are not those of " + path("rest.obj")),
            std::string::npos);
}

TEST_F(MeshSequenceFiles, AreErrorsWithAWayOutWhereThereAreNone) {
  const auto words = [&](const std::string& input) {
    try {
      open_mesh_sequence({input}, "");
    } catch (const FileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(words(folder.path().string()).find("name a scene, the folder of a run, or files of meshes"),
            std::string::npos);
  EXPECT_NE(words(path("a.##.obj")).find("no OBJ or PLY file fits this pattern"), std::string::npos);
  EXPECT_NE(words(path("missing.obj")).find("missing.obj"), std::string::npos);
}

TEST_F(MeshSequenceFiles, AreRefusedWhereTheirFacesDiffer) {
  const std::string more = complaint(triangle + "v 1 1 0\nf 2 4 3\n");
  EXPECT_NE(more.find(path("b.obj") + ": has 4 points and 2 faces, but " + path("a.obj") +
                      " has 3 points and 1 faces"),
            std::string::npos)
      << more;
  EXPECT_NE(more.find("name a rest shape of these faces with --rest"), std::string::npos);
  const std::string other = complaint("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n");
  EXPECT_NE(other.find("the corners of its faces are not those of " + path("a.obj")), std::string::npos)
      << other;
  const std::string lonely = complaint(triangle + "v 5 5 5\n");
  EXPECT_NE(lonely.find("has 4 points and 1 faces, but "), std::string::npos) << lonely;
  EXPECT_EQ(complaint(triangle), "");
}

TEST_F(MeshSequenceFiles, MayHaveCollidersAfterTheFacesAtRest) {
  const std::string rest = folder.write("rest.obj", triangle).string();
  const std::string more = "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 1\nf 4 5 6\nf 7 5 6\nf 4 5 7\n";
  const std::string file = folder.write("a.obj", triangle + more).string();
  const MeshFrame frame = read_mesh_frame(open_mesh_sequence({file}, rest), file);
  EXPECT_EQ(frame.surface.positions.size(), 3u);
  EXPECT_EQ(frame.surface.triangles, std::vector<Triangle>({{0, 1, 2}}));
  EXPECT_EQ(frame.colliders.positions.size(), 4u);
  EXPECT_EQ(frame.colliders.triangles, std::vector<Triangle>({{0, 1, 2}, {0, 1, 2}}));
}

TEST_F(MeshSequenceFiles, AreRefusedWithTheirLineWhereTheyAreNoMesh) {
  EXPECT_NE(complaint("v 0 zero 0\n").find("is not a number"), std::string::npos);
}

// Two triangles with four points along their common edge, as a seam of the texture splits them.
const std::string split = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 6 5\n";

TEST_F(MeshSequenceFiles, AreWeldedWherePointsAreTogetherAtRestAndNow) {
  const std::string rest = folder.write("rest.obj", split).string();
  const std::string together = folder.write("together.obj", split).string();
  std::string parted = split;
  parted.replace(parted.find("v 1 0 0\nv 0 1 0\nv 1 1"), 7, "v 1 0 9");
  const std::string apart = folder.write("apart.obj", parted).string();
  const MeshSequence sequence = open_mesh_sequence({together, apart}, rest);
  EXPECT_EQ(read_mesh_frame(sequence, together).surface.triangles,
            std::vector<Triangle>({{0, 1, 2}, {1, 5, 2}}));
  EXPECT_EQ(read_mesh_frame(sequence, apart).surface.triangles,
            std::vector<Triangle>({{0, 1, 2}, {3, 5, 2}}));
}

// What comes to lie on a point of its own surface touches it; the vertices stay two.
TEST_F(MeshSequenceFiles, AreNotWeldedWherePointsOnlyComeTogether) {
  const std::string rest =
      folder.write("rest.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\nf 4 5 6\n")
          .string();
  const std::string now =
      folder.write("now.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 1\nv 0 1 1\nf 1 2 3\nf 4 5 6\n")
          .string();
  const MeshSequence sequence = open_mesh_sequence({now}, rest);
  const CertifiedSurface certified = certify(read_mesh_frame(sequence, now).surface);
  EXPECT_EQ(certified.figures.intersecting_pairs, 1);
  EXPECT_EQ(certified.figures.smallest_gap, 0);
}

TEST_F(MeshSequenceFiles, AreToldFromScenesAndRuns) {
  folder.write("run.json", "{}");
  EXPECT_FALSE(names_meshes({folder.path().string()}));
  EXPECT_FALSE(names_meshes({"scene.yaml"}));
  EXPECT_TRUE(names_meshes({"a.obj"}));
  EXPECT_TRUE(names_meshes({"a.PLY"}));
  EXPECT_TRUE(names_meshes({"a.##.obj"}));
}

}  // namespace
}  // namespace drape::app

#include <gtest/gtest.h>

#include "core/error.h"
#include "mesh/mesh_bytes.h"
#include "mesh/mesh_file.h"
#include "mesh/primitives.h"
#include "temporary_folder.h"

namespace drape {
namespace {

using test::TemporaryFolder;

void expect_square(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
  ASSERT_EQ(mesh.uv_triangles.size(), 2u);
  for (std::size_t t = 0; t < 2; ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(mesh.uvs[mesh.uv_triangles[t][k]], mesh.positions[mesh.triangles[t][k]].head<2>());
}

TEST(MeshFile, SquareInEachFormat) {
  const TemporaryFolder folder;
  expect_square(read_mesh(folder.write("a.obj", test::square_obj)));
  expect_square(read_mesh(folder.write("B.OBJ", test::square_obj)));
  expect_square(read_mesh(folder.write("a.ply", test::square_ply)));
  expect_square(read_mesh(folder.write("little.ply", test::square_binary_ply(false))));
  expect_square(read_mesh(folder.write("big.ply", test::square_binary_ply(true))));
}

std::string with_dos_lines(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 2) text.replace(at, 1, "\r\n");
  return text;
}

TEST(MeshFile, DosLinesAndNoLastLineEnd) {
  const TemporaryFolder folder;
  expect_square(read_mesh(folder.write("a.obj", with_dos_lines(test::square_obj))));
  expect_square(read_mesh(folder.write("a.ply", with_dos_lines(test::square_ply))));
  expect_square(read_mesh(folder.write("b.obj", test::square_obj.substr(0, test::square_obj.size() - 1))));
  expect_square(read_mesh(folder.write("b.ply", test::square_ply.substr(0, test::square_ply.size() - 1))));
}

TEST(MeshFile, ObjStatementsThatDoNotMatter) {
  const TemporaryFolder folder;
  expect_square(
      read_mesh(folder.write("a.obj",
                             "\xEF\xBB\xBF# comment\n\nmtllib a.mtl\no square\ng one two\ns off\n"
                             "v +0 0 0 # at the origin\nv 1 0 0 1.0\nv 1e0 1 0 0.5 0.5 0.5\nv\t0  1 0\n"
                             "vt 0\nvt 1 0 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nusemtl red\nl 1 2\n"
                             "f -4/-4/1 -3/-3/1 -2/-2/1 -1/-1/1 # the only one\n")));
}

TEST(MeshFile, ObjFacesMayComeFirst) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read_mesh(folder.write("a.obj", "f 1//1 2//1 3//1\nv 0 0 0\nv 1 0 0\nv 0 1 0"));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_TRUE(mesh.uvs.empty() && mesh.uv_triangles.empty());
}

TEST(MeshFile, ObjUvsOfSomeFacesOnlyAreDropped) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = read_mesh(
      folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nf 1/1 2/1 3/1\nf 3 2 4\n"));
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_TRUE(mesh.uvs.empty() && mesh.uv_triangles.empty());
}

TEST(MeshFile, PlyElementsThatDoNotMatter) {
  const TemporaryFolder folder;
  const TriangleMesh mesh =
      read_mesh(folder.write("a.ply",
                             "ply\nformat ascii 1.0\nobj_info x\nelement empty 1000000000\nelement face 1\n"
                             "property list uchar int vertex_index\nelement material 1\nproperty list int "
                             "float colours\nproperty int id\n"
                             "element vertex 3\nproperty list uchar int friends\nproperty double z\nproperty "
                             "double y\nproperty double x\n"
                             "end_header\n3 0 1 2\n2 0.5 0.5 7\n0 0 0 1\n1 9 0 0 2\n2 1 1 1 0 3\n"));
  EXPECT_EQ(mesh.positions, (std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}, {3, 0, 1}}));
  EXPECT_TRUE(mesh.uvs.empty() && mesh.uv_triangles.empty());
}

TEST(MeshFile, ObjRoundTripKeepsEveryFloat) {
  const TemporaryFolder folder;
  TriangleMesh mesh = make_grid({1, 1}, {9, 7});
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] =
        (mesh.positions[i] / 3.0 + Vec3(1e-7, 1.0 / (1.0 + double(i)), 1e5)).cast<float>().cast<double>();
  for (Vec2& uv : mesh.uvs) uv = uv.cast<float>().cast<double>();
  write_obj(folder / "new/a.obj", mesh);
  const TriangleMesh same = read_mesh(folder / "new/a.obj");
  ASSERT_EQ(same.positions.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    EXPECT_EQ(same.positions[i].cast<float>(), mesh.positions[i].cast<float>());
  for (std::size_t i = 0; i < mesh.uvs.size(); ++i)
    EXPECT_EQ(same.uvs[i].cast<float>(), mesh.uvs[i].cast<float>());
  EXPECT_EQ(same.triangles, mesh.triangles);
  EXPECT_EQ(same.uv_triangles, mesh.uv_triangles);
}

TEST(MeshFile, ObjWithoutTextureCoordinates) {
  const TemporaryFolder folder;
  const TriangleMesh mesh = make_box({1, 2, 3});
  write_obj(folder / "a.obj", mesh);
  const TriangleMesh same = read_mesh(folder / "a.obj");
  EXPECT_EQ(same.positions, mesh.positions);
  EXPECT_EQ(same.triangles, mesh.triangles);
  EXPECT_TRUE(same.uvs.empty());
}

TEST(MeshFile, WhatIsNoRegularFile) {
  const TemporaryFolder folder;
  EXPECT_THROW(read_mesh(folder / "missing.obj"), FileError);
  EXPECT_THROW(read_mesh(folder / "missing.stl"), FileError);
  EXPECT_THROW(read_mesh(folder.path()), FileError);
  std::filesystem::create_symlink("/dev/zero", folder / "endless.obj");
  EXPECT_THROW(read_mesh(folder / "endless.obj"), FileError);
}

}  // namespace
}  // namespace drape

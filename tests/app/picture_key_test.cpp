#include "app/picture_key.h"

#include <gtest/gtest.h>

#include <set>

#include "app/run_program.h"

namespace drape::app {
namespace {

render::Surface triangle() {
  render::Surface surface;
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  surface.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  surface.triangles = {{0, 1, 2}};
  return surface;
}

TEST(PictureKey, ChangesWithAllThatAPictureDependsOn) {
  const render::Surface plain = triangle();
  render::Surface moved = plain, colored = plain, one_sided = plain;
  moved.positions[2].z() = 1e-6f;
  colored.material.accent.x() = 0.5f;
  one_sided.two_sided = true;
  render::View exposed, low, dim;
  exposed.exposure = 2;
  low.ground.height = -1;
  dim.sky.intensity = 0.5f;
  const std::set<std::uint64_t> keys = {picture_key({plain}, {}, {}),
                                        picture_key({moved}, {}, {}),
                                        picture_key({colored}, {}, {}),
                                        picture_key({one_sided}, {}, {}),
                                        picture_key({plain, plain}, {}, {}),
                                        picture_key({plain}, exposed, {}),
                                        picture_key({plain}, low, {}),
                                        picture_key({plain}, dim, {}),
                                        picture_key({plain}, {}, {640, 360, 16})};
  EXPECT_EQ(keys.size(), 9u);
  EXPECT_TRUE(keys.contains(picture_key({triangle()}, {}, {})));
}

TEST(PictureOrigin, IsKeptBesideThePicture) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_origin(folder / "frame_0001.png"));
  write_origin(folder / "frame_0001.png", {1, 2, 0xffffffffffffffff});
  const auto origin = read_origin(folder / "frame_0001.png");
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->key, 1u);
  EXPECT_EQ(origin->build, 2u);
  EXPECT_EQ(origin->picture_hash, 0xffffffffffffffff);
  EXPECT_EQ(file_hash(folder / "frame_0001.png"), 0u);
}

}  // namespace
}  // namespace drape::app

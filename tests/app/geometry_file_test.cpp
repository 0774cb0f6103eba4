#include "app/geometry_file.h"

#include <gtest/gtest.h>

#include <cstring>

namespace drape::app {
namespace {

const TriangleMesh plain = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}};
const TriangleMesh textured = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {{0, 0}, {1, 0}, {0, 0.5}}, {{2, 1, 0}}};

std::vector<Vec3f> positions() { return {{0, 0, 0}, {0.1f, 0, 0}, {0, 16777217.0f / 3, 0}}; }

TEST(Obj, NamesEachPartAndCountsOn) {
  const std::string text = to_obj({{"a b", &plain, positions()}, {"c", &textured, positions()}});
  EXPECT_EQ(text,
            "o a_b\nv 0 0 0\nv 0.1 0 0\nv 0 5592405.5 0\nf 1 2 3\n"
            "o c\nv 0 0 0\nv 0.1 0 0\nv 0 5592405.5 0\nvt 0 0\nvt 1 0\nvt 0 0.5\nf 4/3 5/2 6/1\n");
}

TEST(Ply, HoldsTheFloatsThemselves) {
  const std::string text = to_ply({{"a", &plain, positions()}, {"b", &plain, positions()}});
  const std::size_t body = text.find("end_header\n") + 11;
  ASSERT_EQ(text.size(), body + 2 * (3 * 12 + 13));
  float number = 0;
  std::memcpy(&number, text.data() + body + 12, sizeof number);
  EXPECT_EQ(number, 0.1f);
  int corner = 0;
  std::memcpy(&corner, text.data() + body + 72 + 13 + 1, sizeof corner);
  EXPECT_EQ(corner, 3);
  EXPECT_NE(text.find("element vertex 6\n"), std::string::npos);
}

}  // namespace
}  // namespace drape::app

#include "app/picture_diff.h"

#include <gtest/gtest.h>

#include "app/run_program.h"
#include "core/error.h"
#include "render/png_file.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

render::Image gray_image(int width, int height) {
  return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), 100)};
}

// Two pictures of 100 pixels, of which one differs by `difference` in one channel.
class PictureDiff : public testing::Test {
 protected:
  void write_pair(int difference) {
    render::Image image = gray_image(10, 10);
    render::write_png(a, image);
    image.rgb[33] = static_cast<std::uint8_t>(image.rgb[33] + difference);
    render::write_png(b, image);
  }

  TemporaryFolder folder;
  fs::path a = folder / "a/picture.png";
  fs::path b = folder / "b/picture.png";
};

TEST_F(PictureDiff, EqualPicturesAreTheSame) {
  write_pair(0);
  const auto comparison = compare_pictures(a, b, {}, {});
  EXPECT_TRUE(comparison.same);
  EXPECT_EQ(comparison.figures, "largest 0/255, mean 0.0000/255, 0.000 % of the pixels over 1/255");
}

TEST_F(PictureDiff, ToleranceAndShareDecide) {
  write_pair(9);
  EXPECT_FALSE(compare_pictures(a, b, {}, {}).same);
  EXPECT_EQ(compare_pictures(a, b, {}, {}).figures,
            "largest 9/255, mean 0.0300/255, 1.000 % of the pixels over 1/255");
  EXPECT_TRUE(compare_pictures(a, b, {9, 0.0, ""}, {}).same);
  EXPECT_TRUE(compare_pictures(a, b, {1, 0.01, ""}, {}).same);
}

TEST_F(PictureDiff, OtherSizesDiffer) {
  write_pair(0);
  render::write_png(b, gray_image(10, 11));
  const auto comparison = compare_pictures(a, b, {}, {});
  EXPECT_FALSE(comparison.same);
  EXPECT_EQ(comparison.figures, "sizes differ: 10x10 and 10x11");
}

TEST_F(PictureDiff, ComparesFoldersByName) {
  write_pair(9);
  render::write_png(a.parent_path() / "another.png", gray_image(4, 4));
  EXPECT_THROW(compare(a.parent_path(), b.parent_path(), {}), FileError);
  render::write_png(b.parent_path() / "another.png", gray_image(4, 4));
  const auto comparisons = compare(a.parent_path(), b.parent_path(), {});
  ASSERT_EQ(comparisons.size(), 2u);
  EXPECT_TRUE(comparisons[0].same);
  EXPECT_FALSE(comparisons[1].same);
}

TEST_F(PictureDiff, WritesHeatMaps) {
  write_pair(200);
  const fs::path heat = folder / "heat";
  compare(a.parent_path(), b.parent_path(), {1, 0, heat.string()});
  const render::Image map = render::read_png(heat / "picture.png");
  EXPECT_EQ(map.rgb[0], 0);
  EXPECT_GT(map.rgb[33], 200);
}

TEST_F(PictureDiff, TheProgramSaysItByItsStatus) {
  write_pair(9);
  EXPECT_EQ(run_drape({"diff", a.string(), a.string()}).exit_status, 0);
  EXPECT_EQ(run_drape({"diff", a.string(), b.string()}).exit_status, 1);
  EXPECT_EQ(run_drape({"diff", a.string(), b.string(), "--share", "0.02"}).exit_status, 0);
  EXPECT_EQ(run_drape({"diff", a.string(), (folder / "none.png").string()}).exit_status, 3);
}

}  // namespace
}  // namespace drape::app

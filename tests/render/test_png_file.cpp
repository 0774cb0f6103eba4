#include <gtest/gtest.h>

#include <stdexcept>

#include "core/error.h"
#include "render/png_file.h"
#include "temporary_folder.h"

namespace drape::render {
namespace {

using drape::test::TemporaryFolder;

Image make_noise(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(width) * height)};
  std::uint32_t state = 1;
  for (std::uint8_t& value : image.rgb) {
    state = 1664525 * state + 1013904223;
    value = static_cast<std::uint8_t>(state >> 24);
  }
  return image;
}

TEST(PngFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {640, 360}}) {
    const Image image = make_noise(width, height);
    write_png(folder / "image.png", image);
    const Image read = read_png(folder / "image.png");
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(read.height, height);
    EXPECT_EQ(read.rgb, image.rgb);
  }
}

TEST(PngFile, EqualImagesMakeEqualFiles) {
  const TemporaryFolder folder;
  write_png(folder / "a.png", make_noise(64, 48));
  write_png(folder / "b.png", make_noise(64, 48));
  EXPECT_EQ(read_file(folder / "a.png"), read_file(folder / "b.png"));
}

TEST(PngFile, MakesTheFoldersThatAreMissing) {
  const TemporaryFolder folder;
  write_png(folder / "frames/of/scene/0001.png", make_noise(2, 2));
  EXPECT_EQ(read_png(folder / "frames/of/scene/0001.png").rgb, make_noise(2, 2).rgb);
}

TEST(PngFile, RefusesAnImageWithoutAllOfItsPixels) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_png(folder / "image.png", Image{2, 2, std::vector<std::uint8_t>(11)}),
               std::invalid_argument);
  EXPECT_THROW(write_png(folder / "image.png", Image{}), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "image.png"));
}

TEST(PngFile, NamesTheFileThatCannotBeWritten) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "image.png");
  try {
    write_png(folder / "image.png", make_noise(2, 2));
    FAIL() << "a folder was overwritten";
  } catch (const FileError& error) {
    EXPECT_NE(std::string(error.what()).find("image.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace drape::render

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/file.h"
#include "render/png_file.h"
#include "temporary_folder.h"

// Files that are not what they seem: each is refused with its name and libpng's words, or read; none may
// crash.
namespace drape::render {
namespace {

using drape::test::TemporaryFolder;

std::string whole_file(const TemporaryFolder& folder) {
  Image image{32, 24, std::vector<std::uint8_t>(3 * 32 * 24)};
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<std::uint8_t>(i * i / 7);
  write_png(folder / "whole.png", image);
  return read_file(folder / "whole.png");
}

std::string refusal(const std::filesystem::path& path) {
  try {
    read_png(path);
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

TEST(DamagedPng, EveryTruncationIsRefusedByName) {
  const TemporaryFolder folder;
  const std::string whole = whole_file(folder);
  const std::size_t end_chunk = 12;  // the pixels are whole without it
  for (std::size_t size = 0; size < whole.size() - end_chunk; size += 7) {
    const auto path = folder.write("cut.png", whole.substr(0, size));
    EXPECT_NE(refusal(path).find("cut.png: is not a whole PNG file: "), std::string::npos) << size;
  }
}

TEST(DamagedPng, FlippedBytesNeverCrash) {
  const TemporaryFolder folder;
  const std::string whole = whole_file(folder);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string damaged = whole;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    refusal(folder.write("flipped.png", damaged));
  }
}

TEST(DamagedPng, TextIsNoPng) {
  const TemporaryFolder folder;
  EXPECT_NE(refusal(folder.write("text.png", "not a picture at all")).find("is not a whole PNG file"),
            std::string::npos);
}

TEST(DamagedPng, MissingFileIsNamed) {
  const TemporaryFolder folder;
  EXPECT_NE(refusal(folder / "nowhere.png").find("nowhere.png: cannot be read"), std::string::npos);
}

// A header that asks for 60000 x 60000 pixels (with the checksum that belongs to it) must not be believed.
TEST(DamagedPng, HugeHeaderAsksForNoMemory) {
  const TemporaryFolder folder;
  std::string huge = whole_file(folder);
  const std::string header("\0\0\xEA\x60\0\0\xEA\x60\x08\x02\0\0\0\x0F\xB0\xE2\x15", 17);
  huge.replace(16, header.size(), header);
  EXPECT_NE(refusal(folder.write("huge.png", huge)).find("has 60000 x 60000 pixels"), std::string::npos);
}

}  // namespace
}  // namespace drape::render

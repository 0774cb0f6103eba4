#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "render/fixed_scenes.h"
#include "render/image_difference.h"
#include "render/png_file.h"
#include "render/rasterizer.h"

// Pictures of small fixed scenes against references that a person has looked at. Where the look is changed on
// purpose, DRAPE_UPDATE_GOLDEN=1 writes the references anew.
namespace drape::render::test {
namespace {

constexpr Settings golden_settings{320, 180, 8};

// Another class of processor differs by one step on a few pixels in ten thousand.
constexpr int tolerance = 1;
constexpr double allowed_share = 0.002;

std::filesystem::path reference_path(const std::string& name) {
  return std::filesystem::path(DRAPE_SOURCE_DIR) / "tests/render/golden" / (name + ".png");
}

bool look_the_same(const Image& a, const Image& b) {
  return compare_images(a, b, tolerance).share_over <= allowed_share;
}

Image draw(const FixedScene& scene) { return Rasterizer().draw(scene.surfaces, scene.view, golden_settings); }

// What a person needs to see what changed, beside the test's working folder.
void keep_evidence(const std::string& name, const Image& drawn, const Image& reference) {
  write_png("golden_failures/" + name + ".png", drawn);
  write_png("golden_failures/" + name + "_difference.png", heat_map(drawn, reference, 16));
}

class Golden : public testing::TestWithParam<FixedScene> {};
INSTANTIATE_TEST_SUITE_P(golden, Golden, testing::ValuesIn(fixed_scenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST_P(Golden, LooksAsItDid) {
  const std::string& name = GetParam().name;
  const Image drawn = draw(GetParam());
  if (std::getenv("DRAPE_UPDATE_GOLDEN")) write_png(reference_path(name), drawn);
  const Image reference = read_png(reference_path(name));
  const ImageDifference difference = compare_images(drawn, reference, tolerance);
  if (!look_the_same(drawn, reference)) keep_evidence(name, drawn, reference);
  EXPECT_LE(difference.share_over, allowed_share)
      << "largest " << difference.largest << "/255, mean " << difference.mean
      << "; see golden_failures/ in the folder of the build";
}

// A threshold that lets another scene through would let anything through.
TEST_P(Golden, LooksLikeNoOtherReference) {
  if (std::getenv("DRAPE_UPDATE_GOLDEN")) GTEST_SKIP() << "the references are being written";
  const Image drawn = draw(GetParam());
  for (const FixedScene& other : fixed_scenes()) {
    if (other.name == GetParam().name) continue;
    EXPECT_FALSE(look_the_same(drawn, read_png(reference_path(other.name)))) << other.name;
  }
}

// Nor may it let a change through that an eye would see: a fortieth more light, a picture moved by half a
// pixel.
TEST_P(Golden, NoticesSmallChanges) {
  const Image drawn = draw(GetParam());
  FixedScene brighter = GetParam();
  brighter.view.exposure *= 1.025f;
  EXPECT_FALSE(look_the_same(draw(brighter), drawn));
  FixedScene moved = GetParam();
  moved.view.camera.target.x() += 0.003f;
  EXPECT_FALSE(look_the_same(draw(moved), drawn));
}

}  // namespace
}  // namespace drape::render::test

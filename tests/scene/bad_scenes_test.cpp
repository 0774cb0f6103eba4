// Each scene in the folder `bad` has a mistake, and beside it, in a file of the same name that ends on
// .expected, the exit status and the exact words of the error.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "core/file.h"
#include "scene/scene_text.h"

namespace drape {
namespace fs = std::filesystem;

static fs::path bad_folder() { return fs::path(DRAPE_SOURCE_DIR) / "tests/scene/bad"; }

static std::vector<std::string> bad_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(bad_folder()))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

class BadScene : public testing::TestWithParam<std::string> {};

TEST_P(BadScene, IsRefusedWithTheseWords) {
  const Failure failure = failure_of(bad_folder() / (GetParam() + ".yaml"), bad_folder());
  const std::string found =
      "exit status " + std::to_string(failure.exit_status) + "\n" + failure.words + "\n";
  EXPECT_EQ(found, read_file(bad_folder() / (GetParam() + ".expected")));
}

INSTANTIATE_TEST_SUITE_P(Bad, BadScene, testing::ValuesIn(bad_scenes()),
                         [](const auto& instance) { return instance.param; });

TEST(BadScenes, AreMany) { EXPECT_GE(bad_scenes().size(), 24u); }

}  // namespace drape

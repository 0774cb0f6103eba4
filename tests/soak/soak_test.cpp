#include "soak/soak.h"

#include <gtest/gtest.h>

#include "soak/random_scene.h"
#include "temporary_folder.h"

namespace drape::soak {
namespace {

TEST(RandomScene, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(random_scene(7), random_scene(7));
  EXPECT_NE(random_scene(7), random_scene(8));
}

// `./dev soak` has hundreds.
TEST(Soak, EveryFrameOfSomeScenesIsCertified) {
  const test::TemporaryFolder folder;
  int started = 0;
  for (std::uint64_t seed = 1; started < 5; ++seed) {
    const Outcome outcome = soak_scene(seed, folder.path());
    EXPECT_EQ(outcome.fault, "") << "seed " << seed;
    started += outcome.frames > 0;
  }
}

}  // namespace
}  // namespace drape::soak

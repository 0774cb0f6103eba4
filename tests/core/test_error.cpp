#include <gtest/gtest.h>

#include "core/error.h"

namespace drape {
namespace {

TEST(Problem, InWords) {
  EXPECT_EQ(to_string(Problem{"a.yaml", 3, 7, "no such key"}), "a.yaml:3:7: error: no such key");
  EXPECT_EQ(to_string(Problem{"a.obj", 0, 0, "no faces"}), "a.obj: error: no faces");
  EXPECT_EQ(to_string(Problem{"", 0, 0, "no scene"}), "error: no scene");
}

TEST(InputError, TellsAllProblemsInTheirOrder) {
  const InputError error({{"b.yaml", 2, 1, "second"}, {"a.yaml", 1, 1, "first"}}, 3);
  EXPECT_STREQ(error.what(), "b.yaml:2:1: error: second\na.yaml:1:1: error: first");
  EXPECT_EQ(error.problems().size(), 2u);
  EXPECT_EQ(error.exit_status(), 3);
  EXPECT_EQ(InputError({}).exit_status(), 2);
}

TEST(FileError, NamesThePath) { EXPECT_STREQ(FileError("a/b", "is gone").what(), "a/b: is gone"); }

}  // namespace
}  // namespace drape

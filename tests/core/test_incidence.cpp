#include <gtest/gtest.h>

#include "core/incidence.h"

namespace drape {
namespace {

TEST(Incidence, ListsTheSlotsOfEachPointInOrder) {
  const Incidence incidence = build_incidence(4, {2, 0, 2, 3, 0, 2});
  EXPECT_EQ(incidence.begin, (std::vector<std::size_t>{0, 2, 2, 5, 6}));
  EXPECT_EQ(incidence.slots, (std::vector<int>{1, 4, 0, 2, 5, 3}));
}

}  // namespace
}  // namespace drape

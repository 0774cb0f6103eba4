#include "scene/suggestion.h"

#include <gtest/gtest.h>

namespace drape {

TEST(Suggestion, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("friction", "friction"), 0);
  EXPECT_EQ(edit_distance("frictoin", "friction"), 1);  // neighbours swapped
  EXPECT_EQ(edit_distance("colour", "color"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Suggestion, NamesTheNearestOrAll) {
  EXPECT_EQ(suggestion("colour", {"color", "back"}, "keys"), "; did you mean `color`?");
  EXPECT_EQ(suggestion("zzz", {"color", "back"}, "keys"), "; known keys: color, back");
  EXPECT_EQ(suggestion(std::string(100'000, 'a'), {"color"}, "keys"), "; known keys: color");
}

}  // namespace drape

#include "app/frame_range.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace drape::app {
namespace {

using Frames = std::vector<int>;

TEST(FrameRange, ReadsSingleFramesRangesAndStrides) {
  EXPECT_EQ(parse_frames("7", 1, 100), Frames({7}));
  EXPECT_EQ(parse_frames("3-5", 1, 100), Frames({3, 4, 5}));
  EXPECT_EQ(parse_frames("1-10x4", 1, 100), Frames({1, 5, 9}));
  EXPECT_EQ(parse_frames("1,5,9-12", 1, 100), Frames({1, 5, 9, 10, 11, 12}));
}

TEST(FrameRange, IsAscendingAndNamesEachFrameOnce) {
  EXPECT_EQ(parse_frames("9,3-5,4", 1, 100), Frames({3, 4, 5, 9}));
}

TEST(FrameRange, RefusesWhatIsNoList) {
  for (const char* text : {"", "a", "1-", "-3", "5-3", "1-5x0", "1,,2", "1-5x", "1.5", "99999999999"}) {
    EXPECT_THROW(parse_frames(text, 1, 100), InputError) << text;
  }
}

TEST(FrameRange, NamesTheFrameThatIsNotInTheScene) {
  try {
    parse_frames("50-101", 1, 100);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "error: frame 101 is not in the scene, whose frames are 1-100");
  }
}

TEST(Chunk, IsReadAndChecked) {
  EXPECT_EQ(parse_chunk("2/8").index, 2);
  EXPECT_EQ(parse_chunk("2/8").count, 8);
  for (const char* text : {"", "2", "0/8", "9/8", "a/b", "2/"})
    EXPECT_THROW(parse_chunk(text), InputError) << text;
}

TEST(Chunk, ChunksShareOutAllFramesInOrder) {
  const Frames frames = all_frames(3, 25);
  for (int count : {1, 2, 3, 7, 23, 40}) {
    Frames together;
    for (int index = 1; index <= count; ++index) {
      const Frames part = frames_of_chunk(frames, {index, count});
      together.insert(together.end(), part.begin(), part.end());
    }
    EXPECT_EQ(together, frames) << count;
  }
}

TEST(Resolution, BecomesYaml) {
  EXPECT_EQ(resolution_as_yaml("1280x720"), "[1280, 720]");
  for (const char* text : {"", "1280", "1280x", "x720", "1280*720"}) {
    EXPECT_THROW(resolution_as_yaml(text), InputError) << text;
  }
}

TEST(FrameRange, TakesStridesPastTheLargestNumber) {
  EXPECT_EQ(parse_frames("1-100x2147483647", 1, 100), Frames({1}));
}

}  // namespace
}  // namespace drape::app

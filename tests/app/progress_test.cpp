#include "app/progress.h"

#include <gtest/gtest.h>

namespace drape::app {
namespace {

ProgressState halfway() {
  ProgressState state;
  state.stage = "simulate";
  state.done = 60;
  state.total = 120;
  state.elapsed_seconds = 30;
  state.contacts = 345;
  return state;
}

TEST(Progress, WritesDurationsAsClocksDo) {
  EXPECT_EQ(format_duration(0.4), "0:00");
  EXPECT_EQ(format_duration(7), "0:07");
  EXPECT_EQ(format_duration(750), "12:30");
  EXPECT_EQ(format_duration(3725), "1:02:05");
}

TEST(Progress, NamesStageFrameContactsAndTimeLeft) {
  EXPECT_EQ(progress_text(halfway()), "simulate  60/120  345 contacts  0:30 left");
}

TEST(Progress, DoesNotCountWhatAnEarlierRunDid) {
  ProgressState state = halfway();
  state.before = 50;
  EXPECT_EQ(seconds_left(state), 180);
}

TEST(Progress, DoesNotGuessBeforeTheFirstFrame) {
  ProgressState state = halfway();
  state.done = 0;
  EXPECT_LT(seconds_left(state), 0);
  EXPECT_EQ(progress_text(state), "simulate  0/120  345 contacts");
}

TEST(Progress, ShowsTheTimeTakenAtTheEnd) {
  ProgressState state = halfway();
  state.done = 120;
  state.contacts = -1;
  EXPECT_EQ(progress_text(state), "simulate  120/120  0:30");
}

TEST(Progress, DrawsABarOfTheWidthAskedFor) {
  EXPECT_EQ(progress_bar(halfway(), 8), "[####....] " + progress_text(halfway()));
}

TEST(Progress, WritesOneJsonObjectALine) {
  EXPECT_EQ(progress_json(halfway()),
            R"({"stage":"simulate","done":60,"total":120,"elapsed":30.000,"left":30.000,"contacts":345})");
}

}  // namespace
}  // namespace drape::app

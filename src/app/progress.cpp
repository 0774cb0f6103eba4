#include "app/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace drape::app {

std::string format_duration(double seconds) {
  const long whole = std::lround(std::max(0.0, seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

double seconds_left(const ProgressState& state) {
  if (state.done <= state.before) return -1;
  return state.elapsed_seconds / (state.done - state.before) * (state.total - state.done);
}

static std::string time_text(const ProgressState& state) {
  if (state.done == state.total) return format_duration(state.elapsed_seconds);
  return state.done == state.before ? "" : format_duration(seconds_left(state)) + " left";
}

std::string progress_text(const ProgressState& state) {
  std::string text = fmt::format("{:<8}  {}/{}", state.stage, state.done, state.total);
  if (state.contacts >= 0) text += fmt::format("  {} contacts", state.contacts);
  const std::string time = time_text(state);
  return time.empty() ? text : text + "  " + time;
}

std::string progress_bar(const ProgressState& state, int width) {
  const int filled = state.total > 0 ? width * state.done / state.total : width;
  return fmt::format("[{:#<{}}{:.<{}}] {}", "", filled, "", width - filled, progress_text(state));
}

std::string progress_json(const ProgressState& state) {
  return fmt::format(R"({{"stage":"{}","done":{},"total":{},"elapsed":{:.3f},"left":{:.3f},"contacts":{}}})",
                     state.stage, state.done, state.total, state.elapsed_seconds,
                     std::max(0.0, seconds_left(state)), std::max(0, state.contacts));
}

Progress::Progress(const Console& console, const std::string& stage, int total, int before)
    : console_(console), shown_done_(before) {
  state_.stage = stage;
  state_.before = before;
  state_.done = before;
  state_.total = total;
}

// A bar stays where it was drawn last; what follows starts on a line of its own.
Progress::~Progress() {
  if (console_.progress == ProgressStyle::bar && shown_at_seconds_ >= 0) fmt::print(stderr, "\n");
}

void Progress::update(int done, int contacts) {
  state_.done = done;
  state_.contacts = contacts;
  state_.elapsed_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if (is_due()) show();
}

// Lines go to files that people read afterwards: one for each tenth of the work, or each ten seconds.
bool Progress::is_due() const {
  if (console_.progress == ProgressStyle::none) return false;
  if (state_.done == state_.total || console_.progress == ProgressStyle::json) return true;
  const double waited = state_.elapsed_seconds - shown_at_seconds_;
  if (console_.progress == ProgressStyle::bar) return waited >= 0.1;
  return waited >= 10 || (waited >= 1 && 10 * (state_.done - shown_done_) >= state_.total);
}

void Progress::show() {
  shown_at_seconds_ = state_.elapsed_seconds;
  shown_done_ = state_.done;
  switch (console_.progress) {
    case ProgressStyle::bar:
      fmt::print(stderr, "\r\033[K{}", progress_bar(state_, 24));
      break;
    case ProgressStyle::json:
      fmt::print(stderr, "{}\n", progress_json(state_));
      break;
    default:
      fmt::print(stderr, "{}\n", progress_text(state_));
      break;
  }
}

}  // namespace drape::app

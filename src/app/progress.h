#pragma once

#include <chrono>
#include <string>

#include "app/console.h"

namespace drape::app {

// How far a stage is.
struct ProgressState {
  std::string stage;  // "simulate"
  int before = 0;     // was done by an earlier run
  int done = 0;       // with what was done before
  int total = 0;
  double elapsed_seconds = 0;
  int contacts = -1;  // -1: the stage has none
};

// "0:07", "12:30", "1:02:05".
std::string format_duration(double seconds);

// The time that the rest takes if it goes on as so far; negative while that is not known.
double seconds_left(const ProgressState& state);

std::string progress_text(const ProgressState& state);  // "simulate  12/120  345 contacts  0:30 left"
std::string progress_bar(const ProgressState& state, int width);
std::string progress_json(const ProgressState& state);

// Shows on stderr how far a stage is, in the console's style, and no more often than is of use.
class Progress {
 public:
  Progress(const Console& console, const std::string& stage, int total, int before = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void update(int done, int contacts = -1);

 private:
  using Clock = std::chrono::steady_clock;
  bool is_due() const;
  void show();

  Console console_;
  ProgressState state_;
  Clock::time_point start_ = Clock::now();
  double shown_at_seconds_ = -1e9;
  int shown_done_ = 0;
};

}  // namespace drape::app

#pragma once

#include <chrono>

#include "app/manifest.h"
#include "core/profile.h"

namespace drape::app {

// Adds the time of a stage to its record, when the stage ends in whatever way.
class StageTimer {
 public:
  explicit StageTimer(StageTiming& timing) : timing_(timing) {}
  ~StageTimer() {
    timing_.wall_seconds += std::chrono::duration<double>(Clock::now() - start_).count();
    timing_.cpu_seconds += process_cpu_seconds() - cpu_start_;
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  StageTiming& timing_;
  Clock::time_point start_ = Clock::now();
  double cpu_start_ = process_cpu_seconds();
};

}  // namespace drape::app

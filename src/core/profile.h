#pragma once

#include <array>
#include <cstddef>
#include <ctime>
#include <string_view>

namespace drape {

// The phases whose cost a run reports.
enum class Phase { elastic, broad, narrow, response, fail_safe, other };
inline constexpr std::array<std::string_view, 6> phase_names = {"elastic",  "broad",     "narrow",
                                                                "response", "fail_safe", "other"};

// CPU seconds of the whole process by phase (all threads, so a parallel phase counts what it cost, not how long
// it took).
struct Profile {
  std::array<double, phase_names.size()> cpu_seconds{};
  double& operator[](Phase phase) { return cpu_seconds[static_cast<std::size_t>(phase)]; }
};

inline double process_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Adds the CPU time between its construction and its destruction to one phase.
class PhaseTimer {
 public:
  PhaseTimer(Profile& profile, Phase phase) : total_(profile[phase]), start_(process_cpu_seconds()) {}
  ~PhaseTimer() { total_ += process_cpu_seconds() - start_; }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& total_;
  double start_;
};

}  // namespace drape

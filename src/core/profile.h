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

// CPU seconds of the whole process by phase (all threads, so a parallel phase counts what it cost, not how
// long it took).
struct Profile {
  std::array<double, phase_names.size()> cpu_seconds{};
  double& operator[](Phase phase) { return cpu_seconds[static_cast<std::size_t>(phase)]; }
};

inline double process_cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Runs work() and adds the CPU time that it took to one phase.
template <typename Work>
auto timed(Profile& profile, Phase phase, const Work& work) {
  struct Timer {
    double& total;
    double start = process_cpu_seconds();
    ~Timer() { total += process_cpu_seconds() - start; }
  } timer{profile[phase]};
  return work();
}

}  // namespace drape

#pragma once

#include <ctime>
#include <string>
#include <vector>

namespace drape::bench {

// The processor's name, its cores, the compiler, and how many programs the machine was running.
std::string machine_name();

inline double clock_seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}
// CPU time of this thread alone: other programs on the machine do not count.
inline double thread_seconds() { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); }
inline double wall_seconds() { return clock_seconds(CLOCK_MONOTONIC); }

template <typename... Items>
std::size_t bytes_of(const std::vector<Items>&... vectors) {
  return (std::size_t{0} + ... + (vectors.size() * sizeof(Items)));
}

}  // namespace drape::bench

// Random scenes from seeds, every frame judged: soak FOLDER [COUNT [FIRST]]. The scenes go into the folder.
// Exit status as of drape itself: 4 where a scene failed, 3 where the folder cannot be written.

#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include "core/memory.h"
#include "core/profile.h"
#include "soak/soak.h"

namespace drape::soak {

static void print_row(std::uint64_t seed, const Outcome& outcome, double seconds) {
  const std::string verdict = !outcome.fault.empty() ? "FAILED: " + outcome.fault
                              : outcome.frames == 0  ? "left out: starts through something"
                                                     : "certified";
  fmt::print("{:6} {:7} {:7} {:9.3f} {:8.3f} {:10} {:7.1f}  {}\n", seed, outcome.points, outcome.frames,
             outcome.largest_stretch, 1000 * outcome.smallest_gap, outcome.held_back, seconds, verdict);
  std::fflush(stdout);
}

static int report(int certified, const std::vector<std::uint64_t>& failed, const std::string& folder) {
  fmt::print("{} scenes certified in every frame, {} failed\n", certified, failed.size());
  for (const std::uint64_t seed : failed)
    fmt::print("repeat it with: ./dev soak 1 {0}    its scene: {1}/soak_{0}.yaml\n", seed, folder);
  return failed.empty() ? 0 : 4;
}

// Goes on until `count` scenes have started.
static int soak(const std::string& folder, int count, std::uint64_t first) {
  fmt::print("  seed  points  frames   stretch   gap/mm  held back   CPU s\n");
  std::vector<std::uint64_t> failed;
  int certified = 0;
  for (std::uint64_t seed = first; certified + static_cast<int>(failed.size()) < count; ++seed) {
    const double begin = process_cpu_seconds();
    const Outcome outcome = soak_scene(seed, folder);
    print_row(seed, outcome, process_cpu_seconds() - begin);
    if (!outcome.fault.empty())
      failed.push_back(seed);
    else if (outcome.frames > 0)
      ++certified;
  }
  return report(certified, failed, folder);
}

}  // namespace drape::soak

int main(int count, char** arguments) {
  if (count < 2) {
    fmt::print(stderr, "usage: soak FOLDER [COUNT [FIRST]]\n");
    return 2;
  }
  drape::keep_freed_memory();
  try {
    return drape::soak::soak(arguments[1], count > 2 ? std::atoi(arguments[2]) : 200,
                             count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 1);
  } catch (const std::exception& error) {
    fmt::print(stderr, "soak: {}\n", error.what());
    return 3;
  }
}

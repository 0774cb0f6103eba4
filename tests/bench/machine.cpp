#include "machine.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace drape::bench {

static std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "an unnamed processor";
}

std::string machine_name() {
  double load = 0;
  const bool known = getloadavg(&load, 1) == 1;
  return fmt::format("{}, {} cores, compiler {}, load {}", processor_name(),
                     std::thread::hardware_concurrency(), __VERSION__,
                     known ? fmt::format("{:.1f}", load) : "unknown");
}

}  // namespace drape::bench

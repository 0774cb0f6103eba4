#include "machine.h"

#include <fmt/format.h>

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
  return fmt::format("{}, {} cores, compiler {}", processor_name(), std::thread::hardware_concurrency(),
                     __VERSION__);
}

}  // namespace drape::bench

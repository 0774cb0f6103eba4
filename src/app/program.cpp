#include "app/program.h"

#include "core/file.h"
#include "core/hash.h"

namespace drape::app {

std::string program_version() { return DRAPE_VERSION; }

std::uint64_t program_build() {
  const std::string program = read_file("/proc/self/exe");
  return hash_bytes(program.data(), program.size());
}

}  // namespace drape::app

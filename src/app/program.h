#pragma once

#include <cstdint>
#include <string>

namespace drape::app {

std::string program_version();

// A hash of the running program itself. Results of another build may differ from this one's, even where its
// version number is the same.
std::uint64_t program_build();

}  // namespace drape::app

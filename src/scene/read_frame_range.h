#pragma once

#include "scene/section.h"

namespace drape {

// Reads "first-last", or a count from 1, into both; leaves them where the key is not there or is a mistake.
void read_frame_range(const Section& section, std::string_view name, int& first, int& last);

}  // namespace drape

#pragma once

#include <vector>

#include "scene/section.h"

namespace drape {

// The key `vertices` of the section, a list of numbers from 0 to `count` - 1, in the order of the text.
std::vector<int> read_vertices(const Section& section, int count);

}  // namespace drape

#pragma once

#include <string>
#include <vector>

#include "scene/node.h"
#include "scene/problem_list.h"

namespace drape {

// Puts the value of "key.path=value" into the tree, where the path leads: through maps by key, making those
// that are missing, and through lists by number, from 0. Problems are placed at "-D key.path=value".
void apply_override(const std::string& text, Node& root, ProblemList& problems);

}  // namespace drape

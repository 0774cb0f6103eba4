#pragma once

#include "scene/node.h"
#include "scene/problem_list.h"

namespace drape {

// Takes the key `vars` out of the tree and puts its values where "${name}" stands: a scalar that is just that
// becomes the value, whatever it is; inside of a longer text, the value must be a scalar. A variable may use
// those above it.
void substitute_variables(Node& root, ProblemList& problems);

}  // namespace drape

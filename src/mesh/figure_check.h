#pragma once

#include "mesh/figure.h"

namespace drape {

// Throws std::runtime_error, in words for the user, where values cannot be meant: times that fall, keys that
// are no numbers, turns that are none, and shares of a point that do not sum up to about 1. assimp 5.2 leaves
// memory unset where glTF has weights or turns as normalised integers.
void check_figure(const Figure& figure);

}  // namespace drape

#pragma once

#include <vector>

#include "deformation/sheet.h"

namespace drape {

// Of each connected piece (`piece_of` each vertex, as connected_pieces numbers them): whether its rest shape
// lies in a plane within a convex outline. There the shortest way between two points is straight.
std::vector<char> convex_pieces(const Sheet& sheet, const std::vector<int>& piece_of);

}  // namespace drape

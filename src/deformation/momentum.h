#pragma once

#include <vector>

#include "core/vector.h"

namespace drape {

// The points of one connected piece of cloth that nothing pins.
struct FreePiece {
  std::vector<int> vertices;
};

// Elastic pulls keep angular momentum about the positions that they see, x*, not about those at the step's
// start, and so lose a few percent in ten seconds. A step from x0 to x1 has the angular momentum sum m x0 x
// x1 / h (equal about x0 and about x1), which is linear in x1: the piece gets back exactly what it lost by
//   x1 += w x (x0 - c),   w = I^-1 sum m (x0 - c) x (x* - x1).
void restore_angular_momentum(const FreePiece& piece, const std::vector<double>& masses,
                              const std::vector<Vec3>& start, const std::vector<Vec3>& before_pull,
                              std::vector<Vec3>& x);

}  // namespace drape

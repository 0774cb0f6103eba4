#pragma once

#include <vector>

#include "core/vector.h"

namespace drape {

// The points of one connected piece of cloth that nothing pins.
struct FreePiece {
  std::vector<int> vertices;
};

// Elastic pulls keep linear momentum to the digits of float, and angular momentum about the positions that
// they see, which are not those that the step started from: a few percent are lost in ten seconds. The piece
// gets back exactly what it lost: its momenta at the end (x1, v1) become those at the start (x0, v0) with the
// impulse and the torque, about the centre of mass, of the accelerations a over the step; its centre of mass
// goes its own way too.
void restore_momenta(const FreePiece& piece, const std::vector<double>& masses, const std::vector<Vec3>& x0,
                     const std::vector<Vec3>& v0, const std::vector<Vec3>& a, double step,
                     std::vector<Vec3>& x1, std::vector<Vec3>& v1);

}  // namespace drape

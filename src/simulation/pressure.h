#pragma once

#include <vector>

#include "deformation/sheet.h"
#include "simulation/input.h"

namespace drape {

// The pressure in Pa along the normal of each triangle, so that a cloth's pressure pushes outward whichever
// way its triangles turn. Empty where no cloth has any. A cloth that has must be closed.
std::vector<double> triangle_pressures(const std::vector<ClothInput>& cloths);

// The pressure in Pa at which a sphere of the same area and material grows to twice its radius. Over twice as
// much, a membrane whose tension grows with its strain holds at no size: p = 2 k (1/R0 - 1/R) < 2 k / R0.
double doubling_pressure(const ClothInput& cloth);

}  // namespace drape

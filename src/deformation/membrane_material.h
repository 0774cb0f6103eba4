#pragma once

#include <array>

#include "deformation/sheet.h"

namespace drape {

// What a triangle's membrane stores per area is 1/2 e^T C e, with the strains e = (along its first axis,
// across, angle of shear). C in N/m, in axes of which `warp` (a unit vector) is the material's warp
// direction.
Mat3 membrane_tensor(const ElasticMaterial& material, const Vec2& warp);

// The same for bending: 1/2 k^T D k with the curvatures k = (along, across, twice the twist), D in N m.
Mat3 bending_tensor(const ElasticMaterial& material, const Vec2& warp);

// In N/m, of a strip along the unit direction d that is free at its sides: 1 / (d^T C^-1 d). Takes C^-1.
double strip_stiffness(const Mat3& compliance, const Vec2& direction);

// A membrane as bars along three directions and what is left of it.
struct BarSplit {
  std::array<double, 3> bars;  // N/m: each bar stores 1/2 bars[i] (strain along direction i)2 per area
  Mat3 rest;                   // C less the bars: positive definite
};

// The largest share of a membrane that bars along the three unit directions can carry: each bar in the
// proportion of the membrane's own stiffness along it, 1 / (d^T C^-1 d). With bars along warp and weft of a
// fabric that shears easily, the bars carry nearly all stretch, and the triangle the shear.
BarSplit split_into_bars(const Mat3& tensor, const std::array<Vec2, 3>& directions);

}  // namespace drape

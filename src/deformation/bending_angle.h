#pragma once

#include <array>
#include <vector>

#include "core/vector.h"

namespace drape {

// The angle theta between two triangles with an edge in common, 0 where they are flat, as Bridson, Marino and
// Fedkiw 2003 (BMF03) measure it: x1 and x2 are across the edge from x3 to x4.
struct BendingAngle {
  double half_sine;               // sin(theta / 2), in [-1, 1]
  std::array<Vec3, 4> gradients;  // of theta, 1/m
};

// The gradients are -u_i of BMF03, section 4: the one motion of the four points that is orthogonal to rigid
// motion and to every change of the five edges. Both are zero where a triangle has collapsed to a line. theta
// jumps from pi to -pi where the triangles pass through each other.
BendingAngle bending_angle(const std::array<int, 4>& vertices, const std::vector<Vec3>& x);

}  // namespace drape

#pragma once

// A Number is a double, or the DoubleLanes of four plates side by side: the same bits either way.

#include "core/double_lanes.h"
#include "simulation/input.h"

namespace drape {

// Each product is rounded: no fused multiply-adds, unlike in the dot and cross of lanes.h, since the double
// of the slow twin has none.
template <typename Number>
Number inner_product(const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

template <typename Number>
LaneVec3<Number> cross_product(const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// The force (N) of air that streams past a flat plate with the velocity u (m/s), at the angle a to its plane:
//   1/2 rho A |u|2 (C_D sin a n + C_T cos a t + C_L sin a cos a l),
// n and t along the parts of u across and along the plate, l at right angles to u; the vector `area` (m2) is
// A long, along n. The first two terms are pressure and skin friction (Hoerner 1965, Fluid-Dynamic Drag,
// chapters 2 and 3), the third is the lift of Keckeisen et al. 2004 (Interactive Animation of Cloth including
// Self Collision Detection). It is the same for either direction of the normal, and goes to zero smoothly
// with u.
template <typename Number>
LaneVec3<Number> force_of_air(const WindInput& wind, const LaneVec3<Number>& u,
                              const LaneVec3<Number>& area) {
  constexpr double air_density = 1.2;  // kg/m3, at 20 degrees Celsius and sea level
  const Number size = square_root(inner_product(area, area)), speed = square_root(inner_product(u, u));
  const LaneVec3<Number> normal = {area.x / size, area.y / size, area.z / size};
  const Number across = inner_product(normal, u);
  const LaneVec3<Number> across_plate = across * normal;
  const LaneVec3<Number> pressure = Number(wind.drag * across) * normal;
  const LaneVec3<Number> friction = Number(wind.tangential_drag) * (u - across_plate);
  const LaneVec3<Number> lift =
      Number(wind.lift) * (across_plate - Number(across * across / (speed * speed)) * u);
  const LaneVec3<Number> force = Number(0.5 * air_density * size * speed) * (pressure + friction + lift);
  const auto where_defined = [&](const Number& f) {
    return where_positive(size, Number(where_positive(speed, f, 0.0)), 0.0);
  };
  return {where_defined(force.x), where_defined(force.y), where_defined(force.z)};
}

// The same over all the steps that the force will last, `duration` seconds, cut as an implicit step cuts a
// linear drag. With f the force, u the relative velocity and m the triangle's mass, which makes a third of
// the mass at its corners,
//   sum m |v - w|2 <= before - sum (2 h f.u - h2 |f|2 / m)
// by Cauchy's inequality at each point, and the cut keeps h |f|2 / m under f.u.
template <typename Number>
LaneVec3<Number> lasting_force(const LaneVec3<Number>& force, const LaneVec3<Number>& u, const Number& mass,
                               double duration) {
  const Number power = inner_product(force, u);
  const Number cut =
      where_positive(power, Number(power / (power + duration * inner_product(force, force) / mass)), 0.0);
  return cut * force;
}

}  // namespace drape

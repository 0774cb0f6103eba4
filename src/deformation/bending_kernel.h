#pragma once

#include "deformation/bending.h"
#include "deformation/membrane_kernel.h"

// The arithmetic of bending.h for one tile of rows, as eight lanes (Number = Lanes) or one of them (float),
// in phases as in membrane_kernel.h.
namespace drape {

template <typename Number>
struct BendingPoints {
  TrianglePoints<Number> own, outer;
};
template <typename Number>
struct Residuals {
  LaneVec3<Number> r1, r2, r3;
};
// Where the outer corners lie, in the affine coordinates of the own ones.
template <typename Number>
struct OuterCoordinates {
  Number s1, s2, s3, t1, t2, t3;
};
template <typename Number>
struct LowerRoot {
  Number l11, l21, l22, l31, l32, l33;
};

template <typename Number>
OuterCoordinates<Number> load_coordinates(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {access.load(rows[0]), access.load(rows[1]), access.load(rows[2]),
          access.load(rows[3]), access.load(rows[4]), access.load(rows[5])};
}
template <typename Number>
LowerRoot<Number> load_root(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {access.load(rows[0]), access.load(rows[1]), access.load(rows[2]),
          access.load(rows[3]), access.load(rows[4]), access.load(rows[5])};
}

// x_j - x_a - s_j (x_b - x_a) - t_j (x_c - x_a), from x_j - x_a and the triangle's edges.
template <typename Number>
Residuals<Number> residuals_of(const TriangleEdges<Number>& own, const LaneVec3<Number>& x1,
                               const LaneVec3<Number>& x2, const LaneVec3<Number>& x3,
                               const OuterCoordinates<Number>& where) {
  const auto& [e1, e2] = own;
  return {subtract_product(where.t1, e2, subtract_product(where.s1, e1, x1)),
          subtract_product(where.t2, e2, subtract_product(where.s2, e1, x2)),
          subtract_product(where.t3, e2, subtract_product(where.s3, e1, x3))};
}

template <typename Number>
Residuals<Number> load_residuals(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {load_vector(access, rows), load_vector(access, rows + 3), load_vector(access, rows + 6)};
}
template <typename Number>
Residuals<Number> operator+(const Residuals<Number>& a, const Residuals<Number>& b) {
  return {a.r1 + b.r1, a.r2 + b.r2, a.r3 + b.r3};
}

template <typename Number>
[[gnu::flatten]] void load_bending_row(const BendingStage& stage, const SplitPoints& start, std::size_t row,
                                       const LaneAccess<Number>& access, LaneRow* base) {
  const IndexRow* corners = &stage.corners[6 * row];
  const OuterCoordinates<Number> where = load_coordinates(access, &stage.coordinates[coordinate_rows * row]);
  const SplitPoint<Number> a = gather(access, start, corners[0]);
  const TriangleEdges<Number> own{gather(access, start, corners[1]) - a,
                                  gather(access, start, corners[2]) - a};
  const Residuals<Number> residuals =
      residuals_of(own, gather(access, start, corners[3]) - a, gather(access, start, corners[4]) - a,
                   gather(access, start, corners[5]) - a, where);
  store_vector(access, residuals.r1, base);
  store_vector(access, residuals.r2, base + 3);
  store_vector(access, residuals.r3, base + 6);
  if (!stage.curved) return;
  store_vector(access, own.e1, base + 9);
  store_vector(access, own.e2, base + 12);
}

template <typename Number>
Residuals<Number> residuals_of(const BendingPoints<Number>& points, const OuterCoordinates<Number>& where) {
  const LaneVec3<Number>& a = points.own.a.p;
  return residuals_of(edges_of(points.own), points.outer.a.p - a, points.outer.b.p - a, points.outer.c.p - a,
                      where);
}

template <typename Number>
Residuals<Number> transposed_times(const LowerRoot<Number>& l, const Residuals<Number>& of) {
  return {multiply_add(l.l31, of.r3, multiply_add(l.l21, of.r2, l.l11 * of.r1)),
          multiply_add(l.l32, of.r3, l.l22 * of.r2), l.l33 * of.r3};
}
template <typename Number>
Residuals<Number> times(const LowerRoot<Number>& l, const Residuals<Number>& of) {
  return {l.l11 * of.r1, multiply_add(l.l22, of.r2, l.l21 * of.r1),
          multiply_add(l.l33, of.r3, multiply_add(l.l32, of.r2, l.l31 * of.r1))};
}

// What the rest shape keeps of the residuals r': rho'_j along the unit vector n that fits all three best, on
// the side of the triangle's normal. Any other n would exert a torque.
template <typename Number>
void subtract_rest(const LaneAccess<Number>& access, const LaneRow* rest, const TriangleEdges<Number>& edges,
                   Residuals<Number>& residuals) {
  auto& [r1, r2, r3] = residuals;
  const Number rest1 = access.load(rest[0]), rest2 = access.load(rest[1]), rest3 = access.load(rest[2]);
  const LaneVec3<Number> n = multiply_add(rest3, r3, multiply_add(rest2, r2, rest1 * r1));
  const Number outward = dot(n, cross(edges.e1, edges.e2)), length_squared = dot(n, n);
  const Number unsigned_scale = Number(1) / square_root(length_squared);
  const Number scale =
      where_positive(length_squared, where_positive(outward, unsigned_scale, -unsigned_scale), Number(0));
  r1 = subtract_product(rest1 * scale, n, r1);
  r2 = subtract_product(rest2 * scale, n, r2);
  r3 = subtract_product(rest3 * scale, n, r3);
}

// Each point takes its inverse mass times the pulls: `pulls` of the outer corners, and what balances them.
template <typename Number>
void pull_own(const Residuals<Number>& pulls, const OuterCoordinates<Number>& where,
              TrianglePoints<Number>& own) {
  const auto& [m1, m2, m3] = pulls;
  const LaneVec3<Number> on_b = multiply_add(where.s3, m3, multiply_add(where.s2, m2, where.s1 * m1));
  const LaneVec3<Number> on_c = multiply_add(where.t3, m3, multiply_add(where.t2, m2, where.t1 * m1));
  const LaneVec3<Number> on_a = (m1 + m2 + m3) - (on_b + on_c);
  own.a.p = multiply_add(own.a.w, on_a, own.a.p);
  own.b.p = multiply_add(own.b.w, on_b, own.b.p);
  own.c.p = multiply_add(own.c.w, on_c, own.c.p);
}
template <typename Number>
void pull_outer(const Residuals<Number>& pulls, TrianglePoints<Number>& outer) {
  outer.a.p = subtract_product(outer.a.w, pulls.r1, outer.a.p);
  outer.b.p = subtract_product(outer.b.w, pulls.r2, outer.b.p);
  outer.c.p = subtract_product(outer.c.w, pulls.r3, outer.c.p);
}

// What passes between the phases of a tile.
template <typename Number>
struct BendingTile {
  BendingPoints<Number> points[SweepOrder::largest_tile];
  Residuals<Number> residuals[SweepOrder::largest_tile];
};

template <typename Number>
void gather_tile(const BendingStage& stage, const RowRange& rows, const LaneAccess<Number>& access,
                 const Point4* points, BendingTile<Number>& tile) {
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    const IndexRow* corners = &stage.corners[6 * row];
    tile.points[i] = {gather_triangle(access, corners, points), gather_triangle(access, corners + 3, points)};
    tile.residuals[i] =
        residuals_of(tile.points[i], load_coordinates(access, &stage.coordinates[coordinate_rows * row]));
  }
}

template <typename Number>
void move_tile(const BendingStage& stage, const std::vector<LaneRow>& roots, const RowRange& rows,
               const LaneAccess<Number>& access, BendingTile<Number>& tile, Point4* points) {
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    const IndexRow* corners = &stage.corners[6 * row];
    const Residuals<Number> pulls =
        times(load_root(access, &roots[bending_step_rows * row]), tile.residuals[i]);
    BendingPoints<Number> moved = tile.points[i];
    pull_outer(pulls, moved.outer);
    scatter_triangle(access, corners + 3, moved.outer, points);
    pull_own(pulls, load_coordinates(access, &stage.coordinates[coordinate_rows * row]), moved.own);
    scatter_triangle(access, corners, moved.own, points);
  }
}

template <typename Number>
void scale_residuals(const LaneAccess<Number>& access, const LaneRow* root, Residuals<Number>& residuals) {
  residuals = transposed_times(load_root(access, root), residuals);
}

template <typename Number>
[[gnu::flatten]] void pull_bending_tile(const BendingStage& stage, const std::vector<LaneRow>& base,
                                        const RowRange& rows, const LaneAccess<Number>& access,
                                        Point4* offsets) {
  const std::size_t height = bending_base_rows(stage);
  BendingTile<Number> tile;
  gather_tile(stage, rows, access, offsets, tile);
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    Residuals<Number>& residuals = tile.residuals[row - rows.first];
    residuals = load_residuals(access, &base[height * row]) + residuals;
    scale_residuals(access, &stage.steps[bending_step_rows * row], residuals);
  }
  if (stage.curved)
    for (std::size_t row = rows.first; row < rows.end; ++row) {
      const std::size_t i = row - rows.first;
      subtract_rest(access, &stage.rest[3 * row],
                    load_edges(access, &base[height * row + 9]) + edges_of(tile.points[i].own),
                    tile.residuals[i]);
    }
  move_tile(stage, stage.steps, rows, access, tile, offsets);
}

template <typename Number>
[[gnu::flatten]] void damp_bending_tile(const BendingStage& stage, const RowRange& rows,
                                        const LaneAccess<Number>& access, Point4* velocities) {
  BendingTile<Number> tile;
  gather_tile(stage, rows, access, velocities, tile);
  for (std::size_t row = rows.first; row < rows.end; ++row)
    scale_residuals(access, &stage.dampings[bending_step_rows * row], tile.residuals[row - rows.first]);
  move_tile(stage, stage.dampings, rows, access, tile, velocities);
}

}  // namespace drape

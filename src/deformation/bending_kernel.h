#pragma once

#include "deformation/bending.h"
#include "deformation/membrane_kernel.h"

// The arithmetic of bending.h for one tile of rows, as eight lanes (Number = Lanes) or one of them (float), in phases
// as in membrane_kernel.h.
namespace drape {

template <typename Number>
struct BendingPoints {
  TrianglePoints<Number> own;
  LanePoint<Number> outer[3];
};
template <typename Number>
struct Residuals {
  LaneVec3<Number> r[3];
};
// Where the outer corners lie, in the affine coordinates of the own ones.
template <typename Number>
struct OuterCoordinates {
  Number s[3], t[3];
};
template <typename Number>
struct LowerRoot {
  Number l11, l21, l22, l31, l32, l33;
};

template <typename Number>
OuterCoordinates<Number> load_coordinates(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {{access.load(rows[0]), access.load(rows[1]), access.load(rows[2])},
          {access.load(rows[3]), access.load(rows[4]), access.load(rows[5])}};
}
template <typename Number>
LowerRoot<Number> load_root(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {access.load(rows[0]), access.load(rows[1]), access.load(rows[2]),
          access.load(rows[3]), access.load(rows[4]), access.load(rows[5])};
}

// x_j - x_a - s_j (x_b - x_a) - t_j (x_c - x_a), from these differences.
template <typename Number>
LaneVec3<Number> residual(const LaneVec3<Number>& outer, Number s, Number t, const TriangleEdges<Number>& own) {
  return subtract_product(t, own.e2, subtract_product(s, own.e1, outer));
}

template <typename Number>
void load_bending_row(const BendingStage& stage, const SplitPoints& start, std::size_t row,
                      const LaneAccess<Number>& access, LaneRow* base) {
  const IndexRow* corners = &stage.corners[6 * row];
  const OuterCoordinates<Number> where = load_coordinates(access, &stage.coordinates[coordinate_rows * row]);
  const SplitPoint<Number> a = gather(access, start, corners[0]);
  const TriangleEdges<Number> own{gather(access, start, corners[1]) - a, gather(access, start, corners[2]) - a};
  for (int j = 0; j < 3; ++j)
    store_vector(access, residual(gather(access, start, corners[3 + j]) - a, where.s[j], where.t[j], own),
                 base + 3 * j);
  if (!stage.curved) return;
  store_vector(access, own.e1, base + 9);
  store_vector(access, own.e2, base + 12);
}

template <typename Number>
BendingPoints<Number> gather_cluster(const LaneAccess<Number>& access, const IndexRow* corners,
                                     const Point4* points) {
  return {gather_triangle(access, corners, points),
          {access.gather(points, corners[3]), access.gather(points, corners[4]), access.gather(points, corners[5])}};
}

template <typename Number>
Residuals<Number> residuals_of(const BendingPoints<Number>& points, const OuterCoordinates<Number>& where) {
  const TriangleEdges<Number> own = edges_of(points.own);
  Residuals<Number> found;
  for (int j = 0; j < 3; ++j)
    found.r[j] = residual(points.outer[j].p - points.own.a.p, where.s[j], where.t[j], own);
  return found;
}

template <typename Number>
Residuals<Number> transposed_times(const LowerRoot<Number>& l, const Residuals<Number>& of) {
  return {{multiply_add(l.l31, of.r[2], multiply_add(l.l21, of.r[1], l.l11 * of.r[0])),
           multiply_add(l.l32, of.r[2], l.l22 * of.r[1]), l.l33 * of.r[2]}};
}
template <typename Number>
Residuals<Number> times(const LowerRoot<Number>& l, const Residuals<Number>& of) {
  return {{l.l11 * of.r[0], multiply_add(l.l22, of.r[1], l.l21 * of.r[0]),
           multiply_add(l.l33, of.r[2], multiply_add(l.l32, of.r[1], l.l31 * of.r[0]))}};
}

// What the rest shape keeps of the residuals r': rho'_j along the unit vector n that fits all three best, on the side
// of the triangle's normal. Any other n would exert a torque.
template <typename Number>
void subtract_rest(const LaneAccess<Number>& access, const LaneRow* rest, const TriangleEdges<Number>& edges,
                   Residuals<Number>& residuals) {
  LaneVec3<Number>(&r)[3] = residuals.r;
  LaneVec3<Number> n = access.load(rest[0]) * r[0];
  n = multiply_add(access.load(rest[1]), r[1], n);
  n = multiply_add(access.load(rest[2]), r[2], n);
  const Number outward = dot(n, cross(edges.e1, edges.e2)), length_squared = dot(n, n);
  const Number unsigned_scale = Number(1) / square_root(length_squared);
  const Number scale =
      where_positive(length_squared, where_positive(outward, unsigned_scale, -unsigned_scale), Number(0));
  for (int j = 0; j < 3; ++j) r[j] = subtract_product(access.load(rest[j]) * scale, n, r[j]);
}

// Each point takes its inverse mass times the pulls: `pulls` of the outer corners, and what balances them.
template <typename Number>
void pull_cluster(const Residuals<Number>& pulls, const OuterCoordinates<Number>& where,
                  BendingPoints<Number>& points) {
  const LaneVec3<Number>(&m)[3] = pulls.r;
  const auto sum = [&](const Number(&by)[3]) {
    return multiply_add(by[2], m[2], multiply_add(by[1], m[1], by[0] * m[0]));
  };
  const LaneVec3<Number> on_b = sum(where.s), on_c = sum(where.t);
  const LaneVec3<Number> on_a = (m[0] + m[1] + m[2]) - (on_b + on_c);
  points.own.a.p = multiply_add(points.own.a.w, on_a, points.own.a.p);
  points.own.b.p = multiply_add(points.own.b.w, on_b, points.own.b.p);
  points.own.c.p = multiply_add(points.own.c.w, on_c, points.own.c.p);
  for (int j = 0; j < 3; ++j) points.outer[j].p = subtract_product(points.outer[j].w, m[j], points.outer[j].p);
}

template <typename Number>
void move_cluster(const LaneAccess<Number>& access, const IndexRow* corners, const Residuals<Number>& pulls,
                  const OuterCoordinates<Number>& where, BendingPoints<Number> moved, Point4* points) {
  pull_cluster(pulls, where, moved);
  access.scatter(points, corners[0], moved.own.a);
  access.scatter(points, corners[1], moved.own.b);
  access.scatter(points, corners[2], moved.own.c);
  for (int j = 0; j < 3; ++j) access.scatter(points, corners[3 + j], moved.outer[j]);
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
    tile.points[i] = gather_cluster(access, &stage.corners[6 * row], points);
    tile.residuals[i] =
        residuals_of(tile.points[i], load_coordinates(access, &stage.coordinates[coordinate_rows * row]));
  }
}

template <typename Number>
void move_tile(const BendingStage& stage, const std::vector<LaneRow>& roots, const RowRange& rows,
               const LaneAccess<Number>& access, const BendingTile<Number>& tile, Point4* points) {
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    move_cluster(access, &stage.corners[6 * row],
                 times(load_root(access, &roots[bending_step_rows * row]), tile.residuals[i]),
                 load_coordinates(access, &stage.coordinates[coordinate_rows * row]), tile.points[i], points);
  }
}

template <typename Number>
void scale_residuals(const LaneAccess<Number>& access, const LaneRow* root, Residuals<Number>& residuals) {
  residuals = transposed_times(load_root(access, root), residuals);
}

template <typename Number>
[[gnu::flatten]] void pull_bending_tile(const BendingStage& stage, const std::vector<LaneRow>& base,
                                        const RowRange& rows, const LaneAccess<Number>& access, Point4* offsets) {
  const std::size_t height = bending_base_rows(stage);
  BendingTile<Number> tile;
  gather_tile(stage, rows, access, offsets, tile);
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    Residuals<Number>& residuals = tile.residuals[row - rows.first];
    for (std::size_t j = 0; j < 3; ++j)
      residuals.r[j] = load_vector(access, &base[height * row + 3 * j]) + residuals.r[j];
    scale_residuals(access, &stage.steps[bending_step_rows * row], residuals);
  }
  if (stage.curved)
    for (std::size_t row = rows.first; row < rows.end; ++row) {
      const std::size_t i = row - rows.first;
      subtract_rest(access, &stage.rest[3 * row],
                    load_edges(access, &base[height * row + 9]) + edges_of(tile.points[i].own), tile.residuals[i]);
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

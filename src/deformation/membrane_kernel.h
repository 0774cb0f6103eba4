#pragma once

#include "deformation/membrane.h"
#include "deformation/triangle_match.h"

// The arithmetic of membrane.h for one tile of rows, as eight lanes (Number = Lanes) or one of them (float).
// Each loop over the rows is one phase; what passes from one to the next lies in small arrays (SweepOrder
// says why).
namespace drape {

template <typename Number>
LaneVec3<Number> load_vector(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {access.load(rows[0]), access.load(rows[1]), access.load(rows[2])};
}
template <typename Number>
void store_vector(const LaneAccess<Number>& access, const LaneVec3<Number>& value, LaneRow* rows) {
  access.store(rows[0], value.x), access.store(rows[1], value.y), access.store(rows[2], value.z);
}

template <typename Number>
struct TrianglePoints {
  LanePoint<Number> a, b, c;
};
template <typename Number>
struct TriangleEdges {
  LaneVec3<Number> e1, e2;
};

template <typename Number>
TrianglePoints<Number> gather_triangle(const LaneAccess<Number>& access, const IndexRow* corners,
                                       const Point4* points) {
  return {access.gather(points, corners[0]), access.gather(points, corners[1]),
          access.gather(points, corners[2])};
}
template <typename Number>
void scatter_triangle(const LaneAccess<Number>& access, const IndexRow* corners,
                      const TrianglePoints<Number>& values, Point4* points) {
  access.scatter(points, corners[0], values.a);
  access.scatter(points, corners[1], values.b);
  access.scatter(points, corners[2], values.c);
}
template <typename Number>
TriangleEdges<Number> load_edges(const LaneAccess<Number>& access, const LaneRow* base) {
  return {load_vector(access, base), load_vector(access, base + 3)};
}
// What two of a triangle's edges are, or gain, by the points.
template <typename Number>
TriangleEdges<Number> edges_of(const TrianglePoints<Number>& points) {
  return {points.b.p - points.a.p, points.c.p - points.a.p};
}
template <typename Number>
TriangleEdges<Number> operator+(const TriangleEdges<Number>& s, const TriangleEdges<Number>& t) {
  return {s.e1 + t.e1, s.e2 + t.e2};
}

template <typename Number>
[[gnu::flatten]] void load_membrane_row(const MembraneStage& stage, const SplitPoints& start, std::size_t row,
                                        const LaneAccess<Number>& access, LaneRow* base) {
  const IndexRow* corners = &stage.corners[3 * row];
  const SplitPoint<Number> a = gather(access, start, corners[0]);
  store_vector(access, gather(access, start, corners[1]) - a, base);
  store_vector(access, gather(access, start, corners[2]) - a, base + 3);
}

// All that the match of a triangle needs of its edges: their products, and n^2 of the doubled area n = |e1 x
// e2|.
template <typename Number>
struct EdgeProducts {
  Number e11, e12, e22, n_squared;
};

template <typename Number>
EdgeProducts<Number> edge_products(const TriangleEdges<Number>& edges) {
  const auto& [e1, e2] = edges;
  const LaneVec3<Number> normal = cross(e1, e2);
  return {dot(e1, e1), dot(e1, e2), dot(e2, e2), dot(normal, normal)};
}

// Positive where the corners are not collinear.
template <typename Number>
Number soundness(const EdgeProducts<Number>& products) {
  return products.n_squared - Number(1e-8f) * (products.e11 * products.e22);
}

// The two columns of the rotation that matches the rest triangle to the edges, as sums of the edges:
// r1 = a1 e1 + b1 e2, r2 = a2 e1 + b2 e2. With these, r1.e1 = n b2, r1.e2 = -n a2, r2.e1 = -n b1 and r2.e2 =
// n a1.
template <typename Number>
struct MatchedFrame {
  Number a1, b1, a2, b2, n;
};

// With v = k1 e1 + k2 e2 (triangle_match.h), L = |e1 + v x n/|n||: L2 = e1.e1 + v.v + 2 k2 n is a sum of what
// is not negative, and so loses no digits. Collinear triangles get a frame of zeros, which moves nothing.
template <typename Number>
MatchedFrame<Number> match_triangle(const EdgeProducts<Number>& products, Number k1, Number k2) {
  const auto& [e11, e12, e22, n_squared] = products;
  const Number n = square_root(n_squared);
  const Number ve1 = multiply_add(k1, e11, k2 * e12), ve2 = multiply_add(k1, e12, k2 * e22);
  const Number length_squared = multiply_add(k1, ve1, multiply_add(k2, ve2, multiply_add(k2 + k2, n, e11)));
  const Number scale =
      where_positive(soundness(products), Number(1) / (square_root(length_squared) * n), Number(0));
  return {(n + ve2) * scale, -(ve1 * scale), multiply_add(k1, n, -e12) * scale,
          multiply_add(k2, n, e11) * scale, n};
}

// The inverse of the rest edges, and the K of one triangle.
template <typename Number>
struct MembraneConstants {
  Number d11, d12, d21, d22;
  Number k11, k12, k13, k22, k23, k33;
};

template <typename Number>
MembraneConstants<Number> load_constants(const LaneAccess<Number>& access, const LaneRow* shape,
                                         const LaneRow* k) {
  const LaneRow* d = shape + MembraneShape::inverse_shape;
  return {access.load(d[0]), access.load(d[1]), access.load(d[2]), access.load(d[3]), access.load(k[0]),
          access.load(k[1]), access.load(k[2]), access.load(k[3]), access.load(k[4]), access.load(k[5])};
}

template <typename Number>
struct MembraneStrain {
  Number along, across, shear;
};

// Of the deformation gradient's columns f = (e1 e2) D in the frame, from r_i . e_j.
template <typename Number>
MembraneStrain<Number> gradient(const MembraneConstants<Number>& c, Number r1e1, Number r1e2, Number r2e1,
                                Number r2e2) {
  const Number shear1 = multiply_add(r1e1, c.d12, r1e2 * c.d22);
  return {multiply_add(r1e1, c.d11, r1e2 * c.d21), multiply_add(r2e1, c.d12, r2e2 * c.d22),
          multiply_add(r2e1, c.d11, multiply_add(r2e2, c.d21, shear1))};
}

template <typename Number>
MembraneStrain<Number> matched_strain(const MembraneConstants<Number>& c, const MatchedFrame<Number>& f) {
  const auto& [a1, b1, a2, b2, n] = f;
  const MembraneStrain<Number> per_n = gradient(c, b2, -a2, -b1, a1);
  return {multiply_add(n, per_n.along, Number(-1)), multiply_add(n, per_n.across, Number(-1)),
          n * per_n.shear};
}

template <typename Number>
MembraneStrain<Number> strain_rate(const MembraneConstants<Number>& c, const MatchedFrame<Number>& f,
                                   const TriangleEdges<Number>& edges, const TriangleEdges<Number>& rates) {
  const Number e1r1 = dot(edges.e1, rates.e1), e2r1 = dot(edges.e2, rates.e1);
  const Number e1r2 = dot(edges.e1, rates.e2), e2r2 = dot(edges.e2, rates.e2);
  return gradient(c, multiply_add(f.a1, e1r1, f.b1 * e2r1), multiply_add(f.a1, e1r2, f.b1 * e2r2),
                  multiply_add(f.a2, e1r1, f.b2 * e2r1), multiply_add(f.a2, e1r2, f.b2 * e2r2));
}

// What the stress K e does to the second and third corner, times their masses, in the frame.
template <typename Number>
struct FrameForces {
  Number b1, b2, c1, c2;
};

template <typename Number>
FrameForces<Number> frame_forces(const MembraneConstants<Number>& c, const MembraneStrain<Number>& e) {
  const Number along = multiply_add(c.k11, e.along, multiply_add(c.k12, e.across, c.k13 * e.shear));
  const Number across = multiply_add(c.k12, e.along, multiply_add(c.k22, e.across, c.k23 * e.shear));
  const Number shear = multiply_add(c.k13, e.along, multiply_add(c.k23, e.across, c.k33 * e.shear));
  return {multiply_add(along, c.d11, shear * c.d12), multiply_add(shear, c.d11, across * c.d12),
          multiply_add(along, c.d21, shear * c.d22), multiply_add(shear, c.d21, across * c.d22)};
}

// Moves the corners against forces on the second and third; a corner's share is its inverse mass.
template <typename Number>
void move_corners(const LaneVec3<Number>& on_b, const LaneVec3<Number>& on_c,
                  TrianglePoints<Number>& points) {
  points.a.p = multiply_add(points.a.w, on_b + on_c, points.a.p);
  points.b.p = subtract_product(points.b.w, on_b, points.b.p);
  points.c.p = subtract_product(points.c.w, on_c, points.c.p);
}

template <typename Number>
void move_triangle(const LaneAccess<Number>& access, const IndexRow* corners,
                   const FrameForces<Number>& forces, const MatchedFrame<Number>& frame,
                   const TriangleEdges<Number>& edges, TrianglePoints<Number> points, Point4* offsets) {
  const auto in_space = [&](Number f1, Number f2) {
    const Number along_e1 = multiply_add(f1, frame.a1, f2 * frame.a2);
    const Number along_e2 = multiply_add(f1, frame.b1, f2 * frame.b2);
    return multiply_add(along_e1, edges.e1, along_e2 * edges.e2);
  };
  move_corners(in_space(forces.b1, forces.b2), in_space(forces.c1, forces.c2), points);
  scatter_triangle(access, corners, points, offsets);
}

// What passes between the phases of a tile.
template <typename Number>
struct MembraneTile {
  TrianglePoints<Number> points[SweepOrder::largest_tile];
  TriangleEdges<Number> edges[SweepOrder::largest_tile];
  EdgeProducts<Number> products[SweepOrder::largest_tile];
  MatchedFrame<Number> frames[SweepOrder::largest_tile];
  bool sound = true;
};

template <typename Number>
void match_tile(const MembraneStage& stage, const RowRange& rows, const LaneAccess<Number>& access,
                MembraneTile<Number>& tile) {
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    const LaneRow* shape = &stage.shapes[MembraneShape::count * row];
    tile.frames[i] = match_triangle(tile.products[i], access.load(shape[MembraneShape::k1]),
                                    access.load(shape[MembraneShape::k2]));
    tile.sound = tile.sound && all_positive(soundness(tile.products[i]));
  }
}

// A collinear triangle, with any normal that serves, in double. `edges` make its frame, `strained` strain it:
// the edges themselves, less 1 (`rest`), or their rates.
inline void move_collinear(const MembraneStage& stage, const LaneRow* k, std::size_t row, int lane,
                           const TriangleEdges<float>& edges, const TriangleEdges<float>& strained,
                           float rest, Point4* points) {
  const LaneAccess<float> access{lane};
  const LaneRow* shape = &stage.shapes[MembraneShape::count * row];
  const MembraneConstants<float> c = load_constants(access, shape, k);
  const auto vector = [](const LaneVec3<float>& v) { return Vec3(v.x, v.y, v.z); };
  const auto [r1, r2] =
      matched_frame<double>(access.load(shape[MembraneShape::k1]), access.load(shape[MembraneShape::k2]),
                            vector(edges.e1), vector(edges.e2));
  const auto product = [&](const Vec3& r, const LaneVec3<float>& e) {
    return static_cast<float>(r.dot(vector(e)));
  };
  MembraneStrain<float> strain = gradient(c, product(r1, strained.e1), product(r1, strained.e2),
                                          product(r2, strained.e1), product(r2, strained.e2));
  strain.along -= rest;
  strain.across -= rest;
  const FrameForces<float> f = frame_forces(c, strain);
  const auto in_space = [&r1 = r1, &r2 = r2](float f1, float f2) {
    const Vec3 force = f1 * r1 + f2 * r2;
    return LaneVec3<float>{static_cast<float>(force.x()), static_cast<float>(force.y()),
                           static_cast<float>(force.z())};
  };
  const IndexRow* corners = &stage.corners[3 * row];
  TrianglePoints<float> moved = gather_triangle(access, corners, points);
  move_corners(in_space(f.b1, f.b2), in_space(f.c1, f.c2), moved);
  scatter_triangle(access, corners, moved, points);
}

// The collinear triangles of a tile, which its phases have left where they were. `damping`: points are
// velocities.
template <typename Number>
[[gnu::noinline]] void move_collinear_triangles(const MembraneStage& stage, const std::vector<LaneRow>& base,
                                                const RowRange& rows, const LaneAccess<Number>& lanes,
                                                const MembraneTile<Number>& tile, bool damping,
                                                Point4* points) {
  const LaneRow* k = damping ? stage.dampings.data() : stage.stresses.data();
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    LaneRow sound;
    lanes.store(sound, soundness(tile.products[row - rows.first]));
    for (int lane = lanes.begin(); lane < lanes.end(); ++lane) {
      if (sound.values[lane] > 0) continue;
      const LaneAccess<float> access{lane};
      const TriangleEdges<float> start = load_edges(access, &base[membrane_base_rows * row]);
      const TriangleEdges<float> change = edges_of(gather_triangle(access, &stage.corners[3 * row], points));
      if (damping)
        move_collinear(stage, k + stress_rows * row, row, lane, start, change, 0, points);
      else
        move_collinear(stage, k + stress_rows * row, row, lane, start + change, start + change, 1, points);
    }
  }
}

template <typename Number>
[[gnu::flatten]] void pull_membrane_tile(const MembraneStage& stage, const std::vector<LaneRow>& base,
                                         const RowRange& rows, const LaneAccess<Number>& access,
                                         Point4* offsets) {
  MembraneTile<Number> tile;
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    tile.points[i] = gather_triangle(access, &stage.corners[3 * row], offsets);
    tile.edges[i] = load_edges(access, &base[membrane_base_rows * row]) + edges_of(tile.points[i]);
    tile.products[i] = edge_products(tile.edges[i]);
  }
  match_tile(stage, rows, access, tile);
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    const MembraneConstants<Number> constants =
        load_constants(access, &stage.shapes[MembraneShape::count * row], &stage.stresses[stress_rows * row]);
    const FrameForces<Number> forces = frame_forces(constants, matched_strain(constants, tile.frames[i]));
    move_triangle(access, &stage.corners[3 * row], forces, tile.frames[i], tile.edges[i], tile.points[i],
                  offsets);
  }
  if (!tile.sound) move_collinear_triangles(stage, base, rows, access, tile, false, offsets);
}

template <typename Number>
[[gnu::flatten]] void damp_membrane_tile(const MembraneStage& stage, const std::vector<LaneRow>& base,
                                         const RowRange& rows, const LaneAccess<Number>& access,
                                         Point4* velocities) {
  MembraneTile<Number> tile;
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    tile.points[i] = gather_triangle(access, &stage.corners[3 * row], velocities);
    tile.edges[i] = load_edges(access, &base[membrane_base_rows * row]);
    tile.products[i] = edge_products(tile.edges[i]);
  }
  match_tile(stage, rows, access, tile);
  for (std::size_t row = rows.first; row < rows.end; ++row) {
    const std::size_t i = row - rows.first;
    const MembraneConstants<Number> constants =
        load_constants(access, &stage.shapes[MembraneShape::count * row], &stage.dampings[stress_rows * row]);
    const FrameForces<Number> forces = frame_forces(
        constants, strain_rate(constants, tile.frames[i], tile.edges[i], edges_of(tile.points[i])));
    move_triangle(access, &stage.corners[3 * row], forces, tile.frames[i], tile.edges[i], tile.points[i],
                  velocities);
  }
  if (!tile.sound) move_collinear_triangles(stage, base, rows, access, tile, true, velocities);
}

}  // namespace drape

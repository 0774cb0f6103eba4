#pragma once

#include "deformation/membrane.h"
#include "deformation/triangle_match.h"

// The arithmetic of membrane.h for one row, as eight lanes (Number = Lanes) or one of them (float).
namespace drape {

template <typename Number>
LaneVec3<Number> load_vector(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {access.load(rows[0]), access.load(rows[1]), access.load(rows[2])};
}

// A triangle's edges, and the two columns r1, r2 of the rotation that matches the rest triangle to it, as sums of the
// edges: r1 = a1 e1 + b1 e2, r2 = a2 e1 + b2 e2. All follows from the edges' products and the doubled area n = |e1 x e2|:
// with v = k1 e1 + k2 e2 (triangle_match.h), L = |e1 + v x n/|n||, L2 = e1.e1 + v.v + 2 k2 n is a sum of what is not
// negative, and so loses no digits.
template <typename Number>
struct MatchedTriangle {
  LaneVec3<Number> e1, e2;
  Number a1, b1, a2, b2;
  Number r1e1, r1e2, r2e1, r2e2;  // r_i . e_j
  Number sound;                   // positive where the corners are not collinear
};

template <typename Number>
MatchedTriangle<Number> match_triangle(const LaneVec3<Number>& e1, const LaneVec3<Number>& e2, Number k1, Number k2) {
  const LaneVec3<Number> normal = cross(e1, e2);
  const Number n_squared = dot(normal, normal), n = square_root(n_squared);
  const Number e11 = dot(e1, e1), e12 = dot(e1, e2), e22 = dot(e2, e2);
  const Number ve1 = multiply_add(k1, e11, k2 * e12), ve2 = multiply_add(k1, e12, k2 * e22);
  const Number length_squared =
      multiply_add(k1, ve1, multiply_add(k2, ve2, multiply_add(k2 + k2, n, e11)));
  const Number per_length_n = Number(1) / (square_root(length_squared) * n);
  const Number per_length = per_length_n * n;
  MatchedTriangle<Number> match{e1, e2, {}, {}, {}, {}, {}, {}, {}, {}, {}};
  match.a1 = (n + ve2) * per_length_n;
  match.b1 = -(ve1 * per_length_n);
  match.a2 = multiply_add(k1, n, -e12) * per_length_n;
  match.b2 = multiply_add(k2, n, e11) * per_length_n;
  match.r1e1 = multiply_add(k2, n, e11) * per_length;
  match.r1e2 = subtract_product(k1, n, e12) * per_length;
  match.r2e1 = ve1 * per_length;
  match.r2e2 = (n + ve2) * per_length;
  match.sound = n_squared - Number(1e-8f) * (e11 * e22);
  return match;
}

// The rows of constants of one triangle.
template <typename Number>
struct MembraneConstants {
  Number d11, d12, d21, d22;
  Number k[6];
};

template <typename Number>
MembraneConstants<Number> load_constants(const LaneAccess<Number>& access, const LaneRow* rows) {
  const LaneRow *d = rows + MembraneRow::inverse_shape, *k = rows + MembraneRow::stress;
  return {access.load(d[0]),
          access.load(d[1]),
          access.load(d[2]),
          access.load(d[3]),
          {access.load(k[0]), access.load(k[1]), access.load(k[2]), access.load(k[3]), access.load(k[4]),
           access.load(k[5])}};
}

template <typename Number>
struct MembraneStrain {
  Number along, across, shear;
};

// Of the deformation gradient's columns f = (e1 e2) D in the frame; less 1 along and across, or as it is for rates.
template <typename Number>
MembraneStrain<Number> frame_strain(const MembraneConstants<Number>& c, Number r1e1, Number r1e2, Number r2e1,
                                    Number r2e2, Number rest) {
  const Number shear1 = multiply_add(r1e1, c.d12, r1e2 * c.d22);
  return {multiply_add(r1e1, c.d11, multiply_add(r1e2, c.d21, -rest)),
          multiply_add(r2e1, c.d12, multiply_add(r2e2, c.d22, -rest)),
          multiply_add(r2e1, c.d11, multiply_add(r2e2, c.d21, shear1))};
}

// What the stress K e does to the second and third corner, times their masses, in the frame.
template <typename Number>
struct FrameForces {
  Number b1, b2, c1, c2;
};

template <typename Number>
FrameForces<Number> frame_forces(const MembraneConstants<Number>& c, const MembraneStrain<Number>& e) {
  const Number along = multiply_add(c.k[0], e.along, multiply_add(c.k[1], e.across, c.k[2] * e.shear));
  const Number across = multiply_add(c.k[1], e.along, multiply_add(c.k[3], e.across, c.k[4] * e.shear));
  const Number shear = multiply_add(c.k[2], e.along, multiply_add(c.k[4], e.across, c.k[5] * e.shear));
  return {multiply_add(along, c.d11, shear * c.d12), multiply_add(shear, c.d11, across * c.d12),
          multiply_add(along, c.d21, shear * c.d22), multiply_add(shear, c.d21, across * c.d22)};
}

template <typename Number>
struct CornerForces {
  LaneVec3<Number> on_b, on_c;
};

template <typename Number>
CornerForces<Number> corner_forces(const MatchedTriangle<Number>& match, const FrameForces<Number>& f) {
  const auto in_space = [&](Number f1, Number f2) {
    const Number along_e1 = multiply_add(f1, match.a1, f2 * match.a2);
    const Number along_e2 = multiply_add(f1, match.b1, f2 * match.b2);
    return multiply_add(along_e1, match.e1, along_e2 * match.e2);
  };
  return {in_space(f.b1, f.b2), in_space(f.c1, f.c2)};
}

// Where corners are collinear or coincide, lane by lane, in double, with any normal that serves. `rate1` and `rate2`
// are what strains: the edges themselves, or their rates.
template <typename Number>
[[gnu::noinline]] void mend_collinear(const LaneAccess<Number>& access, const LaneRow* constants,
                                      const MatchedTriangle<Number>& match, const LaneVec3<Number>& rate1,
                                      const LaneVec3<Number>& rate2, double rest, CornerForces<Number>& forces) {
  constexpr int inputs = 13, outputs = 6;
  LaneRow rows[inputs], results[outputs];
  const Number values[inputs] = {match.e1.x, match.e1.y, match.e1.z, match.e2.x, match.e2.y, match.e2.z, rate1.x,
                                 rate1.y,    rate1.z,    rate2.x,    rate2.y,    rate2.z,    match.sound};
  const Number found[outputs] = {forces.on_b.x, forces.on_b.y, forces.on_b.z,
                                 forces.on_c.x, forces.on_c.y, forces.on_c.z};
  for (int i = 0; i < inputs; ++i) access.store(rows[i], values[i]);
  for (int i = 0; i < outputs; ++i) access.store(results[i], found[i]);
  for (int lane = access.begin(); lane < access.end(); ++lane) {
    if (rows[12].values[lane] > 0) continue;
    const auto vector = [&](int i) {
      return Vec3(rows[i].values[lane], rows[i + 1].values[lane], rows[i + 2].values[lane]);
    };
    const MembraneConstants<float> c = load_constants(LaneAccess<float>{lane}, constants);
    const auto [r1, r2] = matched_frame<double>(constants[MembraneRow::k1].values[lane],
                                                constants[MembraneRow::k2].values[lane], vector(0), vector(3));
    const auto product = [&](const Vec3& a, const Vec3& b) { return static_cast<float>(a.dot(b)); };
    const FrameForces<float> f = frame_forces(
        c, frame_strain(c, product(r1, vector(6)), product(r1, vector(9)), product(r2, vector(6)),
                        product(r2, vector(9)), static_cast<float>(rest)));
    for (int i = 0; i < 3; ++i) {
      results[i].values[lane] = static_cast<float>(f.b1 * r1[i] + f.b2 * r2[i]);
      results[i + 3].values[lane] = static_cast<float>(f.c1 * r1[i] + f.c2 * r2[i]);
    }
  }
  forces = {load_vector(access, results), load_vector(access, results + 3)};
}

// Moves the corners against the stress; a corner's share is its inverse mass.
template <typename Number>
void apply_forces(const CornerForces<Number>& forces, LanePoint<Number>& a, LanePoint<Number>& b,
                  LanePoint<Number>& c) {
  a.p = multiply_add(a.w, forces.on_b + forces.on_c, a.p);
  b.p = subtract_product(b.w, forces.on_b, b.p);
  c.p = subtract_product(c.w, forces.on_c, c.p);
}

template <typename Number>
[[gnu::flatten]] void pull_membrane_row(const MembraneStage& stage, const std::vector<LaneRow>& base, std::size_t row,
                                        const LaneAccess<Number>& access, Point4* offsets) {
  const IndexRow* corners = &stage.corners[3 * row];
  const LaneRow* rows = &stage.constants[MembraneRow::count * row];
  const LaneRow* edges = &base[membrane_base_rows * row];
  LanePoint<Number> a = access.gather(offsets, corners[0]), b = access.gather(offsets, corners[1]),
                    c = access.gather(offsets, corners[2]);
  const MatchedTriangle<Number> match =
      match_triangle(load_vector(access, edges) + (b.p - a.p), load_vector(access, edges + 3) + (c.p - a.p),
                     access.load(rows[MembraneRow::k1]), access.load(rows[MembraneRow::k2]));
  const MembraneConstants<Number> constants = load_constants(access, rows);
  const MembraneStrain<Number> strain =
      frame_strain(constants, match.r1e1, match.r1e2, match.r2e1, match.r2e2, Number(1));
  CornerForces<Number> forces = corner_forces(match, frame_forces(constants, strain));
  if (!all_positive(match.sound)) mend_collinear(access, rows, match, match.e1, match.e2, 1, forces);
  apply_forces(forces, a, b, c);
  access.scatter(offsets, corners[0], a);
  access.scatter(offsets, corners[1], b);
  access.scatter(offsets, corners[2], c);
}

template <typename Number>
[[gnu::flatten]] void damp_membrane_row(const MembraneStage& stage, const std::vector<LaneRow>& base, std::size_t row,
                                        const LaneAccess<Number>& access, Point4* velocities) {
  const IndexRow* corners = &stage.corners[3 * row];
  const LaneRow* rows = &stage.constants[MembraneRow::count * row];
  const LaneRow* edges = &base[membrane_base_rows * row];
  LanePoint<Number> a = access.gather(velocities, corners[0]), b = access.gather(velocities, corners[1]),
                    c = access.gather(velocities, corners[2]);
  const MatchedTriangle<Number> match =
      match_triangle(load_vector(access, edges), load_vector(access, edges + 3),
                     access.load(rows[MembraneRow::k1]), access.load(rows[MembraneRow::k2]));
  const LaneVec3<Number> rate1 = b.p - a.p, rate2 = c.p - a.p;
  const auto along = [&](Number s1, Number s2, const LaneVec3<Number>& rate) {
    return multiply_add(s1, dot(match.e1, rate), s2 * dot(match.e2, rate));
  };
  const MembraneConstants<Number> constants = load_constants(access, rows);
  const MembraneStrain<Number> strain =
      frame_strain(constants, along(match.a1, match.b1, rate1), along(match.a1, match.b1, rate2),
                   along(match.a2, match.b2, rate1), along(match.a2, match.b2, rate2), Number(0));
  CornerForces<Number> forces = corner_forces(match, frame_forces(constants, strain));
  if (!all_positive(match.sound)) mend_collinear(access, rows, match, rate1, rate2, 0, forces);
  apply_forces(forces, a, b, c);
  access.scatter(velocities, corners[0], a);
  access.scatter(velocities, corners[1], b);
  access.scatter(velocities, corners[2], c);
}

}  // namespace drape

#pragma once

#include "deformation/membrane.h"
#include "deformation/triangle_match.h"

// The arithmetic of membrane.h for one row, as eight lanes (Number = Lanes) or one of them (float).
namespace drape {

template <typename Number>
struct MatchedFrame {
  LaneVec3<Number> r1, r2;
};

// Where three points are collinear or coincide, lane by lane and in double.
template <typename Number>
void mend_frames(const LaneAccess<Number>& access, const LaneVec3<Number>& e1, const LaneVec3<Number>& e2, Number k1,
                 Number k2, MatchedFrame<Number>& frame) {
  LaneRow rows[8], turned[6];
  const Number values[8] = {e1.x, e1.y, e1.z, e2.x, e2.y, e2.z, k1, k2};
  for (int i = 0; i < 8; ++i) access.store(rows[i], values[i]);
  for (int lane = access.begin(); lane < access.end(); ++lane) {
    const auto at = [&](int i) { return static_cast<double>(rows[i].values[lane]); };
    const auto [r1, r2] =
        matched_frame<double>(at(6), at(7), Vec3(at(0), at(1), at(2)), Vec3(at(3), at(4), at(5)));
    for (int i = 0; i < 3; ++i) {
      turned[i].values[lane] = static_cast<float>(r1[i]);
      turned[i + 3].values[lane] = static_cast<float>(r2[i]);
    }
  }
  frame.r1 = {access.load(turned[0]), access.load(turned[1]), access.load(turned[2])};
  frame.r2 = {access.load(turned[3]), access.load(turned[4]), access.load(turned[5])};
}

// Appendix A in closed form, as in triangle_match.h.
template <typename Number>
MatchedFrame<Number> match_frame(const LaneAccess<Number>& access, const LaneVec3<Number>& e1,
                                 const LaneVec3<Number>& e2, Number k1, Number k2) {
  const LaneVec3<Number> v = multiply_add(k1, e1, k2 * e2);
  const LaneVec3<Number> normal = cross(e1, e2);
  const Number normal_squared = dot(normal, normal);
  const Number normal_length = square_root(normal_squared);
  const LaneVec3<Number> a = multiply_add(normal_length, e1, cross(v, normal));
  const Number a_squared = dot(a, a);
  const Number e1_squared = dot(e1, e1), v_squared = dot(v, v);
  const Number a_inverse = Number(1) / square_root(a_squared);
  MatchedFrame<Number> frame{a_inverse * a, {}};
  frame.r2 = (Number(1) / normal_length) * cross(normal, frame.r1);
  const Number not_collinear = normal_squared - Number(1e-8f) * (e1_squared * dot(e2, e2));
  const Number has_direction = a_squared - (Number(1e-8f) * normal_squared) * (e1_squared + v_squared);
  const Number sound = where_positive(not_collinear, has_direction, not_collinear);
  if (!all_positive(sound)) mend_frames(access, e1, e2, k1, k2, frame);
  return frame;
}

template <typename Number>
struct MembraneSums {
  Number along, across, shear;
};

// r_i . f_j with f the columns of the deformation gradient: less 1 (for positions), or as rates (for velocities).
template <typename Number>
MembraneSums<Number> frame_strain(const LaneAccess<Number>& access, const LaneRow* constants,
                                  const MatchedFrame<Number>& frame, const LaneVec3<Number>& e1,
                                  const LaneVec3<Number>& e2) {
  const LaneRow* inverse = constants + MembraneRow::inverse_shape;
  const Number d11 = access.load(inverse[0]), d12 = access.load(inverse[1]);
  const Number d21 = access.load(inverse[2]), d22 = access.load(inverse[3]);
  const Number r1e1 = dot(frame.r1, e1), r1e2 = dot(frame.r1, e2);
  const Number r2e1 = dot(frame.r2, e1), r2e2 = dot(frame.r2, e2);
  const Number shear1 = multiply_add(r1e1, d12, r1e2 * d22), shear2 = multiply_add(r2e1, d11, r2e2 * d21);
  return {multiply_add(r1e1, d11, r1e2 * d21), multiply_add(r2e1, d12, r2e2 * d22), shear1 + shear2};
}

// Moves the three corners against the stress K e; a corner's share is its inverse mass.
template <typename Number>
void relax_strain(const LaneAccess<Number>& access, const LaneRow* constants, const MatchedFrame<Number>& frame,
                  const MembraneSums<Number>& strain, LanePoint<Number>& a, LanePoint<Number>& b,
                  LanePoint<Number>& c) {
  const LaneRow *k = constants + MembraneRow::stress, *inverse = constants + MembraneRow::inverse_shape;
  const auto K = [&](int i) { return access.load(k[i]); };
  const auto& [e1, e2, e3] = strain;
  const Number along = multiply_add(K(0), e1, multiply_add(K(1), e2, K(2) * e3));
  const Number across = multiply_add(K(1), e1, multiply_add(K(3), e2, K(4) * e3));
  const Number shear = multiply_add(K(2), e1, multiply_add(K(4), e2, K(5) * e3));
  const auto force = [&](Number d1, Number d2) {
    const Number t1 = multiply_add(along, d1, shear * d2), t2 = multiply_add(shear, d1, across * d2);
    return multiply_add(t1, frame.r1, t2 * frame.r2);
  };
  const LaneVec3<Number> on_b = force(access.load(inverse[0]), access.load(inverse[1]));
  const LaneVec3<Number> on_c = force(access.load(inverse[2]), access.load(inverse[3]));
  a.p = multiply_add(a.w, on_b + on_c, a.p);
  b.p = subtract_product(b.w, on_b, b.p);
  c.p = subtract_product(c.w, on_c, c.p);
}

template <typename Number>
LaneVec3<Number> load_vector(const LaneAccess<Number>& access, const LaneRow* rows) {
  return {access.load(rows[0]), access.load(rows[1]), access.load(rows[2])};
}

template <typename Number>
void pull_membrane_row(const MembraneStage& stage, const std::vector<LaneRow>& base, std::size_t row,
                       const LaneAccess<Number>& access, Point4* offsets) {
  const IndexRow* corners = &stage.corners[3 * row];
  const LaneRow* constants = &stage.constants[MembraneRow::count * row];
  LanePoint<Number> a = access.gather(offsets, corners[0]), b = access.gather(offsets, corners[1]),
                    c = access.gather(offsets, corners[2]);
  const LaneVec3<Number> e1 = load_vector(access, &base[membrane_base_rows * row]) + (b.p - a.p);
  const LaneVec3<Number> e2 = load_vector(access, &base[membrane_base_rows * row + 3]) + (c.p - a.p);
  const MatchedFrame<Number> frame = match_frame(access, e1, e2, access.load(constants[MembraneRow::k1]),
                                                 access.load(constants[MembraneRow::k2]));
  MembraneSums<Number> strain = frame_strain(access, constants, frame, e1, e2);
  strain.along = strain.along - Number(1);
  strain.across = strain.across - Number(1);
  relax_strain(access, constants, frame, strain, a, b, c);
  access.scatter(offsets, corners[0], a);
  access.scatter(offsets, corners[1], b);
  access.scatter(offsets, corners[2], c);
}

template <typename Number>
void damp_membrane_row(const MembraneStage& stage, const std::vector<LaneRow>& base, std::size_t row,
                       const LaneAccess<Number>& access, Point4* velocities) {
  const IndexRow* corners = &stage.corners[3 * row];
  const LaneRow* constants = &stage.constants[MembraneRow::count * row];
  LanePoint<Number> a = access.gather(velocities, corners[0]), b = access.gather(velocities, corners[1]),
                    c = access.gather(velocities, corners[2]);
  const LaneVec3<Number> e1 = load_vector(access, &base[membrane_base_rows * row]);
  const LaneVec3<Number> e2 = load_vector(access, &base[membrane_base_rows * row + 3]);
  const MatchedFrame<Number> frame = match_frame(access, e1, e2, access.load(constants[MembraneRow::k1]),
                                                 access.load(constants[MembraneRow::k2]));
  relax_strain(access, constants, frame, frame_strain(access, constants, frame, b.p - a.p, c.p - a.p), a, b, c);
  access.scatter(velocities, corners[0], a);
  access.scatter(velocities, corners[1], b);
  access.scatter(velocities, corners[2], c);
}

}  // namespace drape

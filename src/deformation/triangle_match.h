#pragma once

#include <array>
#include <cmath>

#include "core/vector.h"

namespace drape {

// The rest shape of a cluster of three points, reduced to what matching needs. In the plane of the rest
// triangle, relative to its centre of mass and turned so that q3 = (0, q3y > 0) and q2x > 0.
template <typename Scalar>
struct MatchConstants {
  Scalar q1x, q1y, q2x, q2y, q3y;
  Scalar k1, k2;          // q2y / q2x and (m3 q3y) / (m2 q2x): A_pq without its trigonometry
  Scalar share2, share3;  // m2 / m and m3 / m
};

// Needs three points that are not collinear and positive masses.
MatchConstants<double> match_constants(const std::array<Vec3, 3>& rest, const std::array<double, 3>& masses);

// A unit vector normal to `direction` (which may be zero): what stands in for the normal of collinear points.
template <typename Vector>
Vector any_normal(const Vector& direction) {
  using Scalar = typename Vector::Scalar;
  const Vector axis = std::abs(direction.x()) < std::abs(direction.y()) ? Vector(1, 0, 0) : Vector(0, 1, 0);
  const Vector normal = direction.cross(axis);
  const Scalar length = normal.norm();
  return length > 0 ? Vector(normal / length) : Vector(0, 0, 1);
}

// The two columns r1, r2 of the optimal rotation of the rest plane, from the edges e1 = x2 - x1 and e2 = x3 -
// x1: with n the normal of the deformed triangle,
//   r1 = normalise(e1 + v x n),  r2 = n x r1,  v = k1 e1 + k2 e2.
// Collinear points have no normal: any unit vector across them serves.
template <typename Scalar>
std::array<Eigen::Matrix<Scalar, 3, 1>, 2> matched_frame(Scalar k1, Scalar k2,
                                                         const Eigen::Matrix<Scalar, 3, 1>& e1,
                                                         const Eigen::Matrix<Scalar, 3, 1>& e2) {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  const Vector v = k1 * e1 + k2 * e2;
  const Vector normal = e1.cross(e2);
  const Scalar double_area = normal.norm();
  const Vector& longer = e1.squaredNorm() > v.squaredNorm() ? e1 : v;
  const bool collinear = double_area <= Scalar(1e-12) * (e1.squaredNorm() + e2.squaredNorm());
  const Vector n = collinear ? any_normal(longer) : Vector(normal / double_area);
  const Vector a = e1 + v.cross(n);
  const Scalar length = a.norm();
  const Vector r1 = length > 0 ? Vector(a / length) : any_normal(n);
  return {r1, n.cross(r1)};
}

// What takes each of the three points to its goal: the rest triangle, rotated and moved to fit the points
// best with their masses (least squares). Section 4.1 and Appendix A of the paper in closed form. The
// appendix prints R without its normalisation, and its goals in the frame of the rest shape; both are mended
// here. Points that all coincide stay.
template <typename Scalar>
std::array<Eigen::Matrix<Scalar, 3, 1>, 3> match_displacements(const MatchConstants<Scalar>& rest,
                                                               const Eigen::Matrix<Scalar, 3, 1>& x1,
                                                               const Eigen::Matrix<Scalar, 3, 1>& x2,
                                                               const Eigen::Matrix<Scalar, 3, 1>& x3) {
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  const Vector e1 = x2 - x1;
  const Vector e2 = x3 - x1;
  if (!(e1.squaredNorm() + e2.squaredNorm() > 0)) return {Vector::Zero(), Vector::Zero(), Vector::Zero()};
  const auto [r1, r2] = matched_frame<Scalar>(rest.k1, rest.k2, e1, e2);
  const Vector centre = rest.share2 * e1 + rest.share3 * e2;  // of mass, from x1
  return {centre + rest.q1x * r1 + rest.q1y * r2, centre - e1 + rest.q2x * r1 + rest.q2y * r2,
          centre - e2 + rest.q3y * r2};
}

}  // namespace drape

#include "core/symmetric_eigen.h"

#include <cmath>

namespace drape {
namespace {

// The turn that takes a(p, q) away: cosine and sine.
std::pair<double, double> jacobi_turn(const Mat3& a, int p, int q) {
  const double cotangent = (a(q, q) - a(p, p)) / (2 * a(p, q));  // of twice the angle
  const double tangent =
      std::copysign(1 / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent)), cotangent);
  const double cosine = 1 / std::sqrt(1 + tangent * tangent);
  return {cosine, tangent * cosine};
}

void turn_columns(Mat3& a, int p, int q, double cosine, double sine) {
  for (int i = 0; i < 3; ++i) {
    const double in_p = a(i, p), in_q = a(i, q);
    a(i, p) = cosine * in_p - sine * in_q;
    a(i, q) = sine * in_p + cosine * in_q;
  }
}

void turn_rows(Mat3& a, int p, int q, double cosine, double sine) {
  for (int j = 0; j < 3; ++j) {
    const double in_p = a(p, j), in_q = a(q, j);
    a(p, j) = cosine * in_p - sine * in_q;
    a(q, j) = sine * in_p + cosine * in_q;
  }
}

}  // namespace

SymmetricEigen symmetric_eigen(const Mat3& matrix) {
  constexpr int sweeps = 8;  // convergence is quadratic: five leave nothing in practice
  Mat3 a = matrix, vectors = Mat3::Identity();
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
      if (!(std::abs(a(p, q)) > 0)) continue;
      const auto [cosine, sine] = jacobi_turn(a, p, q);
      turn_columns(a, p, q, cosine, sine);
      turn_rows(a, p, q, cosine, sine);
      turn_columns(vectors, p, q, cosine, sine);
    }
  return {a.diagonal(), vectors};
}

}  // namespace drape

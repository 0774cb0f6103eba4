#include "deformation/membrane_material.h"

#include <algorithm>
#include <cmath>

#include "core/symmetric_eigen.h"

namespace drape {

// Strains (along, across, angle) in axes turned by the angle of `axis`, from those in the axes at hand.
static Mat3 strain_rotation(const Vec2& axis) {
  const double c = axis.x(), s = axis.y();
  Mat3 rotation;
  rotation << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
  return rotation;
}

// `along`, `across` and `shear` in the material's own axes, coupled by Poisson's ratio; turned to the axes in
// which the warp lies along `warp`.
static Mat3 orthotropic(double along, double across, double shear, double poisson_ratio, const Vec2& warp) {
  const double coupling = poisson_ratio * std::sqrt(along * across);
  const double confined = 1 - poisson_ratio * poisson_ratio;
  Mat3 tensor;
  tensor << along / confined, coupling / confined, 0, coupling / confined, across / confined, 0, 0, 0, shear;
  const Mat3 rotation = strain_rotation(warp);
  return rotation.transpose() * tensor * rotation;
}

Mat3 membrane_tensor(const ElasticMaterial& material, const Vec2& warp) {
  return orthotropic(material.stretch_stiffness[0], material.stretch_stiffness[1], material.shear_stiffness,
                     material.poisson_ratio, warp);
}

Mat3 bending_tensor(const ElasticMaterial& material, const Vec2& warp) {
  // Flexural rigidity is measured on strips, free at their sides: B, not B / (1 - nu2).
  const auto& [along, across] = material.bend_stiffness;
  const double twist = 0.5 * std::sqrt(along * across) / (1 + material.poisson_ratio);
  return orthotropic(along, across, twist, material.poisson_ratio, warp);
}

// C^-1/2.
static Mat3 inverse_root(const Mat3& tensor) {
  const SymmetricEigen eigen = symmetric_eigen(tensor);
  return eigen.vectors * eigen.values.cwiseSqrt().cwiseInverse().asDiagonal() * eigen.vectors.transpose();
}

// Strains (along, across, angle) of a strain of 1 along the direction.
static Vec3 strain_along(const Vec2& d) { return {d.x() * d.x(), d.y() * d.y(), d.x() * d.y()}; }

double strip_stiffness(const Mat3& compliance, const Vec2& direction) {
  const Vec3 strain = strain_along(direction);
  return 1 / strain.dot(compliance * strain);
}

BarSplit split_into_bars(const Mat3& tensor, const std::array<Vec2, 3>& directions) {
  const Mat3 compliance = tensor.inverse();
  BarSplit split{{}, Mat3::Zero()};
  for (int i = 0; i < 3; ++i) {
    const Vec3 strain = strain_along(directions[i]);
    split.bars[i] = strip_stiffness(compliance, directions[i]);
    split.rest += split.bars[i] * strain * strain.transpose();
  }
  // The bars times 1 / (largest eigenvalue of C^-1 bars) would leave a tensor that is only semidefinite.
  const Mat3 root = inverse_root(tensor);
  const double share = 0.98 / symmetric_eigen(root * split.rest * root).values.maxCoeff();
  for (double& bar : split.bars) bar *= share;
  split.rest = tensor - share * split.rest;
  return split;
}

}  // namespace drape

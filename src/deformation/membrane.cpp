#include "deformation/membrane.h"

#include "deformation/membrane_kernel.h"

namespace drape {

RestFrame rest_frame(const Sheet& sheet, int triangle, const std::vector<double>& masses) {
  const auto& [a, b, c] = sheet.triangles[triangle];
  const std::vector<Vec3>& x = sheet.rest_positions;
  const MatchConstants<double> match = match_constants({x[a], x[b], x[c]}, {masses[a], masses[b], masses[c]});
  const auto [r1, r2] = matched_frame<double>(match.k1, match.k2, x[b] - x[a], x[c] - x[a]);
  const Vec3 warp = warp_in_plane(sheet, triangle);
  const auto in_frame = [&r1 = r1, &r2 = r2](const Vec3& v) { return Vec2(r1.dot(v), r2.dot(v)); };
  return {in_frame(x[b] - x[a]),     in_frame(x[c] - x[a]), in_frame(warp).normalized(), match.k1, match.k2,
          rest_area(sheet, triangle)};
}

namespace {

// Inverse of the rest edges as columns: the deformation gradient is (e1 e2) times it.
Eigen::Matrix2d inverse_shape(const RestFrame& frame) {
  Eigen::Matrix2d shape;
  shape.col(0) = frame.edge1;
  shape.col(1) = frame.edge2;
  return shape.inverse();
}

// J of the strains by the corners' positions in the matched frame, e = J x.
Eigen::Matrix<double, 3, 6> strain_derivative(const Eigen::Matrix2d& inverse) {
  Eigen::Matrix<double, 3, 6> derivative;
  for (Eigen::Index corner = 0; corner < 3; ++corner) {
    const Eigen::RowVector2d d = corner == 0   ? Eigen::RowVector2d(-inverse.row(0) - inverse.row(1))
                                 : corner == 1 ? Eigen::RowVector2d(inverse.row(0))
                                               : Eigen::RowVector2d(inverse.row(1));
    derivative.block<3, 2>(0, 2 * corner) << d[0], 0, 0, d[1], d[1], d[0];
  }
  return derivative;
}

// K = A h2 C (1 + J W J^T A h2 C)^-1, as (C^-1 / (A h2) + J W J^T)^-1 without C's inverse.
Mat3 implicit_stress(const Mat3& tensor, double area_duration_squared, const Eigen::Matrix2d& inverse,
                     const std::array<double, 3>& inverse_masses) {
  const Eigen::Matrix<double, 3, 6> derivative = strain_derivative(inverse);
  Eigen::Matrix<double, 6, 1> masses;
  for (int i = 0; i < 6; ++i) masses[i] = inverse_masses[i / 2];
  const Mat3 response = derivative * masses.asDiagonal() * derivative.transpose();
  const Mat3 stiffness = area_duration_squared * tensor;
  const Mat3 stress = stiffness * (Mat3::Identity() + response * stiffness).inverse();
  return 0.5 * (stress + stress.transpose());
}

template <std::size_t count>
void set(LaneRow* rows, int lane, const std::array<double, count>& values) {
  for (std::size_t i = 0; i < count; ++i) rows[i].values[lane] = static_cast<float>(values[i]);
}

std::array<double, MembraneShape::count> shape_constants(const RestFrame& frame) {
  const Eigen::Matrix2d d = inverse_shape(frame);
  return {frame.k1, frame.k2, d(0, 0), d(0, 1), d(1, 0), d(1, 1)};
}

std::array<double, stress_rows> stress_constants(const RestFrame& frame, const Mat3& tensor,
                                                 double duration_squared,
                                                 const std::array<double, 3>& inverse_masses) {
  const Mat3 k = implicit_stress(tensor, frame.area * duration_squared, inverse_shape(frame), inverse_masses);
  return {k(0, 0), k(0, 1), k(0, 2), k(1, 1), k(1, 2), k(2, 2)};
}

// Fillers have a sound frame and no stress.
constexpr std::array<double, MembraneShape::count> filler_shape = {0, 1};

}  // namespace

MembraneStage build_membrane(const Sheet& sheet, const std::vector<int>& patches,
                             const std::vector<double>& weights, const std::vector<double>& inverse_masses,
                             const MembraneTerms& pull, const MembraneTerms& damping) {
  MembraneStage stage{sweep_order(patches, sheet.triangles), {}, {}, {}, {}};
  const std::size_t rows = stage.order.row_count();
  stage.corners.resize(3 * rows);
  stage.shapes.resize(MembraneShape::count * rows);
  stage.stresses.resize(stress_rows * rows, LaneRow{});
  stage.dampings.resize(stress_rows * rows, LaneRow{});
  for_each_lane(stage.order, weights.size(), [&](int triangle, std::size_t row, int lane, int filler) {
    for (std::size_t k = 0; k < 3; ++k)
      stage.corners[3 * row + k].set(
          lane, triangle < 0 ? filler + static_cast<int>(k) : sheet.triangles[triangle][k]);
    LaneRow* shape = &stage.shapes[MembraneShape::count * row];
    if (triangle < 0) return set(shape, lane, filler_shape);
    const RestFrame frame = rest_frame(sheet, triangle, weights);
    const Triangle& corners = sheet.triangles[triangle];
    const std::array<double, 3> masses = {inverse_masses[corners[0]], inverse_masses[corners[1]],
                                          inverse_masses[corners[2]]};
    const auto stress = [&](const MembraneTerms& terms) {
      return stress_constants(frame, terms.tensors[triangle], terms.duration_squared, masses);
    };
    set(shape, lane, shape_constants(frame));
    set(&stage.stresses[stress_rows * row], lane, stress(pull));
    set(&stage.dampings[stress_rows * row], lane, stress(damping));
  });
  std::vector<int>().swap(stage.order.elements);
  return stage;
}

void load_membrane(const MembraneStage& stage, const SplitPoints& start, std::vector<LaneRow>& base) {
  base.resize(membrane_base_rows * stage.order.row_count());
  parallel_for_each(stage.order.row_count(), 128, [&](std::size_t row) {
    load_membrane_row<Lanes>(stage, start, row, {}, &base[membrane_base_rows * row]);
  });
}

void pull_membrane(const MembraneStage& stage, const std::vector<LaneRow>& base,
                   std::vector<Point4>& offsets) {
  sweep(stage.order,
        [&](const RowRange& rows) { pull_membrane_tile<Lanes>(stage, base, rows, {}, offsets.data()); });
}

void damp_membrane(const MembraneStage& stage, const std::vector<LaneRow>& base,
                   std::vector<Point4>& velocities) {
  sweep(stage.order,
        [&](const RowRange& rows) { damp_membrane_tile<Lanes>(stage, base, rows, {}, velocities.data()); });
}

}  // namespace drape

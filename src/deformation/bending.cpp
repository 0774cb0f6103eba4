#include "deformation/bending.h"

#include <algorithm>
#include <cmath>

#include "core/symmetric_eigen.h"
#include "deformation/bending_kernel.h"
#include "deformation/membrane_material.h"

namespace drape {

std::array<int, 6> bending_corners(const Sheet& sheet, int triangle) {
  const Triangle& own = sheet.triangles[triangle];
  std::array<int, 6> corners = {own[0], own[1], own[2], -1, -1, -1};
  for (int k = 0; k < 3; ++k) {
    const int outer = opposite_vertex(sheet.topology, sheet.triangles, triangle, k);
    if (std::find(corners.begin(), corners.end(), outer) == corners.end()) corners[3 + k] = outer;
  }
  return corners;
}

namespace {

using SixByThree = Eigen::Matrix<double, 6, 3>;
using ThreeBySix = Eigen::Matrix<double, 3, 6>;

// One cluster in the plane of its own triangle, lengths in units of the root of twice its area. Rows of
// corners that are missing are zeros.
struct Cluster {
  SixByThree affine = SixByThree::Zero();  // 1, u, v of each corner
  SixByThree quadratic =
      SixByThree::Zero();           // u2/2, v2/2, uv/2: curvatures are along, across, twice the twist
  std::array<double, 6> heights{};  // over the plane, in m
  double unit = 1;                  // m
  Vec2 warp = Vec2::Zero();
};

bool has_corner(const Cluster& cluster, int corner) { return cluster.affine(corner, 0) != 0; }

Cluster flatten(const Sheet& sheet, int triangle, const std::array<int, 6>& corners) {
  const std::vector<Vec3>& x = sheet.rest_positions;
  const Vec3 origin = x[corners[0]];
  const Vec3 axis = (x[corners[1]] - origin).normalized();
  const Vec3 normal = (x[corners[1]] - origin).cross(x[corners[2]] - origin).normalized();
  const Vec3 across = normal.cross(axis), warp = warp_in_plane(sheet, triangle);
  Cluster cluster;
  cluster.unit = std::sqrt(2 * rest_area(sheet, triangle));
  cluster.warp = Vec2(axis.dot(warp), across.dot(warp));
  for (int i = 0; i < 6; ++i) {
    if (corners[i] < 0) continue;
    const Vec3 from_origin = (x[corners[i]] - origin) / cluster.unit;
    const double u = axis.dot(from_origin), v = across.dot(from_origin);
    cluster.affine.row(i) << 1, u, v;
    cluster.quadratic.row(i) << 0.5 * u * u, 0.5 * v * v, 0.5 * u * v;
    cluster.heights[i] = normal.dot(from_origin) * cluster.unit;
  }
  return cluster;
}

// s_j, then t_j, of bending.h.
std::array<double, coordinate_rows> outer_coordinates(const Cluster& cluster) {
  std::array<double, coordinate_rows> coordinates{};
  Eigen::Matrix2d edges;
  for (int i = 0; i < 2; ++i)
    edges.col(i) = (cluster.affine.row(i + 1) - cluster.affine.row(0)).tail<2>().transpose();
  const Eigen::Matrix2d inverse = edges.inverse();
  for (int j = 3; j < 6; ++j) {
    if (!has_corner(cluster, j)) continue;
    const Vec2 found = inverse * (cluster.affine.row(j) - cluster.affine.row(0)).tail<2>().transpose();
    coordinates[j - 3] = found[0];
    coordinates[j] = found[1];
  }
  return coordinates;
}

// Rows orthonormal to each other and to every affine function of the plane: the basis of outer corners
// (bending.h), by Gram and Schmidt. A row is zero where its outer corner is missing.
ThreeBySix affine_complement(const Cluster& cluster) {
  const std::array<double, coordinate_rows> coordinates = outer_coordinates(cluster);
  ThreeBySix q = ThreeBySix::Zero();
  for (int j = 0; j < 3; ++j) {
    if (!has_corner(cluster, 3 + j)) continue;
    const double s = coordinates[j], t = coordinates[3 + j];
    q.row(j).head<3>() << s + t - 1, -s, -t;
    q(j, 3 + j) = 1;
    for (int i = 0; i < j; ++i) q.row(j) -= q.row(j).dot(q.row(i)) * q.row(i);
    q.row(j) /= q.row(j).norm();
  }
  return q;
}

// Six points near a conic leave one curvature nearly undetermined: it gets no less than this share of the
// whole compliance. All others keep theirs, or thin triangles and stiff warps would bend too easily.
Mat3 at_least(double share, const Mat3& compliance) {
  const SymmetricEigen eigen = symmetric_eigen(compliance);
  const Vec3 values = eigen.values.cwiseMax(share * compliance.trace());
  return eigen.vectors * values.asDiagonal() * eigen.vectors.transpose();
}

// L of a symmetric matrix whose rows of missing corners are zeros.
Mat3 lower_root(const Mat3& matrix) {
  Mat3 lower = Mat3::Zero();
  for (int j = 0; j < 3; ++j) {
    const double left = matrix(j, j) - lower.row(j).squaredNorm();
    if (!(left > 0)) continue;
    lower(j, j) = std::sqrt(left);
    for (int i = j + 1; i < 3; ++i)
      lower(i, j) = (matrix(i, j) - lower.row(i).dot(lower.row(j))) / lower(j, j);
  }
  return lower;
}

// With S = (G D^-1 G^T)^-1, the least energy of a quadratic surface that has the residuals r is 1/2 A r^T S r
// (for six points G is square, and S = G^-T D G^-1); its implicit step is K = (S^-1 / (A h2) + q W q^T)^-1. L
// of it, for the outer corners: as each is in one residual of their basis alone, and with weight 1, q's
// columns there turn residuals of that basis into those of q.
Mat3 step_root(const Cluster& cluster, const Mat3& bending, double area_duration_squared,
               const Eigen::Matrix<double, 6, 1>& inverse_masses) {
  if (!(area_duration_squared > 0)) return Mat3::Zero();
  const ThreeBySix q = affine_complement(cluster);
  const Mat3 g = cluster.unit * cluster.unit * q * cluster.quadratic;
  const Mat3 compliance = at_least(1e-3, g * bending.inverse() * g.transpose());
  const Mat3 response = q * inverse_masses.asDiagonal() * q.transpose();
  const Mat3 step = (compliance / area_duration_squared + response).inverse();
  return lower_root(q.rightCols<3>().transpose() * step * q.rightCols<3>());
}

// rho'. The own corners lie in the plane, so that r_j is the height of outer corner j.
Vec3 rest_residuals(const Cluster& cluster, const Mat3& lower) {
  return lower.transpose() * Vec3(cluster.heights[3], cluster.heights[4], cluster.heights[5]);
}

bool bends(const Sheet& sheet, int triangle) {
  const auto& [along, across] = material_of(sheet, triangle).bend_stiffness;
  return along > 0 && across > 0;
}

// The triangles that have an outer corner, and their corners.
struct Clusters {
  std::vector<int> triangles;
  std::vector<std::array<int, 6>> corners;
};

Clusters clusters_that_bend(const Sheet& sheet) {
  Clusters clusters;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    const std::array<int, 6> corners = bending_corners(sheet, t);
    const bool alone = *std::max_element(corners.begin() + 3, corners.end()) < 0;
    if (alone || !bends(sheet, t)) continue;
    clusters.triangles.push_back(t);
    clusters.corners.push_back(corners);
  }
  return clusters;
}

// Rest shapes flat to this share of an edge count as flat.
bool is_curved(const Sheet& sheet, const Clusters& clusters) {
  constexpr double flatness = 1e-6;
  for (std::size_t i = 0; i < clusters.triangles.size(); ++i) {
    const Cluster cluster = flatten(sheet, clusters.triangles[i], clusters.corners[i]);
    for (const double height : cluster.heights)
      if (std::abs(height) > flatness * cluster.unit) return true;
  }
  return false;
}

// At the rim of a clamp the sheet bends on one side only: a row of folds there turns half as far as the
// curvature says, and needs twice a row's stiffness. Half of one row's is that of the triangles outside;
// those within, whose own corners are all pinned, have three halves.
double area_share(const std::array<int, 6>& corners, const std::vector<double>& inverse_masses) {
  const bool clamped =
      std::all_of(corners.begin(), corners.begin() + 3, [&](int v) { return !(inverse_masses[v] > 0); });
  return clamped ? 3 : 1;
}

struct ClusterRoots {
  Mat3 pull, damping;
};

ClusterRoots cluster_roots(const Sheet& sheet, int triangle, const std::array<int, 6>& corners,
                           const Cluster& cluster, const std::vector<double>& inverse_masses,
                           double pull_duration_squared, double damping_duration_squared) {
  Eigen::Matrix<double, 6, 1> masses = Eigen::Matrix<double, 6, 1>::Zero();
  for (int i = 0; i < 6; ++i)
    if (corners[i] >= 0) masses[i] = inverse_masses[corners[i]];
  const Mat3 bending = bending_tensor(material_of(sheet, triangle), cluster.warp);
  const double area = rest_area(sheet, triangle) * area_share(corners, inverse_masses);
  return {step_root(cluster, bending, area * pull_duration_squared, masses),
          step_root(cluster, bending, area * damping_duration_squared, masses)};
}

void set_lower(const Mat3& lower, int lane, LaneRow* rows) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) (rows++)->values[lane] = static_cast<float>(lower(i, j));
}

BendingStage sized_stage(const std::vector<int>& patches, const Clusters& clusters, bool curved) {
  BendingStage stage;
  stage.order = sweep_order(patches, clusters.corners);
  stage.curved = curved;
  const std::size_t rows = stage.order.row_count();
  stage.corners.resize(6 * rows);
  stage.coordinates.resize(coordinate_rows * rows, LaneRow{});
  stage.steps.resize(bending_step_rows * rows, LaneRow{});
  stage.dampings.resize(bending_step_rows * rows, LaneRow{});
  if (curved) stage.rest.resize(3 * rows, LaneRow{});
  return stage;
}

}  // namespace

BendingStage build_bending(const Sheet& sheet, const std::vector<int>& patches,
                           const std::vector<double>& inverse_masses, double pull_duration_squared,
                           const std::vector<double>& damping_durations_squared) {
  const Clusters clusters = clusters_that_bend(sheet);
  BendingStage stage = sized_stage(patches, clusters, is_curved(sheet, clusters));
  for_each_lane(stage.order, inverse_masses.size(), [&](int element, std::size_t row, int lane, int filler) {
    for (std::size_t i = 0; i < 6; ++i) {
      const int vertex = element < 0 ? -1 : clusters.corners[element][i];
      stage.corners[6 * row + i].set(lane, vertex < 0 ? filler : vertex);
    }
    if (element < 0) return;
    const int triangle = clusters.triangles[element];
    const std::array<int, 6>& corners = clusters.corners[element];
    const Cluster cluster = flatten(sheet, triangle, corners);
    const ClusterRoots roots =
        cluster_roots(sheet, triangle, corners, cluster, inverse_masses, pull_duration_squared,
                      damping_durations_squared[sheet.triangle_materials[triangle]]);
    const auto coordinates = outer_coordinates(cluster);
    for (std::size_t i = 0; i < coordinate_rows; ++i)
      stage.coordinates[coordinate_rows * row + i].values[lane] = static_cast<float>(coordinates[i]);
    set_lower(roots.pull, lane, &stage.steps[bending_step_rows * row]);
    set_lower(roots.damping, lane, &stage.dampings[bending_step_rows * row]);
    const Vec3 rest = rest_residuals(cluster, roots.pull);
    for (int j = 0; stage.curved && j < 3; ++j)
      stage.rest[3 * row + static_cast<std::size_t>(j)].values[lane] = static_cast<float>(rest[j]);
  });
  std::vector<int>().swap(stage.order.elements);
  return stage;
}

void load_bending(const BendingStage& stage, const SplitPoints& start, std::vector<LaneRow>& base) {
  const std::size_t height = bending_base_rows(stage);
  base.resize(height * stage.order.row_count());
  parallel_for_each(stage.order.row_count(), 128, [&](std::size_t row) {
    load_bending_row<Lanes>(stage, start, row, {}, &base[height * row]);
  });
}

void pull_bending(const BendingStage& stage, const std::vector<LaneRow>& base, std::vector<Point4>& offsets) {
  sweep(stage.order,
        [&](const RowRange& rows) { pull_bending_tile<Lanes>(stage, base, rows, {}, offsets.data()); });
}

void damp_bending(const BendingStage& stage, std::vector<Point4>& velocities) {
  sweep(stage.order,
        [&](const RowRange& rows) { damp_bending_tile<Lanes>(stage, rows, {}, velocities.data()); });
}

}  // namespace drape

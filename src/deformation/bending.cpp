#include "deformation/bending.h"

#include <algorithm>
#include <cmath>

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

// One cluster in the plane of its own triangle, lengths in units of the root of twice its area.
struct Cluster {
  std::vector<std::size_t> present;  // which of the six corners there are
  Eigen::MatrixXd affine;            // 1, u, v of each
  Eigen::MatrixXd quadratic;         // u2/2, v2/2, uv/2 of each: the curvatures are along, across, twice the twist
  Eigen::VectorXd heights;           // over the plane
  double unit;                       // m
  Vec2 warp;
};

Cluster flatten(const Sheet& sheet, int triangle, const std::array<int, 6>& corners) {
  const std::vector<Vec3>& x = sheet.rest_positions;
  const Vec3 origin = x[corners[0]];
  const Vec3 axis = (x[corners[1]] - origin).normalized();
  const Vec3 normal = (x[corners[1]] - origin).cross(x[corners[2]] - origin).normalized();
  const Vec3 across = normal.cross(axis), warp = warp_in_plane(sheet, triangle);
  Cluster cluster;
  for (std::size_t i = 0; i < 6; ++i)
    if (corners[i] >= 0) cluster.present.push_back(i);
  const auto count = static_cast<Eigen::Index>(cluster.present.size());
  cluster.unit = std::sqrt(2 * rest_area(sheet, triangle));
  cluster.warp = Vec2(axis.dot(warp), across.dot(warp));
  cluster.affine.resize(count, 3);
  cluster.quadratic.resize(count, 3);
  cluster.heights.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 from_origin = (x[corners[cluster.present[static_cast<std::size_t>(i)]]] - origin) / cluster.unit;
    const double u = axis.dot(from_origin), v = across.dot(from_origin);
    cluster.affine.row(i) << 1, u, v;
    cluster.quadratic.row(i) << 0.5 * u * u, 0.5 * v * v, 0.5 * u * v;
    cluster.heights[i] = normal.dot(from_origin) * cluster.unit;
  }
  return cluster;
}

// Rows orthonormal to each other and to every affine function of the plane.
Eigen::MatrixXd affine_complement(const Cluster& cluster) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(cluster.affine);
  const Eigen::MatrixXd q = qr.householderQ();
  return q.rightCols(q.cols() - 3).transpose();
}

// Six points near a conic leave one curvature nearly undetermined: it gets no less than this share of the whole
// compliance. All others keep theirs, or thin triangles and stiff warps would bend too easily.
Eigen::MatrixXd at_least(double share, const Eigen::MatrixXd& compliance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(compliance);
  const Eigen::VectorXd values = solver.eigenvalues().cwiseMax(share * compliance.trace());
  return solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
}

struct ClusterConstants {
  std::array<double, 18> weights{};
  std::array<double, 3> rest{};
};

// With S = (G D^-1 G^T)^-1, the least energy of a quadratic surface that has the residuals r is 1/2 A r^T S r (for
// six points G is square, and S = G^-T D G^-1); its implicit step is K = (S^-1 / (A h2) + q W q^T)^-1.
ClusterConstants cluster_constants(const Cluster& cluster, const Mat3& bending, double area_duration_squared,
                                   const Eigen::VectorXd& inverse_masses) {
  const Eigen::MatrixXd q = affine_complement(cluster);
  const Eigen::MatrixXd g = cluster.unit * cluster.unit * q * cluster.quadratic;
  const Eigen::MatrixXd compliance = at_least(1e-3, g * bending.inverse() * g.transpose());
  const Eigen::MatrixXd response = q * inverse_masses.asDiagonal() * q.transpose();
  const Eigen::MatrixXd step = (compliance / area_duration_squared + response).inverse();
  const Eigen::MatrixXd scaled = step.llt().matrixL().transpose() * q;
  const Eigen::VectorXd rest = scaled * cluster.heights;
  ClusterConstants constants;
  for (Eigen::Index j = 0; j < scaled.rows(); ++j) {
    constants.rest[static_cast<std::size_t>(j)] = rest[j];
    for (Eigen::Index i = 0; i < scaled.cols(); ++i)
      constants.weights[6 * static_cast<std::size_t>(j) + cluster.present[static_cast<std::size_t>(i)]] = scaled(j, i);
  }
  return constants;
}

bool bends(const Sheet& sheet, int triangle, const std::vector<double>& durations_squared) {
  const auto& [along, across] = material_of(sheet, triangle).bend_stiffness;
  return along > 0 && across > 0 && durations_squared[sheet.triangle_materials[triangle]] > 0;
}

// The triangles that have an outer corner, and their corners.
struct Clusters {
  std::vector<int> triangles;
  std::vector<std::array<int, 6>> corners;
};

Clusters clusters_that_bend(const Sheet& sheet, const std::vector<double>& durations_squared) {
  Clusters clusters;
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    const std::array<int, 6> corners = bending_corners(sheet, t);
    const bool alone = *std::max_element(corners.begin() + 3, corners.end()) < 0;
    if (alone || !bends(sheet, t, durations_squared)) continue;
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
    if (cluster.heights.cwiseAbs().maxCoeff() > flatness * cluster.unit) return true;
  }
  return false;
}

// At the rim of a clamp the sheet bends on one side only: a row of folds there turns half as far as the curvature
// says, and needs twice a row's stiffness. Half of one row's is that of the triangles outside; those within, whose
// own corners are all pinned, have three halves.
double area_share(const std::array<int, 6>& corners, const std::vector<double>& inverse_masses) {
  const bool clamped =
      std::all_of(corners.begin(), corners.begin() + 3, [&](int v) { return !(inverse_masses[v] > 0); });
  return clamped ? 3 : 1;
}

ClusterConstants constants_of(const Sheet& sheet, int triangle, const std::array<int, 6>& corners,
                              const std::vector<double>& inverse_masses, double duration_squared) {
  const Cluster cluster = flatten(sheet, triangle, corners);
  Eigen::VectorXd masses(static_cast<Eigen::Index>(cluster.present.size()));
  for (std::size_t i = 0; i < cluster.present.size(); ++i)
    masses[static_cast<Eigen::Index>(i)] = inverse_masses[corners[cluster.present[i]]];
  const Mat3 bending = bending_tensor(material_of(sheet, triangle), cluster.warp);
  const double area = rest_area(sheet, triangle) * area_share(corners, inverse_masses);
  return cluster_constants(cluster, bending, area * duration_squared, masses);
}

}  // namespace

BendingStage build_bending(const Sheet& sheet, const std::vector<int>& patches,
                           const std::vector<double>& inverse_masses, const BendingTerms& terms) {
  const Clusters clusters = clusters_that_bend(sheet, terms.durations_squared);
  BendingStage stage;
  stage.order = sweep_order(patches, clusters.corners);
  stage.curved = terms.rest_curvature && is_curved(sheet, clusters);
  stage.corners.resize(6 * stage.order.row_count());
  stage.weights.resize(18 * stage.order.row_count(), LaneRow{});
  if (stage.curved) stage.rest.resize(3 * stage.order.row_count(), LaneRow{});
  for_each_lane(stage.order, inverse_masses.size(), [&](int element, std::size_t row, int lane, int filler) {
    for (std::size_t i = 0; i < 6; ++i) {
      const int vertex = element < 0 ? -1 : clusters.corners[element][i];
      stage.corners[6 * row + i].set(lane, vertex < 0 ? filler : vertex);
    }
    if (element < 0) return;
    const int triangle = clusters.triangles[element];
    const ClusterConstants constants =
        constants_of(sheet, triangle, clusters.corners[element], inverse_masses,
                     terms.durations_squared[sheet.triangle_materials[triangle]]);
    for (std::size_t i = 0; i < 18; ++i)
      stage.weights[18 * row + i].values[lane] = static_cast<float>(constants.weights[i]);
    for (std::size_t j = 0; stage.curved && j < 3; ++j)
      stage.rest[3 * row + j].values[lane] = static_cast<float>(constants.rest[j]);
  });
  return stage;
}

namespace {

void store(const Vec3& value, int lane, LaneRow* rows) {
  for (int i = 0; i < 3; ++i) rows[i].values[lane] = static_cast<float>(value[i]);
}

void load_cluster(const BendingStage& stage, const std::vector<Vec3>& start, std::size_t row, int lane,
                  LaneRow* rows) {
  Vec3 points[6];
  for (std::size_t i = 0; i < 6; ++i) {
    const auto vertex = static_cast<std::size_t>(stage.corners[6 * row + i].vertex(lane));
    points[i] = vertex < start.size() ? start[vertex] : Vec3(Vec3::Zero());
  }
  const Vec3 origin = points[0];  // the weights add up to 0 to seven digits only
  for (int j = 0; j < 3; ++j) {
    Vec3 sum = Vec3::Zero();
    for (int i = 1; i < 6; ++i)
      sum += static_cast<double>(stage.weights[18 * row + static_cast<std::size_t>(6 * j + i)].values[lane]) *
             (points[i] - origin);
    store(sum, lane, rows + 3 * j);
  }
  if (!stage.curved) return;
  store(points[1] - origin, lane, rows + 9);
  store(points[2] - origin, lane, rows + 12);
}

}  // namespace

void load_bending(const BendingStage& stage, const std::vector<Vec3>& start, std::vector<LaneRow>& base) {
  const std::size_t height = bending_base_rows(stage);
  base.resize(height * stage.order.row_count());
  parallel_for_each(stage.order.row_count(), 512, [&](std::size_t row) {
    for (int lane = 0; lane < Lanes::count; ++lane) load_cluster(stage, start, row, lane, &base[height * row]);
  });
}

void pull_bending(const BendingStage& stage, const std::vector<LaneRow>& base, std::vector<Point4>& offsets) {
  sweep(stage.order, [&](std::size_t row) { pull_bending_row<Lanes>(stage, base, row, {}, offsets.data()); });
}

void damp_bending(const BendingStage& stage, std::vector<Point4>& velocities) {
  sweep(stage.order, [&](std::size_t row) { damp_bending_row<Lanes>(stage, row, {}, velocities.data()); });
}

}  // namespace drape

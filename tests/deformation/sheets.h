#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "deformation/sheet.h"
#include "mesh/primitives.h"

namespace drape::test {

// Numbers that are the same in every run.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  Vec3 vector(double size = 1) {
    const double x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }
  Mat3 matrix() {
    Mat3 m;
    for (int column = 0; column < 3; ++column) m.col(column) = vector();
    return m;
  }
  Mat3 rotation() {
    const Vec3 axis = vector().normalized();
    return Eigen::AngleAxisd(between(-3, 3), axis).toRotationMatrix();
  }

 private:
  std::mt19937 engine_;
};

inline Sheet sheet_of(const TriangleMesh& mesh, const ElasticMaterial& material = {}) {
  return {mesh.positions,
          mesh.triangles,
          std::vector<int>(mesh.triangles.size(), 0),
          {material},
          build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles)};
}

// A flat, irregular sheet with edges of about one tenth of a metre.
inline TriangleMesh jittered_grid(int points, unsigned seed = 1) {
  Random random(seed);
  TriangleMesh mesh = make_grid({0.1 * (points - 1), 0.1 * (points - 1)}, {points, points});
  for (Vec3& x : mesh.positions) x += Vec3(random.between(-0.03, 0.03), 0, random.between(-0.03, 0.03));
  return mesh;
}

inline TriangleMesh tetrahedron() {
  TriangleMesh mesh;
  mesh.positions = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  return mesh;
}

// Triangles round one point, not closed.
inline TriangleMesh fan(int triangles) {
  TriangleMesh mesh;
  mesh.positions = {Vec3::Zero()};
  for (int i = 0; i <= triangles; ++i) mesh.positions.emplace_back(std::cos(0.6 * i), 0, -std::sin(0.6 * i));
  for (int i = 0; i < triangles; ++i) mesh.triangles.push_back({0, i + 1, i + 2});
  return mesh;
}

// Two triangles of sides `side` with the edge (0, 1) in common, folded by `angle` (0 is flat).
inline TriangleMesh equilateral_pair(double side, double angle) {
  const double height = 0.5 * std::sqrt(3) * side;
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0},
                    {side, 0, 0},
                    {side / 2, 0, height},
                    {side / 2, height * std::sin(angle), -height * std::cos(angle)}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}};
  return mesh;
}

inline std::vector<Vec3> moved(std::vector<Vec3> x, const Mat3& matrix, const Vec3& shift) {
  for (Vec3& point : x) point = matrix * point + shift;
  return x;
}

inline std::vector<Vec3> shaken(std::vector<Vec3> x, double size, Random& random) {
  for (Vec3& point : x) point += random.vector(size);
  return x;
}

inline std::vector<double> inverses(const std::vector<double>& masses) {
  std::vector<double> inverse;
  for (const double mass : masses) inverse.push_back(1 / mass);
  return inverse;
}

inline std::vector<double> random_masses(std::size_t count, Random& random) {
  std::vector<double> masses;
  for (std::size_t i = 0; i < count; ++i) masses.push_back(random.between(0.5, 2));
  return masses;
}

inline double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

// sum m (after - before), over sum m |after - before|.
inline double relative_momentum(const std::vector<double>& masses, const std::vector<Vec3>& before,
                                const std::vector<Vec3>& after) {
  Vec3 sum = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    sum += masses[i] * (after[i] - before[i]);
    size += masses[i] * (after[i] - before[i]).norm();
  }
  return size > 0 ? sum.norm() / size : 0;
}

// sum m before x (after - before), over the sum of the lengths.
inline double relative_angular_momentum(const std::vector<double>& masses, const std::vector<Vec3>& before,
                                        const std::vector<Vec3>& after) {
  Vec3 sum = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < masses.size(); ++i) {
    sum += masses[i] * before[i].cross(after[i] - before[i]);
    size += masses[i] * before[i].norm() * (after[i] - before[i]).norm();
  }
  return size > 0 ? sum.norm() / size : 0;
}

}  // namespace drape::test

#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/lanes.h"
#include "deformation/sheet.h"
#include "deformation/split_points.h"
#include "deformation/sweep_order.h"
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

inline Sheet sheet_of(const TriangleMesh& mesh, const ElasticMaterial& material = {},
                      const Vec3& warp = Vec3(1, 0, 0)) {
  return {mesh.positions,
          mesh.triangles,
          std::vector<int>(mesh.triangles.size(), 0),
          {material},
          {warp},
          build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles)};
}

// A flat, irregular sheet with edges of about one tenth of a metre.
inline TriangleMesh jittered_grid(int points, unsigned seed = 1) {
  Random random(seed);
  TriangleMesh mesh = make_grid({0.1 * (points - 1), 0.1 * (points - 1)}, {points, points});
  for (Vec3& x : mesh.positions) x += Vec3(random.between(-0.03, 0.03), 0, random.between(-0.03, 0.03));
  return mesh;
}

// A grid whose cells are cut along one diagonal and the other by turns.
inline TriangleMesh alternating_grid(const std::array<double, 2>& size, const std::array<int, 2>& points) {
  TriangleMesh mesh = make_grid(size, points);
  mesh.triangles.clear();
  for (int row = 0; row + 1 < points[1]; ++row)
    for (int column = 0; column + 1 < points[0]; ++column) {
      const int a = row * points[0] + column, b = a + 1, c = a + points[0], d = c + 1;
      if ((row + column) % 2 == 0)
        mesh.triangles.insert(mesh.triangles.end(), {Triangle{a, c, d}, Triangle{a, d, b}});
      else
        mesh.triangles.insert(mesh.triangles.end(), {Triangle{a, c, b}, Triangle{b, c, d}});
    }
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

inline std::vector<Vec3> zeros(std::size_t count) { return std::vector<Vec3>(count, Vec3::Zero()); }

inline std::vector<Vec3> sum_of(std::vector<Vec3> a, const std::vector<Vec3>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

inline double longest(const std::vector<Vec3>& vectors) {
  double length = 0;
  for (const Vec3& vector : vectors) length = std::max(length, vector.norm());
  return length;
}

inline bool all_finite(const std::vector<Vec3>& vectors) {
  return std::all_of(vectors.begin(), vectors.end(), [](const Vec3& vector) { return vector.allFinite(); });
}

// All points in one patch, whose fillers need one more point than the mesh has.
inline std::vector<int> one_patch(std::size_t points) { return std::vector<int>(points, 0); }

// What pulls work on: vectors with inverse masses, and a filler.
inline std::vector<Point4> points_of(const std::vector<Vec3>& vectors,
                                     const std::vector<double>& inverse_masses) {
  std::vector<Point4> points;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    const Eigen::Vector3f v = vectors[i].cast<float>();
    points.push_back({v.x(), v.y(), v.z(), static_cast<float>(inverse_masses[i])});
  }
  points.resize(points.size() + fillers_a_patch);
  return points;
}

// Where a step starts, for stages of one patch.
inline SplitPoints split_of(const std::vector<Vec3>& points) {
  SplitPoints split;
  split_points(points, points.size() + fillers_a_patch, split);
  return split;
}

inline std::vector<Vec3> vectors_of(const std::vector<Point4>& points, std::size_t count) {
  std::vector<Vec3> vectors;
  for (std::size_t i = 0; i < count; ++i) vectors.emplace_back(points[i].x, points[i].y, points[i].z);
  return vectors;
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

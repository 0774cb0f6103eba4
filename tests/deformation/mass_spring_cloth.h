#pragma once

#include <cmath>
#include <vector>

#include "deformation/bending_angle.h"
#include "deformation/mass_spring.h"
#include "sheets.h"

namespace drape::test {

// Stretch in N/m in every direction, bending in N m, damping in s.
inline ElasticMaterial spring_material(double stretch, double bend, double damping) {
  ElasticMaterial material;
  material.stretch_stiffness = {stretch, stretch};
  material.shear_stiffness = stretch / 2;
  material.bend_stiffness = {bend, bend};
  material.damping = damping;
  return material;
}

// A cloth of the mass-spring model, at rest until the test moves it.
struct SpringCloth {
  Sheet sheet;
  std::vector<double> masses;
  MassSpringModel model;
  std::vector<Vec3> x, v;
  MassSpringScratch scratch{};

  SpringCloth(const TriangleMesh& mesh, const ElasticMaterial& material, const std::vector<int>& pins = {})
      : sheet(sheet_of(mesh, material)),
        masses(lumped_masses(sheet)),
        x(sheet.rest_positions),
        v(x.size(), Vec3::Zero()) {
    std::vector<char> pinned(x.size(), 0);
    for (const int pin : pins) pinned[pin] = 1;
    model = build_mass_spring(sheet, masses, pinned);
  }

  void advance(double step, const Vec3& gravity = Vec3::Zero()) {
    advance_mass_spring(model, std::vector<Vec3>(x.size(), gravity), step, scratch, x, v);
  }

  // The elastic forces at x, in N: what a step from rest makes of the velocities (without damping).
  std::vector<Vec3> forces() const {
    SpringCloth copy = *this;
    const double step = 1e-3 * model.stable_step;
    copy.v.assign(x.size(), Vec3::Zero());
    copy.advance(step);
    for (std::size_t i = 0; i < x.size(); ++i) copy.v[i] *= masses[i] / step;
    return copy.v;
  }

  double spring_energy() const {
    double sum = 0;
    for (const Spring& spring : model.springs) {
      const double stretch = (x[spring.vertices[1]] - x[spring.vertices[0]]).norm() - spring.rest_length;
      sum += 0.5 * spring.stiffness * stretch * stretch;
    }
    return sum;
  }

  // The integral of stiffness (sin(theta / 2) - sin(theta0 / 2)) over theta, from flat.
  double bending_energy() const {
    double sum = 0;
    for (const BendingElement& element : model.bending) {
      const double sine = bending_angle(element.vertices, x).half_sine, angle = 2 * std::asin(sine);
      sum += element.stiffness * (2 * (1 - std::cos(angle / 2)) - element.rest_sine * angle);
    }
    return sum;
  }

  double energy(const Vec3& gravity = Vec3::Zero()) const {
    double sum = spring_energy() + bending_energy();
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += masses[i] * (0.5 * v[i].squaredNorm() - gravity.dot(x[i]));
    return sum;
  }

  double area() const {
    double sum = 0;
    for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) sum += rest_area(sheet, t);
    return sum;
  }
};

// Equilateral triangles of sides `side` in the plane y = 0, turned by `angle` about the y axis: `rows` + 1
// rows of `columns` + 1 points along x, each second row half a side on.
inline TriangleMesh equilateral_grid(int columns, int rows, double side, double angle = 0) {
  TriangleMesh mesh;
  const int points = columns + 1;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const Vec3 p(side * (column + 0.5 * (row % 2)), 0, side * 0.5 * std::sqrt(3) * row);
      mesh.positions.push_back(Eigen::AngleAxisd(angle, Vec3::UnitY()) * p);
    }
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const int a = row * points + column, b = a + 1, c = a + points, d = c + 1;
      const bool even = row % 2 == 0;
      mesh.triangles.push_back(even ? Triangle{a, c, b} : Triangle{a, c, d});
      mesh.triangles.push_back(even ? Triangle{b, c, d} : Triangle{a, d, b});
    }
  return mesh;
}

}  // namespace drape::test

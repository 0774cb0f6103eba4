#pragma once

#include <array>
#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// Elastic constants of one material, in physical units. Pairs are of warp and weft: the direction that the
// sheet gives, and the one across it.
struct ElasticMaterial {
  double density = 0.2;                                   // kg/m2
  std::array<double, 2> stretch_stiffness{20000, 20000};  // N/m: tension per width at a strain of 1
  double shear_stiffness = 10000;                         // N/m: shear force per width at an angle of 1 rad
  double poisson_ratio = 0;                          // (-1, 1): contraction across, over the strain along
  std::array<double, 2> bend_stiffness{1e-5, 1e-5};  // N m: flexural rigidity
  double damping = 0.005;   // s: stress at a rate of strain, over the stress at that strain (Kelvin-Voigt)
  double strain_limit = 0;  // largest stretch of an edge less 1; 0: none
};

// All cloths of a simulation as one mesh: what elastic elements are built from.
struct Sheet {
  std::vector<Vec3> rest_positions;
  std::vector<Triangle> triangles;
  std::vector<int> triangle_materials;  // indices into materials
  std::vector<ElasticMaterial> materials;
  std::vector<Vec3> warp_directions;  // of each material, in the space of the rest shape
  Topology topology;
};

// Mass of each point in kg: a third of each of its triangles.
std::vector<double> lumped_masses(const Sheet& sheet);

// Of one triangle, in kg.
double triangle_mass(const Sheet& sheet, int triangle);

double rest_area(const Sheet& sheet, int triangle);
double rest_length(const Sheet& sheet, const Edge& edge);
std::vector<double> mean_edge_lengths(const Sheet& sheet);  // of each material, at rest, in m

inline const ElasticMaterial& material_of(const Sheet& sheet, int triangle) {
  return sheet.materials[sheet.triangle_materials[triangle]];
}

// The warp's direction in the plane of a rest triangle, a unit vector. Where the material's direction is
// normal to the triangle: along the triangle's first edge.
Vec3 warp_in_plane(const Sheet& sheet, int triangle);

}  // namespace drape

#pragma once

#include <vector>

#include "mesh/topology.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// Elastic constants of one material, in physical units.
struct ElasticMaterial {
  double density = 0.2;              // kg/m2
  double stretch_stiffness = 20000;  // N/m
  double bend_stiffness = 1e-5;      // N m
  double damping = 50;               // 1/s
};

// All cloths of a simulation as one mesh: what elastic elements are built from.
struct Sheet {
  std::vector<Vec3> rest_positions;
  std::vector<Triangle> triangles;
  std::vector<int> triangle_materials;  // indices into materials
  std::vector<ElasticMaterial> materials;
  Topology topology;
};

// Mass of each point in kg: a third of each of its triangles.
std::vector<double> lumped_masses(const Sheet& sheet);

double rest_area(const Sheet& sheet, int triangle);

}  // namespace drape

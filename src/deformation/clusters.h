#pragma once

#include <array>
#include <vector>

#include "deformation/coloring.h"
#include "deformation/sheet.h"
#include "deformation/triangle_match.h"

namespace drape {

// Three points that are pulled to their rest triangle, rotated and moved to fit. `pull` in (0, 1] is the
// share of the way in one step: alpha of MHTG05, from a stiffness with units.
struct TriangleCluster {
  std::array<int, 3> vertices;
  MatchConstants<double> rest;
  double pull;
};

// Clusters of one kind, colour by colour: all of a colour can be pulled at once.
struct ClusterStage {
  std::vector<TriangleCluster> clusters;
  std::vector<std::size_t> color_begin;
};

// The corners of each triangle: what resists stretch and shear (section 4.1 of the paper rules them out
// because they do not resist bending; without them the clusters below fall apart into four unconnected
// lattices).
std::vector<std::array<int, 3>> own_triangles(const Sheet& sheet);

// For each triangle the corners across its three edges (section 4.1, Fig. 2): what couples neighbours. Where
// one is missing (a boundary) or two coincide, the two that are left and the own corner of best shape; no
// cluster where no choice is well shaped. `materials` gets the triangle's material for each cluster.
std::vector<std::array<int, 3>> outer_corners(const Sheet& sheet, std::vector<int>& materials);

// 2 sqrt(3) |p x q| / (sum of the squared sides): 1 for an equilateral triangle, 0 for collinear points.
double triangle_shape(const Vec3& a, const Vec3& b, const Vec3& c);

// `stiffness[i]` of cluster i in 1/s2; the clusters' potential is 1/2 stiffness sum m |goal - x|2, and one
// pull is its implicit step: alpha = s h2 / (1 + s h2), which no step and no stiffness makes overshoot.
ClusterStage build_cluster_stage(const Sheet& sheet, const std::vector<std::array<int, 3>>& clusters,
                                 const std::vector<double>& stiffness, const std::vector<double>& masses,
                                 double step);

// One Gauss-Seidel sweep. Points of inverse mass 0 stay.
void pull_clusters(const ClusterStage& stage, const std::vector<double>& inverse_masses,
                   std::vector<Vec3>& x);

}  // namespace drape

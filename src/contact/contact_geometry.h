#pragma once

#include <array>
#include <vector>

#include "contact/closest_points.h"
#include "core/rigid_motion.h"
#include "mesh/triangle_mesh.h"

namespace drape {

// One cloth or one collider. Its primitives are ranges of the geometry's lists.
struct ContactBody {
  bool is_cloth = true;
  bool is_rigid = false;  // a collider that keeps its shape
  double thickness = 0;   // cloth: the distance that is kept, in m
  double radius = 0;      // collider: what its points and edges are rounded by (sphere, capsule)
  double friction = 0;
  int vertex_begin = 0, vertex_end = 0;
  int edge_begin = 0, edge_end = 0;
  int triangle_begin = 0, triangle_end = 0;
};

// A half space: y <= 0 of a body that has no primitives but this.
struct ContactPlane {
  int body;
};

// All that can touch; fixed once built, but for the inverse masses when a pin lets go. Vertices of cloths
// come first and are those of the simulation; those of colliders follow.
struct ContactGeometry {
  std::vector<ContactBody> bodies;
  std::vector<int> vertex_body;
  std::vector<std::array<int, 2>> edges;
  std::vector<Triangle> triangles;
  std::vector<ContactPlane> planes;
  std::vector<Vec3> rest_positions;    // of all vertices
  std::vector<double> inverse_masses;  // 1/kg; 0: moves on its own way (pinned, collider)
  bool self_collision = true;
};

// A pair that may come close: what is fixed about it.
struct ContactPair {
  std::array<int, 4> vertices;
  PairKind kind;
  bool meets_collider;
  bool counts_edge_ends;  // an edge of no triangle: its closest points at edge ends are nobody else's
  double thickness;       // m, between the surfaces
  double radius;  // m: of rounded colliders; the closest points are farther apart by it than the surfaces
  double friction;
};

// The distance that surfaces keep. Between bodies: half of each cloth's thickness, or all of it against a
// collider. Within a cloth: its thickness, but no more than 2/pi of the distance in the rest
// shape, which bending to a radius of half the thickness never reaches.
double pair_thickness(const ContactGeometry& geometry, PairKind kind, const std::array<int, 4>& vertices);

// The most that pair_thickness gives for the two bodies.
double largest_thickness(const ContactGeometry& geometry, int body_a, int body_b);

// What rounded colliders add to the distance of the closest points of their vertices and edges.
double pair_radius(const ContactGeometry& geometry, int body_a, int body_b);

// The geometric mean of the two bodies' coefficients.
double pair_friction(const ContactGeometry& geometry, int body_a, int body_b);

// The body on each side of a pair.
std::array<int, 2> pair_bodies(const ContactGeometry& geometry, PairKind kind,
                               const std::array<int, 4>& vertices);

inline FourPoints gather(const std::vector<Vec3>& x, const std::array<int, 4>& vertices) {
  return {x[vertices[0]], x[vertices[1]], x[vertices[2]], x[vertices[3]]};
}

}  // namespace drape

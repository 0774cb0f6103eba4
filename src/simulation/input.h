#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/rigid_motion.h"
#include "deformation/sheet.h"
#include "mesh/triangle_mesh.h"

// What a simulation is made from: plain values, checked by whoever made them.
namespace drape {

struct ClothMaterial {
  ElasticMaterial elastic;
  Vec3 warp{1, 0, 0};        // the warp's direction in the rest shape
  double thickness = 0.005;  // m: the distance that contact keeps between mid-surfaces
  double friction = 0.3;     // Coulomb's coefficient
};

// Vertices that follow a motion, or stay where they start. `motion` turns about the centroid of the vertices.
struct PinInput {
  std::vector<int> vertices;
  std::optional<RigidMotion> motion;
  std::optional<double> until;  // seconds; the vertices are free from then on
};

struct ClothInput {
  std::string name;
  TriangleMesh mesh;                  // its positions are the rest shape
  std::vector<Vec3> start_positions;  // one for each point
  ClothMaterial material;
  std::vector<PinInput> pins;
};

struct PlaneShape {};  // y <= 0 of its own frame is solid
struct SphereShape {
  double radius;
};
struct BoxShape {
  Vec3 size;
};
struct CapsuleShape {
  double radius;
  double length;
};  // along its own y, length between the two centres
struct CylinderShape {
  double radius;
  double height;
};  // along its own y, centred
struct MeshShape {
  TriangleMesh mesh;
};
using ColliderShape = std::variant<PlaneShape, SphereShape, BoxShape, CapsuleShape, MeshShape, CylinderShape>;

struct ColliderInput {
  std::string name;
  ColliderShape shape;
  RigidMotion motion;
  double friction = 0.3;  // a contact uses the geometric mean of the two coefficients
};

struct WindInput {
  Vec3 velocity = Vec3::Zero();  // m/s
  double drag = 1.0;             // coefficient on the normal component
};

struct SimulationInput {
  std::vector<ClothInput> cloths;
  std::vector<ColliderInput> colliders;
  Vec3 gravity{0, -9.81, 0};
  WindInput wind;
  bool self_collision = true;
  double frame_duration = 1.0 / 30;
  double largest_step = 0.002;  // seconds; a frame is cut into the least number of equal steps under it
};

}  // namespace drape

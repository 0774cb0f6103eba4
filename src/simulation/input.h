#pragma once

#include <array>
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

// Vertices that are held from a time on: they stay where they are then, or move on from there as a motion
// does, turning about their centroid, or as a collider does. The times are those of frames.
struct PinInput {
  std::vector<int> vertices;
  std::optional<RigidMotion> motion = {};
  std::optional<double> until = {};  // seconds; the vertices are free from then on
  double from = 0;                   // seconds, before `until`
  std::optional<int> collider = {};  // the index of the one to follow; in place of a motion
};

struct ClothInput {
  std::string name;
  TriangleMesh mesh;                   // its positions are the rest shape
  std::vector<Vec3> start_positions;   // one for each point
  Vec3 start_velocity = Vec3::Zero();  // m/s, of all points
  ClothMaterial material;
  double pressure = 0;  // Pa, inside over outside of a closed cloth; it does not change
  std::vector<PinInput> pins;
};

// Pairs of vertices of two cloths, or of one, that threads draw together; the two lists have the same length,
// and no vertex is paired with itself. The times are those of frames.
struct SeamInput {
  std::array<int, 2> cloths = {};  // indices
  std::array<std::vector<int>, 2> vertices = {};
  double from = 0;   // seconds: the threads are drawn in from then on
  double close = 1;  // seconds, after `from`: the pairs are as near as contact lets them be
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
// A surface, or a sequence of its shapes: equally long after one another, linear in between, the first before
// and the last after them.
struct MeshShape {
  TriangleMesh mesh;                           // the first shape
  std::vector<std::vector<Vec3>> shapes = {};  // positions of the mesh's points; empty: it keeps its shape
  double first_time = 0;                       // seconds, of the first one
  double interval = 0;                         // seconds from one to the next
};
using ColliderShape = std::variant<PlaneShape, SphereShape, BoxShape, CapsuleShape, MeshShape, CylinderShape>;

struct ColliderInput {
  std::string name;
  ColliderShape shape;
  RigidMotion motion;
  double friction = 0.3;  // a contact uses the geometric mean of the two coefficients
};

// The air, and how it takes hold of cloth (forces.cpp has the formula). The coefficients are those of a flat
// plate (Hoerner 1965, Fluid-Dynamic Drag); with drag and tangential drag 0 there is no air.
struct WindInput {
  Vec3 velocity = Vec3::Zero();   // m/s, the mean
  double gust = 0;                // how far gusts depart from the mean, as a share of its speed
  double gust_size = 2;           // m: the size of the largest whirls
  int seed = 0;                   // other gusts for each
  double drag = 1.2;              // of pressure, across the surface
  double tangential_drag = 0.02;  // of skin friction, along the surface
  double lift = 0.8;              // at right angles to the stream, more than the pressure's own
};

// How cloth resists deformation.
enum class DeformationModel {
  shape_matching,  // the default
  averaged,  // the paper's own form: outer corners and fibres in one averaged pass, a share `alpha` each step
  mass_spring,  // Bridson, Marino and Fedkiw 2003, explicit: what the paper compares with
};

struct SimulationInput {
  DeformationModel model = DeformationModel::shape_matching;
  double alpha = 1;  // of the averaged model, in (0, 1]
  std::vector<ClothInput> cloths;
  std::vector<ColliderInput> colliders;
  std::vector<SeamInput> seams;
  Vec3 gravity{0, -9.81, 0};
  WindInput wind;
  bool self_collision = true;
  bool sleep = true;      // cloth that lies still is left alone until something stirs it (rest.h)
  bool fail_safe = true;  // off only in tests, which show that the certificate sees what it prevents
  double frame_duration = 1.0 / 30;
  double largest_step = 0.002;  // seconds; a frame is cut into the least number of equal steps under it
};

}  // namespace drape

#pragma once

#include <array>
#include <vector>

#include "contact/contact_geometry.h"
#include "contact/proximity.h"

namespace drape {

constexpr int first_plane_kind = 2;         // after those of pairs
constexpr int after_all_patches = 1 << 30;  // the place of the first plane

// A contact that the response has to hold: along `normal`, the two sides (weights as in ClosestPoints) must
// stay `target` apart at the step's end.
struct Contact {
  int kind;      // of its pair, or first_plane_kind + the plane's body
  bool is_firm;  // may not give way: a collider or a plane, or cloth with no thickness left to give
  // By which contacts are ordered: its second and its first patch, or for a plane after_all_patches + its
  // body, and the vertex. With kind and vertices it says which contact this is.
  std::array<int, 2> place;
  std::array<int, 4> vertices;
  std::array<double, 4> weights;  // a vertex that plays no part has 0
  Vec3 normal;                    // unit, from the second side to the first
  double thickness;               // m: how far apart the surfaces are where there is room
  double target;              // m: what is kept in this step; old overlap is no more than kept from growing
  double push_target;         // m: what the push after the step grows towards
  double paused_push_target;  // m: the same while its pushes are paused
  double friction;
  Vec3 turn;  // m: what the turning of a rounded or plane collider adds to the sides' relative motion
};

// Where a body is at the start and the end of the step; cloths have none.
struct BodyMotion {
  RigidPose start, end;
};

// How the narrow phase sees one step.
struct NarrowPhase {
  const ContactGeometry& geometry;
  const std::vector<BodyMotion>& bodies;
  StepMotion motion;
  double healing;    // share of the thickness by which old overlap may heal in this step
  double least_gap;  // m: what the fail-safe keeps
};

// The listed pairs that come within their thickness on the way, each at the first time that they do (section
// 5 of the paper: collisions are detected on the future positions), but for those that leave their contact to
// another (shared_features.h). Pairs that are known to be too far are passed over. The lists must be up to
// date with this motion; the order of the contacts is that of the patches and their primitives, whenever the
// lists were made. What `contacts` held is lost.
void find_active_pairs(const NarrowPhase& phase, Proximity& proximity, std::vector<Contact>& contacts);

// Appends vertices within one and a half times their thickness of a plane at the step's end.
void find_plane_contacts(const NarrowPhase& phase, std::vector<Contact>& contacts);

}  // namespace drape

#include "contact/active_contacts.h"

#include <algorithm>
#include <optional>

#include "contact/conservative_advancement.h"
#include "contact/shared_features.h"
#include "core/parallel.h"

namespace drape {
namespace {

// Old overlap heals by a little in each step until the surfaces are `most` apart.
double healed_distance(const NarrowPhase& phase, double most, double thickness, double distance) {
  const double healed = std::min(most, distance + phase.healing * thickness);
  return std::max(std::min(thickness, distance), healed);
}

// What lies nearly at its distance is left alone.
double pushed_distance(const NarrowPhase& phase, double thickness, double distance) {
  return healed_distance(phase, 0.9 * thickness, thickness, distance);
}

// What is nearer would soon be held by the fail-safe.
double firm_distance(const NarrowPhase& phase, double thickness) {
  return std::max(0.05 * thickness, 2 * phase.least_gap);
}

// Where pushes are in vain they go on only for what is as near as that.
double paused_distance(const NarrowPhase& phase, double thickness, double distance) {
  return healed_distance(phase, firm_distance(phase, thickness), thickness, distance);
}

FourPoints at_time(const FourPoints& start, const FourPoints& end, double time) {
  FourPoints x;
  for (int i = 0; i < 4; ++i) x[i] = start[i] + time * (end[i] - start[i]);
  return x;
}

Vec3 rigid_displacement(const BodyMotion& motion, const Vec3& point) {
  const Vec3 local = motion.start.rotation.transpose() * (point - motion.start.translation);
  return motion.end(local) - point;
}

// What a rounded collider's surface moves beyond its vertices, seen from the first side: these carry no
// turning.
Vec3 turning(const NarrowPhase& phase, const ContactPair& pair, const ClosestPoints& closest) {
  const FourPoints start = gather(phase.motion.start, pair.vertices);
  const FourPoints end = gather(phase.motion.end, pair.vertices);
  const auto bodies = pair_bodies(phase.geometry, pair.kind, pair.vertices);
  Vec3 relative = Vec3::Zero();
  for (int side = 0; side < 2; ++side) {
    const ContactBody& body = phase.geometry.bodies[bodies[side]];
    if (body.is_cloth || body.radius == 0) continue;
    const int begin = side == 0 ? 0 : first_side(pair.kind), last = side == 0 ? first_side(pair.kind) : 4;
    Vec3 axis = Vec3::Zero(), moved = Vec3::Zero();
    for (int i = begin; i < last; ++i) {
      axis += std::abs(closest.weights[i]) * start[i];
      moved += std::abs(closest.weights[i]) * (end[i] - start[i]);
    }
    const double sign = side == 0 ? 1 : -1;
    const Vec3 surface = axis - sign * body.radius * closest.difference / closest.distance;
    relative += sign * (rigid_displacement(phase.bodies[bodies[side]], surface) - moved);
  }
  return relative;
}

Contact make_contact(const NarrowPhase& phase, const ContactPair& pair, const ClosestPoints& closest,
                     double start_distance) {
  Contact contact{};
  contact.kind = static_cast<int>(pair.kind);
  contact.vertices = pair.vertices;
  contact.weights = closest.weights;
  contact.normal = closest.difference / closest.distance;
  const double gap = start_distance - pair.radius;
  contact.is_firm = pair.meets_collider || gap < firm_distance(phase, pair.thickness);
  contact.thickness = pair.thickness;
  contact.target = pair.radius + std::min(pair.thickness, gap);
  contact.push_target = pair.radius + pushed_distance(phase, pair.thickness, gap);
  contact.paused_push_target = pair.radius + paused_distance(phase, pair.thickness, gap);
  contact.friction = pair.friction;
  contact.turn = pair.radius > 0 ? turning(phase, pair, closest) : Vec3::Zero();
  return contact;
}

// A look at a list: its clock, and how far that goes on in this step (ways of its patches relative to each
// other, in m).
struct Look {
  const NarrowPhase& phase;
  const Incidence& triangles_at;  // vertices
  double travelled, way_in_step;
};

// Where a pair makes its contact, and when: from 0 at the step's start to 1 at its end.
struct Meeting {
  ClosestPoints closest;
  double time;
};

// Edge-edge pairs that are closest at an end are point-triangle pairs too, and left to these; of those, one
// is enough.
bool counted_elsewhere(const Look& look, const ContactPair& pair, const Meeting& meeting) {
  if (pair.kind == PairKind::edge_edge) return !meeting.closest.inside_edges && !pair.counts_edge_ends;
  return is_left_to_neighbour(look.phase.geometry, look.triangles_at, look.phase.motion, pair,
                              meeting.closest, meeting.time);
}

// The place of a contact that is there from the start. On a rounded collider it is where the step leads:
// there it moves smoothly, and the place of before would be a step late, by which edges that lie on a ball
// rock for ever. Where that is deep inside, or on another side, the direction is not to be trusted.
ClosestPoints standing_place(const NarrowPhase& phase, const ContactPair& pair,
                             const ClosestPoints& at_start) {
  constexpr double least_share = 0.5;  // of the radius
  constexpr double least_cosine = 0.8;
  if (pair.radius == 0) return at_start;
  const ClosestPoints at_end = closest_points(pair.kind, gather(phase.motion.end, pair.vertices));
  const bool is_same_side =
      at_end.difference.dot(at_start.difference) > least_cosine * at_end.distance * at_start.distance;
  return at_end.distance > least_share * pair.radius && is_same_side ? at_end : at_start;
}

// Now, if it is near enough, or on the way.
std::optional<Meeting> find_meeting(const NarrowPhase& phase, const ContactPair& pair,
                                    const FourPoints& start, const ClosestPoints& at_start) {
  if (at_start.distance <= pair.radius + (1 + arrival_share) * pair.thickness)
    return Meeting{standing_place(phase, pair, at_start), 0};
  const FourPoints end = gather(phase.motion.end, pair.vertices);
  const auto time =
      time_of_contact(pair.kind, start, end, pair.radius + pair.thickness, arrival_share * pair.thickness);
  if (!time) return std::nullopt;
  return Meeting{closest_points(pair.kind, at_time(start, end, *time)), *time};
}

// Appends a contact if the pair comes within its thickness; brings its expiry up to date. A pair's own points
// may move less than their patches, which is worth a look before others.
void examine_pair(const Look& look, const ContactPair& pair, double& expiry, std::vector<Contact>& out) {
  const FourPoints start = gather(look.phase.motion.start, pair.vertices);
  std::optional<double> way;
  const auto stays_away = [&] {
    if (look.travelled >= expiry) return false;
    if (!way) way = relative_motion(pair.kind, start, gather(look.phase.motion.end, pair.vertices));
    return look.travelled + *way < expiry;
  };
  if (stays_away()) return;
  const ClosestPoints at_start = closest_points(pair.kind, start);
  expiry = expiry_of(pair.radius, pair.thickness, look.travelled, at_start.distance);
  if (stays_away()) return;
  const auto meeting = find_meeting(look.phase, pair, start, at_start);
  if (!meeting || !(meeting->closest.distance > 0) || counted_elsewhere(look, pair, *meeting)) return;
  out.push_back(make_contact(look.phase, pair, meeting->closest, at_start.distance));
}

void examine_pairs(const Look& look, PatchPair& patches, std::vector<Contact>& out) {
  const double travelled = look.travelled + look.way_in_step;
  if (travelled < patches.next_contact) return;
  const std::size_t found = out.size();
  for (std::size_t i = 0; i < patches.pairs.size(); ++i)
    if (travelled >= patches.pairs[i].expiry)
      examine_pair(look, contact_pair(patches, i), patches.pairs[i].expiry, out);
  for (std::size_t i = found; i < out.size(); ++i) out[i].place = {patches.second, patches.first};
  patches.contacts = out.size() - found;
  update_next(patches);
}

std::size_t contacts_of_last_look(const Proximity& proximity, std::size_t begin, std::size_t end) {
  std::size_t count = 0;
  for (std::size_t p = begin; p < end; ++p) count += proximity.pairs[p].contacts;
  return count;
}

}  // namespace

void find_active_pairs(const NarrowPhase& phase, Proximity& proximity, std::vector<Contact>& contacts) {
  constexpr std::size_t block = 32;
  parallel_collect(proximity.pairs.size(), block, contacts,
                   [&](std::size_t begin, std::size_t end, std::vector<Contact>& out) {
                     out.reserve(contacts_of_last_look(proximity, begin, end));
                     for (std::size_t p = begin; p < end; ++p) {
                       PatchPair& patches = proximity.pairs[p];
                       const double way = relative_way(proximity, patches);
                       examine_pairs({phase, proximity.triangles_at, patches.travelled, way}, patches, out);
                     }
                   });
}

static Contact make_plane_contact(const NarrowPhase& phase, const ContactPlane& plane,
                                  const ContactBody& cloth, int v) {
  const BodyMotion& motion = phase.bodies[plane.body];
  const Vec3 up_start = motion.start.rotation.col(1), up_end = motion.end.rotation.col(1);
  const double start_height = up_start.dot(phase.motion.start[v] - motion.start.translation);
  const double offset = up_end.dot(motion.end.translation);
  Contact contact{};
  contact.kind = first_plane_kind + plane.body;
  contact.is_firm = true;
  contact.place = {after_all_patches + plane.body, v};
  contact.vertices = {v, v, v, v};
  contact.weights = {1, 0, 0, 0};
  contact.normal = up_end;
  contact.thickness = cloth.thickness;
  contact.target = offset + std::min(cloth.thickness, start_height);
  contact.push_target = offset + pushed_distance(phase, cloth.thickness, start_height);
  contact.paused_push_target = offset + paused_distance(phase, cloth.thickness, start_height);
  contact.friction = pair_friction(phase.geometry, phase.geometry.vertex_body[v], plane.body);
  contact.turn = -rigid_displacement(motion, phase.motion.start[v]);
  return contact;
}

// Vertices that are near the plane at the step's end. Not at or under their thickness alone: other contacts
// may push them down, and the plane has no other say in this step.
static void add_plane_contacts(const NarrowPhase& phase, const ContactPlane& plane, const ContactBody& cloth,
                               std::vector<Contact>& contacts) {
  constexpr double reach = 1.5;
  const RigidPose& pose = phase.bodies[plane.body].end;
  const Vec3 up = pose.rotation.col(1);
  const double highest = up.dot(pose.translation) + reach * cloth.thickness;
  std::vector<Contact> found;
  parallel_collect(cloth.vertex_end - cloth.vertex_begin, 1024, found,
                   [&](std::size_t begin, std::size_t end, std::vector<Contact>& out) {
                     for (std::size_t i = begin; i < end; ++i) {
                       const int v = cloth.vertex_begin + static_cast<int>(i);
                       if (up.dot(phase.motion.end[v]) <= highest && phase.geometry.inverse_masses[v] > 0)
                         out.push_back(make_plane_contact(phase, plane, cloth, v));
                     }
                   });
  contacts.insert(contacts.end(), found.begin(), found.end());
}

void find_plane_contacts(const NarrowPhase& phase, std::vector<Contact>& contacts) {
  for (const ContactPlane& plane : phase.geometry.planes)
    for (const ContactBody& body : phase.geometry.bodies)
      if (body.is_cloth) add_plane_contacts(phase, plane, body, contacts);
}

}  // namespace drape

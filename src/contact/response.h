#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "contact/active_contacts.h"
#include "contact/collision_groups.h"
#include "contact/contact_memory.h"
#include "core/vector.h"

namespace drape {

// What the sweeps need of a contact. Vectors have a fourth component, which is 0.
struct Pull {
  Pull() {}  // not `= default`, with which a vector would clear them all: each is written whole

  std::array<int, 4> vertices;  // one that plays no part is another one again, with weight 0
  double mobility;              // how far the sides part under a unit impulse, in 1/kg; 0: nothing can move
  double effective_mass;        // its inverse
  double target, push_target;   // m: as the contact's
  double tolerance;             // m: what sweeps may leave over where things move
  double friction;
  double impulse;             // lambda: kg m, never negative; at first what held the contact in the last step
  double push_impulse;        // kg m: the push's
  std::int64_t paused_steps;  // as in ContactMemory, for the next step
  Vec4 weights, normal;
  Vec4 responses;  // how far each vertex goes under a unit impulse, in 1/kg
  Vec4 origin;     // m: where the sides were to each other at the start, less what turns with a collider
  Vec4 friction_impulse;  // kg m: across the normal, no longer than friction * impulse
};

// The response to a step's contacts, group by group.
struct Response {
  CollisionGroups groups;
  std::vector<Pull> pulls;              // pulls[i] is of the contact groups.order[i]
  std::vector<std::size_t> firm;        // those that may not give way
  std::vector<std::size_t> firm_begin;  // of part p: firm[firm_begin[p] .. firm_begin[p + 1])
};

// Each contact starts with what its memory says held it (`memories` may be empty): that is much the same
// where things rest, and from there on few sweeps are enough. But with no more than parts its sides by
// `farthest` metres: what stopped a blow is larger, and asked for again it would throw a pile back up faster
// than the sweeps can take it back.
Response begin_response(const ContactGeometry& geometry, const std::vector<Contact>& contacts,
                        const std::vector<ContactMemory>& memories, double farthest,
                        const std::vector<Vec3>& start);

// Once, before resolve_contacts, where memories were given: x lacks the impulses that contacts start with.
void hold_again(const Response& response, std::vector<Vec3>& x);

// Moves x so that every contact keeps its target: iterated, local, momentum-conserving pulls (after Spillmann
// and Teschner 2008), as projected Gauss-Seidel on the accumulated impulses, with Coulomb friction against
// the way since the start. A group is settled when a sweep moves no contact by more than it may leave over: a
// quarter of the way that the contact's sides have gone, at most a hundredth of its thickness and at least a
// twentieth of that. After the first, sweeps pass over what has not moved since. What the pulls bring
// nearer to each other is not found here.
void resolve_contacts(Response& response, std::vector<Vec3>& x);

// Afterwards: moves overlapping sides a little way apart, positions only.
void push_apart(Response& response, std::vector<Vec3>& x);

// When other constraints have moved points after that: firm contacts keep their target and their push again,
// along their normals. These are contacts with colliders, which go on whatever cloth would like, and those of
// cloth that is nearer than what pushes are paused to: what has more thickness can give some. Returns for
// each vertex whether this moved it.
std::vector<char> keep_firm_contacts(const Response& response, std::vector<Vec3>& x);

// What of the vertices' ways from the start to `end` was such a push and must not go into the velocities, in
// m: of each contact as much as its sides have really parted. Where something pushes them together again, the
// push is no way, and to take it from the velocity would leave one with which nothing moves. Such a contact's
// pushes are paused for `pause` steps: where there is no room, they go round for ever, and what they press
// together leaves with a velocity, so that a pile at rest would buzz.
std::vector<Vec3> take_pushes(std::int64_t pause, Response& response, const std::vector<Vec3>& end);

// What each of the contacts is to keep for the next step.
std::vector<ContactMemory> memories_of(const Response& response);

}  // namespace drape

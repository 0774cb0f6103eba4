#pragma once

#include <vector>

#include "contact/patches.h"

namespace drape {

// Conservative advancement stops when the gap to close is this share of the thickness: pairs that are farther
// apart than thickness and this all through a step make no contact.
constexpr double arrival_share = 0.02;

// A pair of primitives in a list.
struct ListedPair {
  std::array<int, 4> vertices;
  double thickness;  // m, between the surfaces
  double expiry;     // m: up to which way travelled the pair stays out of reach
};

// Two patches that may meet, and those pairs of their primitives that are near. How far points of the one
// have moved as seen from points of the other is the clock of both kinds of decision: when a listed pair has
// to be looked at again, and when the list has to be made anew. What the patches have in common does not
// count.
struct PatchPair {
  int first, second;              // patches, first <= second
  std::vector<ListedPair> pairs;  // in the order of the patches' primitives, whenever the list is made
  std::size_t edges_begin = 0;    // of pairs: before it are points with triangles, then edges with edges
  bool meets_collider = false, counts_edge_ends = false;  // of all of them, as of a ContactPair
  double radius = 0, friction = 0;
  double least_thickness = 0;  // m, of all of them
  double travelled = 0;        // m: a bound of how far two points of either have moved relatively
  double valid_until = -1;     // until then pairs that are not listed are out of reach
  double next_contact = 0;     // until then listed pairs are, too; the least of their expiries
  double next_collision = 0;   // until then they don't come near zero distance
  std::size_t contacts = 0;    // how many it made when it was looked at last
};

// The i-th of the listed pairs.
ContactPair contact_pair(const PatchPair& patches, std::size_t i);

// A bound of how near the points of the i-th listed pair are to each other, from when it was looked at last.
double least_distance(const PatchPair& patches, std::size_t i);

// How near two bodies' surfaces have to come to make a contact, measured between their points, edges and
// triangles.
double contact_reach(const ContactGeometry& geometry, int body_a, int body_b);

// Up to which way travelled a pair needs no look, after its points were found to be `distance` apart.
double expiry_of(double radius, double thickness, double travelled, double distance);

// Brings next_contact and next_collision up to date with those of the pairs.
void update_next(PatchPair& patches);

// Lists all pairs that may make a contact before the patches have moved by `margin` metres from where they
// are at `x`.
void list_pairs(const ContactGeometry& geometry, const std::vector<Patch>& patches,
                const std::vector<Vec3>& x, double margin, PatchPair& pair);

}  // namespace drape

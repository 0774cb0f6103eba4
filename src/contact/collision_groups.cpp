#include "contact/collision_groups.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t parts_of_large = 8, large = 1024;  // contacts: fewer are not worth two threads

// Calls visit(vertex) for those of the contact's vertices that it can move.
template <typename Visit>
void for_each_moving(const ContactGeometry& geometry, const Contact& contact, const Visit& visit) {
  for (int i = 0; i < 4; ++i)
    if (contact.weights[i] != 0 && geometry.inverse_masses[contact.vertices[i]] > 0)
      visit(contact.vertices[i]);
}

int root_of(std::vector<int>& parents, int v) {
  while (parents[v] != v) v = parents[v] = parents[parents[v]];
  return v;
}

// Union-find over the moving vertices; the root is the smallest vertex of the group. -1 for no moving vertex.
int join_vertices(const ContactGeometry& geometry, const Contact& contact, std::vector<int>& parents) {
  int first = -1;
  for_each_moving(geometry, contact, [&](int v) {
    const int root = root_of(parents, v);
    if (first < 0) first = root;
    const auto [low, high] = std::minmax(first, root);
    parents[high] = low;
    first = low;
  });
  return first;
}

// The roots of all contacts' groups.
std::vector<int> find_roots(const ContactGeometry& geometry, const std::vector<Contact>& contacts) {
  std::vector<int> parents(geometry.vertex_body.size());
  std::iota(parents.begin(), parents.end(), 0);
  std::vector<int> roots(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) roots[i] = join_vertices(geometry, contacts[i], parents);
  for (int& root : roots)
    if (root >= 0) root = root_of(parents, root);
  return roots;
}

// Sorts `items` by bin_of(item), a number under `bins`; returns where each bin begins, and the end. Items of
// a bin keep their order.
template <typename BinOf>
std::vector<std::size_t> sort_into_bins(std::size_t bins, const BinOf& bin_of, std::span<int> items) {
  std::vector<std::size_t> begin(bins + 1, 0);
  for (const int item : items) ++begin[bin_of(item) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  const std::vector<int> unsorted(items.begin(), items.end());
  for (const int item : unsorted) items[next[bin_of(item)]++] = item;
  return begin;
}

// By kind and vertices: which list a contact comes from and when that was made must not matter.
std::vector<int> in_order(const ContactGeometry& geometry, const std::vector<Contact>& contacts) {
  std::vector<int> order(contacts.size());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<std::size_t> begin = sort_into_bins(
      geometry.vertex_body.size(), [&](int i) { return contacts[i].vertices[0]; }, std::span(order));
  for (std::size_t v = 0; v + 1 < begin.size(); ++v)
    std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              order.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [&](int a, int b) { return contacts[a].vertices < contacts[b].vertices; });
  sort_into_bins(
      first_plane_kind + geometry.bodies.size(), [&](int i) { return contacts[i].kind; }, std::span(order));
  return order;
}

// Contacts that follow each other share vertices, and a processor would have to wait for the one before it
// takes up the next: far ones come between.
void spread(std::span<int> part) {
  constexpr std::size_t stride = 16;
  const std::vector<int> close(part.begin(), part.end());
  auto to = part.begin();
  for (std::size_t first = 0; first < stride; ++first)
    for (std::size_t i = first; i < close.size(); i += stride) *to++ = close[i];
}

// The direction in which a group's contacts lie farthest apart, and the places along it that cut them into
// parts of as many contacts.
struct Slabs {
  int axis;
  std::array<double, parts_of_large - 1> cuts;
};

Vec3 place_of(const Contact& contact, const std::vector<Vec3>& positions) {
  return positions[contact.vertices[0]];
}

int longest_axis(const std::vector<Vec3>& positions, const std::vector<Contact>& contacts,
                 std::span<const int> group) {
  Vec3 lower = place_of(contacts[group.front()], positions), upper = lower;
  for (const int i : group) {
    const Vec3 place = place_of(contacts[i], positions);
    lower = lower.cwiseMin(place);
    upper = upper.cwiseMax(place);
  }
  int axis;
  (upper - lower).maxCoeff(&axis);
  return axis;
}

Slabs find_slabs(const std::vector<Vec3>& positions, const std::vector<Contact>& contacts,
                 std::span<const int> group) {
  Slabs slabs{longest_axis(positions, contacts, group), {}};
  std::vector<double> places;
  for (const int i : group) places.push_back(place_of(contacts[i], positions)[slabs.axis]);
  auto from = places.begin();
  for (std::size_t cut = 0; cut < slabs.cuts.size(); ++cut) {
    const auto at = places.begin() + static_cast<std::ptrdiff_t>((cut + 1) * places.size() / parts_of_large);
    std::nth_element(from, at, places.end());
    slabs.cuts[cut] = *at;
    from = at;
  }
  return slabs;
}

std::size_t slab_of(const Slabs& slabs, double place) {
  std::size_t slab = 0;
  for (const double cut : slabs.cuts) slab += place >= cut;
  return slab;
}

bool is_in(const Slabs& slabs, std::size_t slab, double place) {
  return (slab == 0 || place >= slabs.cuts[slab - 1]) &&
         (slab == slabs.cuts.size() || place < slabs.cuts[slab]);
}

// The part of the contact, or parts_of_large where its moving vertices are not all of one.
std::size_t part_of(const ContactGeometry& geometry, const std::vector<Vec3>& positions, const Slabs& slabs,
                    const Contact& contact) {
  const std::size_t slab = slab_of(slabs, place_of(contact, positions)[slabs.axis]);
  bool within = true;
  for_each_moving(geometry, contact, [&](int v) { within &= is_in(slabs, slab, positions[v][slabs.axis]); });
  return within ? slab : parts_of_large;
}

CollisionGroup cut_group(const ContactGeometry& geometry, const std::vector<Vec3>& positions,
                         const std::vector<Contact>& contacts, std::size_t begin, std::span<int> group) {
  const Slabs slabs = find_slabs(positions, contacts, group);
  std::vector<unsigned char> parts(contacts.size());
  parallel_for_each(group.size(), 512, [&](std::size_t k) {
    const Contact& contact = contacts[group[k]];
    parts[group[k]] = static_cast<unsigned char>(part_of(geometry, positions, slabs, contact));
  });
  std::vector<std::size_t> bins = sort_into_bins(
      parts_of_large + 1, [&](int i) { return parts[i]; }, group);
  for (std::size_t p = 0; p + 1 < bins.size(); ++p) spread(group.subspan(bins[p], bins[p + 1] - bins[p]));
  for (std::size_t& bin : bins) bin += begin;
  bins.pop_back();
  return {bins, bins.back(), begin + group.size()};
}

}  // namespace

CollisionGroups group_contacts(const ContactGeometry& geometry, const std::vector<Vec3>& positions,
                               const std::vector<Contact>& contacts) {
  if (contacts.empty()) return {};
  const std::vector<int> roots = find_roots(geometry, contacts);
  CollisionGroups result{in_order(geometry, contacts), {}};
  const std::vector<std::size_t> begin = sort_into_bins(
      geometry.vertex_body.size() + 1, [&](int i) { return roots[i] + 1; }, std::span(result.order));
  for (std::size_t root = 0; root + 1 < begin.size(); ++root) {
    const std::size_t size = begin[root + 1] - begin[root];
    if (size > large)
      result.groups.push_back(cut_group(geometry, positions, contacts, begin[root],
                                        std::span(result.order).subspan(begin[root], size)));
    else if (size > 0)
      result.groups.push_back({{}, begin[root], begin[root + 1]});
  }
  return result;
}

}  // namespace drape

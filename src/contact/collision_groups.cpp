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
// parts of about as many contacts.
struct Slabs {
  int axis;
  std::array<double, parts_of_large - 1> cuts;
};

// Where some of the group's contacts are: enough to cut it into parts of about the same size.
std::vector<Vec3> sample_places(const std::vector<Vec3>& positions, const std::vector<Contact>& contacts,
                                std::span<const int> group) {
  constexpr std::size_t stride = 16;
  std::vector<Vec3> places;
  places.reserve(group.size() / stride + 1);
  for (std::size_t k = 0; k < group.size(); k += stride)
    places.push_back(positions[contacts[group[k]].vertices[0]]);
  return places;
}

int longest_axis(const std::vector<Vec3>& places) {
  Vec3 lower = places.front(), upper = lower;
  for (const Vec3& place : places) {
    lower = lower.cwiseMin(place);
    upper = upper.cwiseMax(place);
  }
  int axis;
  (upper - lower).maxCoeff(&axis);
  return axis;
}

Slabs find_slabs(const std::vector<Vec3>& places) {
  Slabs slabs{longest_axis(places), {}};
  std::vector<double> along;
  for (const Vec3& place : places) along.push_back(place[slabs.axis]);
  std::sort(along.begin(), along.end());
  for (std::size_t cut = 0; cut < slabs.cuts.size(); ++cut)
    slabs.cuts[cut] = along[(cut + 1) * along.size() / parts_of_large];
  return slabs;
}

using PartNumber = unsigned char;

// The slab of each vertex.
std::vector<PartNumber> slabs_of(const Slabs& slabs, const std::vector<Vec3>& positions) {
  std::vector<PartNumber> result(positions.size());
  parallel_for_each(positions.size(), 4096, [&](std::size_t v) {
    const double place = positions[v][slabs.axis];
    for (const double cut : slabs.cuts)
      if (place >= cut) ++result[v];
  });
  return result;
}

// The slab that its first vertex and all that move are in, or parts_of_large.
PartNumber part_of(const ContactGeometry& geometry, const std::vector<PartNumber>& slabs,
                   const Contact& contact) {
  PartNumber part = slabs[contact.vertices[0]];
  for_each_moving(geometry, contact, [&](int v) {
    if (slabs[v] != part) part = parts_of_large;
  });
  return part;
}

CollisionGroup cut_group(const ContactGeometry& geometry, const std::vector<Vec3>& positions,
                         const std::vector<Contact>& contacts, std::size_t begin, std::span<int> group) {
  const std::vector<PartNumber> slabs =
      slabs_of(find_slabs(sample_places(positions, contacts, group)), positions);
  std::vector<PartNumber> parts(contacts.size());
  parallel_for_each(group.size(), 512,
                    [&](std::size_t k) { parts[group[k]] = part_of(geometry, slabs, contacts[group[k]]); });
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
  CollisionGroups result{std::vector<int>(contacts.size()), {}};
  std::iota(result.order.begin(), result.order.end(), 0);
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

#include "contact/collision_groups.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "core/parallel.h"

namespace drape {
namespace {

// A large group is cut into slabs of space. Contacts of a slab are a part of the first round; those that join
// a slab to the next, of the second and the third, every other slab's; what is left, of the fourth. Here are
// the first part of each round, and the end.
constexpr std::size_t slab_count = 8;
constexpr std::size_t even_joints = slab_count / 2, joints = slab_count - 1;
constexpr std::array<std::size_t, 5> first_parts = {0, slab_count, slab_count + even_joints,
                                                    slab_count + joints, slab_count + joints + 1};
constexpr std::size_t large = 1024;  // contacts: fewer are not worth two threads

// Those of a contact's vertices that it can move, without the large rest of it.
struct MovingVertices {
  std::array<int, 4> vertices;
  int count;

  const int* begin() const { return vertices.data(); }
  const int* end() const { return vertices.data() + count; }
};

std::vector<MovingVertices> moving_vertices(const ContactGeometry& geometry,
                                            const std::vector<Contact>& contacts) {
  std::vector<MovingVertices> moving(contacts.size());
  parallel_for_each(contacts.size(), 512, [&](std::size_t c) {
    const Contact& contact = contacts[c];
    for (int i = 0; i < 4; ++i)
      if (contact.weights[i] != 0 && geometry.inverse_masses[contact.vertices[i]] > 0)
        moving[c].vertices[moving[c].count++] = contact.vertices[i];
  });
  return moving;
}

int root_of(std::vector<int>& parents, int v) {
  while (parents[v] != v) v = parents[v] = parents[parents[v]];
  return v;
}

// Union-find over the moving vertices; the root is the smallest vertex of the group. -1 for no moving vertex.
int join_vertices(const MovingVertices& moving, std::vector<int>& parents) {
  int first = -1;
  for (const int v : moving) {
    const int root = root_of(parents, v);
    if (first < 0) first = root;
    const auto [low, high] = std::minmax(first, root);
    parents[high] = low;
    first = low;
  }
  return first;
}

// The roots of all contacts' groups.
std::vector<int> find_roots(std::size_t vertex_count, const std::vector<MovingVertices>& moving) {
  std::vector<int> parents(vertex_count);
  std::iota(parents.begin(), parents.end(), 0);
  std::vector<int> roots(moving.size());
  for (std::size_t i = 0; i < moving.size(); ++i) roots[i] = join_vertices(moving[i], parents);
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
  std::array<double, slab_count - 1> cuts;
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
    slabs.cuts[cut] = along[(cut + 1) * along.size() / slab_count];
  return slabs;
}

using SmallNumber = unsigned char;

// The slab of each vertex.
std::vector<SmallNumber> slabs_of(const Slabs& slabs, const std::vector<Vec3>& positions) {
  std::vector<SmallNumber> result(positions.size());
  parallel_for_each(positions.size(), 1024, [&](std::size_t v) {
    const double place = positions[v][slabs.axis];
    for (const double cut : slabs.cuts)
      if (place >= cut) ++result[v];
  });
  return result;
}

// Contacts that move nothing go to the first: they do nothing either.
SmallNumber part_of(const std::vector<SmallNumber>& slabs, const MovingVertices& moving) {
  SmallNumber first = slab_count, last = 0;
  for (const int v : moving) {
    first = std::min(first, slabs[v]);
    last = std::max(last, slabs[v]);
  }
  if (first >= last) return last;
  if (first + 1 < last) return first_parts[3];
  return static_cast<SmallNumber>(first_parts[first % 2 == 0 ? 1 : 2] + first / 2);
}

// Puts the group's contacts in the order of their parts; returns where each part begins in it, and the end.
std::vector<std::size_t> cut_group(const std::vector<Vec3>& positions, const std::vector<Contact>& contacts,
                                   const std::vector<MovingVertices>& moving, std::span<int> group) {
  const std::vector<SmallNumber> slabs =
      slabs_of(find_slabs(sample_places(positions, contacts, group)), positions);
  std::vector<SmallNumber> parts(contacts.size());
  parallel_for_each(group.size(), 512,
                    [&](std::size_t k) { parts[group[k]] = part_of(slabs, moving[group[k]]); });
  std::vector<std::size_t> begin = sort_into_bins(
      first_parts.back(), [&](int i) { return parts[i]; }, group);
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) spread(group.subspan(begin[p], begin[p + 1] - begin[p]));
  return begin;
}

// `part_begin` is from where the group begins.
void append_cut_group(const std::vector<std::size_t>& part_begin, CollisionGroups& groups) {
  const std::size_t begin = groups.part_begin.back(), first_part = groups.part_count();
  for (std::size_t p = 1; p < part_begin.size(); ++p) groups.part_begin.push_back(begin + part_begin[p]);
  for (std::size_t r = 1; r < first_parts.size(); ++r)
    groups.round_begin.push_back(first_part + first_parts[r]);
  groups.group_begin.push_back(groups.round_begin.size() - 1);
}

void append_group(std::size_t size, CollisionGroups& groups) {
  groups.part_begin.push_back(groups.part_begin.back() + size);
  groups.round_begin.push_back(groups.part_count());
  groups.group_begin.push_back(groups.round_begin.size() - 1);
}

}  // namespace

CollisionGroups group_contacts(const ContactGeometry& geometry, const std::vector<Vec3>& positions,
                               const std::vector<Contact>& contacts) {
  if (contacts.empty()) return {};
  const std::vector<MovingVertices> moving = moving_vertices(geometry, contacts);
  const std::vector<int> roots = find_roots(geometry.vertex_body.size(), moving);
  CollisionGroups result;
  result.order.resize(contacts.size());
  std::iota(result.order.begin(), result.order.end(), 0);
  const std::vector<std::size_t> begin = sort_into_bins(
      geometry.vertex_body.size() + 1, [&](int i) { return roots[i] + 1; }, std::span(result.order));
  for (std::size_t root = 0; root + 1 < begin.size(); ++root) {
    const std::size_t size = begin[root + 1] - begin[root];
    const std::span<int> group = std::span(result.order).subspan(begin[root], size);
    if (size > large)
      append_cut_group(cut_group(positions, contacts, moving, group), result);
    else if (size > 0)
      append_group(size, result);
  }
  return result;
}

}  // namespace drape

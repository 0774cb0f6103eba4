#include "contact/patches.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

namespace drape {
namespace {

// Small patches have little motion within them that would make their lists stale; large ones are few.
constexpr std::ptrdiff_t most_points = 24;

using Iterator = std::vector<int>::iterator;

int longest_axis(const std::vector<Vec3>& x, Iterator begin, Iterator end) {
  const Bounds bounds = bounds_of(x, std::span(begin, end));
  int axis = 0;
  (bounds.upper - bounds.lower).maxCoeff(&axis);
  return axis;
}

// Halves the points across their longest extent until there are few enough.
void split(const std::vector<Vec3>& x, int body, Iterator begin, Iterator end, std::vector<Patch>& patches) {
  if (end - begin <= most_points) {
    patches.emplace_back().body = body;
    patches.back().points.assign(begin, end);
    std::sort(patches.back().points.begin(), patches.back().points.end());
    return;
  }
  const int axis = longest_axis(x, begin, end);
  const Iterator middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end,
                   [&](int a, int b) { return std::tie(x[a][axis], a) < std::tie(x[b][axis], b); });
  split(x, body, begin, middle, patches);
  split(x, body, middle, end, patches);
}

void gather_vertices(const ContactGeometry& geometry, Patch& patch) {
  std::vector<int>& vertices = patch.vertices;
  vertices = patch.points;
  for (const int e : patch.edges)
    vertices.insert(vertices.end(), geometry.edges[e].begin(), geometry.edges[e].end());
  for (const int t : patch.triangles)
    vertices.insert(vertices.end(), geometry.triangles[t].begin(), geometry.triangles[t].end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

}  // namespace

std::vector<Patch> cut_into_patches(const ContactGeometry& geometry) {
  std::vector<Patch> patches;
  for (std::size_t b = 0; b < geometry.bodies.size(); ++b) {
    const ContactBody& body = geometry.bodies[b];
    std::vector<int> points(body.vertex_end - body.vertex_begin);
    std::iota(points.begin(), points.end(), body.vertex_begin);
    if (!points.empty())
      split(geometry.rest_positions, static_cast<int>(b), points.begin(), points.end(), patches);
  }
  std::vector<int> patch_of(geometry.vertex_body.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const int v : patches[p].points) patch_of[v] = static_cast<int>(p);
  for (std::size_t e = 0; e < geometry.edges.size(); ++e)
    patches[patch_of[geometry.edges[e][0]]].edges.push_back(static_cast<int>(e));
  for (std::size_t t = 0; t < geometry.triangles.size(); ++t)
    patches[patch_of[geometry.triangles[t][0]]].triangles.push_back(static_cast<int>(t));
  for (Patch& patch : patches) gather_vertices(geometry, patch);
  return patches;
}

}  // namespace drape

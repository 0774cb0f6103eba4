#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/primitives.h"
#include "mesh/topology.h"

namespace drape {
namespace {

Topology topology_of(const TriangleMesh& mesh) {
  return build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles);
}

int euler_characteristic(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.positions.size() + mesh.triangles.size() - topology_of(mesh).edges.size());
}

int boundary_edges(const Topology& topology) {
  return static_cast<int>(std::count_if(topology.edges.begin(), topology.edges.end(),
                                        [](const Edge& edge) { return edge.triangles[1] < 0; }));
}

// 6 7 8
// 3 4 5   Each cell is cut from its corner of lowest number to that of highest:
// 0 1 2   triangles {0,3,4} {0,4,1} {1,4,5} {1,5,2} {3,6,7} {3,7,4} {4,7,8} {4,8,5}
const TriangleMesh& three_by_three() {
  static const TriangleMesh mesh = make_grid({2, 2}, {3, 3});
  return mesh;
}

TEST(Topology, EulerCharacteristic) {
  EXPECT_EQ(euler_characteristic(make_grid({1, 1}, {7, 4})), 1);
  EXPECT_EQ(euler_characteristic(make_box({1, 2, 3})), 2);
  EXPECT_EQ(euler_characteristic(make_sphere(1, 12, 7)), 2);
  EXPECT_EQ(euler_characteristic(make_capsule({0, 0, 0}, {0, 1, 0}, 0.2, 9, 3)), 2);
}

TEST(Topology, EdgesAreSortedAndNameTheirTriangles) {
  const TriangleMesh& mesh = three_by_three();
  const Topology topology = topology_of(mesh);
  ASSERT_EQ(topology.edges.size(), 16u);
  EXPECT_TRUE(std::is_sorted(topology.edges.begin(), topology.edges.end(),
                             [](const Edge& a, const Edge& b) { return a.vertices < b.vertices; }));
  EXPECT_EQ(topology.edges[0].vertices, (std::array{0, 1}));
  EXPECT_EQ(topology.edges[0].triangles, (std::array{1, -1}));
  EXPECT_EQ(topology.edges[2].vertices, (std::array{0, 4}));
  EXPECT_EQ(topology.edges[2].triangles, (std::array{0, 1}));
  EXPECT_EQ(boundary_edges(topology), 8);
}

TEST(Topology, TriangleEdgesJoinTheirCorners) {
  const TriangleMesh mesh = make_sphere(1, 8, 5);
  const Topology topology = topology_of(mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Edge& edge = topology.edges[topology.triangle_edges[t][k]];
      const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
      EXPECT_EQ(edge.vertices, (std::array{low, high}));
      EXPECT_TRUE(edge.triangles[0] == int(t) || edge.triangles[1] == int(t));
      EXPECT_GE(edge.triangles[1], 0);
    }
}

TEST(Topology, OppositeVerticesByHand) {
  const TriangleMesh& mesh = three_by_three();
  const Topology topology = topology_of(mesh);
  EXPECT_EQ(opposite_vertex(topology, mesh.triangles, 0, 0), -1);  // edge 0-3
  EXPECT_EQ(opposite_vertex(topology, mesh.triangles, 0, 1), 7);   // edge 3-4
  EXPECT_EQ(opposite_vertex(topology, mesh.triangles, 0, 2), 1);   // edge 4-0
  EXPECT_EQ(opposite_vertex(topology, mesh.triangles, 1, 1), 5);   // edge 4-1
  EXPECT_EQ(opposite_vertex(topology, mesh.triangles, 2, 0), 0);   // edge 1-4
}

TEST(Topology, TrianglesOfAVertexAscend) {
  const Topology topology = topology_of(three_by_three());
  const auto triangles_of = [&](int v) {
    return std::vector(topology.vertex_triangles.begin() + topology.vertex_triangle_begin[v],
                       topology.vertex_triangles.begin() + topology.vertex_triangle_begin[v + 1]);
  };
  EXPECT_EQ(triangles_of(0), (std::vector{0, 1}));
  EXPECT_EQ(triangles_of(2), (std::vector{3}));
  EXPECT_EQ(triangles_of(4), (std::vector{0, 1, 2, 5, 6, 7}));
}

TEST(Topology, PiecesAreNumberedByTheirSmallestVertex) {
  EXPECT_EQ(connected_pieces(7, {{1, 6, 4}, {0, 5, 3}}), (std::vector{0, 1, 2, 0, 1, 0, 1}));
  EXPECT_EQ(connected_pieces(0, {}), std::vector<int>{});
}

}  // namespace
}  // namespace drape

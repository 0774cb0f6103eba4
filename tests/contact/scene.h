#pragma once

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include "contact/active_contacts.h"
#include "contact/proximity.h"
#include "contact/response.h"
#include "mesh/primitives.h"
#include "mesh/topology.h"

namespace drape::test {

// Numbers that are the same in every run.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vec3 vector(double size = 1) {
    const double x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }
  FourPoints four_points(double size = 1) { return {vector(size), vector(size), vector(size), vector(size)}; }
  Mat3 rotation() {
    const Vec3 axis = vector().normalized();
    return Eigen::AngleAxisd(between(-3, 3), axis).toRotationMatrix();
  }

 private:
  std::mt19937 engine_;
};

constexpr double least_gap = 1e-4;  // m: that the fail-safe keeps

// Cloths and colliders, and where a step takes them. Cloths are to be added before colliders.
struct Scene {
  ContactGeometry geometry;
  std::vector<BodyMotion> bodies;
  std::vector<Vec3> start, end;

  NarrowPhase phase() const { return {geometry, bodies, {start, end}, 0.05, least_gap}; }
  StepMotion motion() const { return {start, end}; }

  int add_cloth(const TriangleMesh& mesh, double thickness, double friction = 0) {
    ContactBody body;
    body.thickness = thickness;
    return add(body, mesh.positions, edges_of(mesh), mesh.triangles, friction, 1);
  }
  int add_mesh(const TriangleMesh& mesh, double friction = 0) {
    return add(collider(0), mesh.positions, edges_of(mesh), mesh.triangles, friction, 0);
  }
  int add_sphere(const Vec3& centre, double radius, double friction = 0) {
    return add(collider(radius), {centre}, {}, {}, friction, 0);
  }
  int add_capsule(const Vec3& a, const Vec3& b, double radius, double friction = 0) {
    return add(collider(radius), {a, b}, {{0, 1}}, {}, friction, 0);
  }
  int add_plane(double friction = 0) {
    const int body = add(collider(0), {}, {}, {}, friction, 0);
    geometry.planes.push_back({body});
    return body;
  }

  // Moves a collider's vertices from where they are by a pose about the origin.
  void move_body(int body, const RigidPose& pose) {
    bodies[body].end = pose;
    for (int v = geometry.bodies[body].vertex_begin; v < geometry.bodies[body].vertex_end; ++v)
      end[v] = pose(start[v]);
  }
  std::pair<int, int> vertices(int body) const {
    return {geometry.bodies[body].vertex_begin, geometry.bodies[body].vertex_end};
  }

  // The broad phase of this step, done anew.
  Proximity proximity(const ProximityMargins& margins = {0.01, 0.05, 0.1}) const {
    Proximity made = start_proximity(geometry);
    update_proximity(geometry, motion(), margins, made);
    return made;
  }

 private:
  static ContactBody collider(double radius) {
    ContactBody body;
    body.is_cloth = false;
    body.is_rigid = true;
    body.radius = radius;
    return body;
  }
  static std::vector<std::array<int, 2>> edges_of(const TriangleMesh& mesh) {
    std::vector<std::array<int, 2>> edges;
    for (const Edge& edge : build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles).edges)
      edges.push_back(edge.vertices);
    return edges;
  }
  int add(ContactBody body, const std::vector<Vec3>& points, const std::vector<std::array<int, 2>>& edges,
          const std::vector<Triangle>& triangles, double friction, double inverse_mass) {
    const int first = static_cast<int>(geometry.vertex_body.size());
    const int index = static_cast<int>(geometry.bodies.size());
    body.friction = friction;
    body.vertex_begin = first;
    body.edge_begin = static_cast<int>(geometry.edges.size());
    body.triangle_begin = static_cast<int>(geometry.triangles.size());
    for (const Vec3& point : points) {
      geometry.vertex_body.push_back(index);
      geometry.rest_positions.push_back(point);
      geometry.inverse_masses.push_back(inverse_mass);
      start.push_back(point);
      end.push_back(point);
    }
    for (const auto& [a, b] : edges) geometry.edges.push_back({a + first, b + first});
    for (const auto& [a, b, c] : triangles) geometry.triangles.push_back({a + first, b + first, c + first});
    body.vertex_end = static_cast<int>(geometry.vertex_body.size());
    body.edge_end = static_cast<int>(geometry.edges.size());
    body.triangle_end = static_cast<int>(geometry.triangles.size());
    geometry.bodies.push_back(body);
    bodies.emplace_back();
    return index;
  }
};

inline TriangleMesh one_triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{a, b, c}, {{0, 1, 2}}, {}, {}};
}

inline TriangleMesh shifted(TriangleMesh mesh, const Vec3& shift) {
  for (Vec3& x : mesh.positions) x += shift;
  return mesh;
}

struct AnyPair {
  PairKind kind;
  std::array<int, 4> vertices;
};

// Every point with every triangle and every edge with every other that share no vertex: by brute force.
inline std::vector<AnyPair> all_pairs(const ContactGeometry& geometry) {
  std::vector<AnyPair> pairs;
  const auto kept = [&](const std::array<int, 4>& v, int first) {
    for (int i = 0; i < first; ++i)
      for (int k = first; k < 4; ++k)
        if (v[i] == v[k]) return false;
    return std::any_of(v.begin(), v.end(), [&](int i) { return geometry.inverse_masses[i] > 0; });
  };
  for (int p = 0; p < static_cast<int>(geometry.vertex_body.size()); ++p)
    for (const auto& [a, b, c] : geometry.triangles)
      if (kept({p, a, b, c}, 1)) pairs.push_back({PairKind::point_triangle, {p, a, b, c}});
  for (std::size_t i = 0; i < geometry.edges.size(); ++i)
    for (std::size_t k = i + 1; k < geometry.edges.size(); ++k) {
      const std::array<int, 4> v = {geometry.edges[i][0], geometry.edges[i][1], geometry.edges[k][0],
                                    geometry.edges[k][1]};
      if (kept(v, 2)) pairs.push_back({PairKind::edge_edge, v});
    }
  return pairs;
}

inline FourPoints between(const FourPoints& start, const FourPoints& end, double time) {
  FourPoints x;
  for (int i = 0; i < 4; ++i) x[i] = start[i] + time * (end[i] - start[i]);
  return x;
}

// The least distance at `samples` + 1 times of the way.
inline double least_distance(PairKind kind, const FourPoints& start, const FourPoints& end, int samples) {
  double least = 1e300;
  for (int i = 0; i <= samples; ++i)
    least = std::min(least, closest_points(kind, between(start, end, i / double(samples))).distance);
  return least;
}

// As of cloth so thin that sweeps leave nothing over.
inline std::vector<Contact> exact(std::vector<Contact> contacts) {
  for (Contact& contact : contacts) contact.thickness = 1e-12;
  return contacts;
}

// Resolves the contacts; returns the pull of each.
inline std::vector<Pull> resolve(Scene& scene, const std::vector<Contact>& contacts) {
  Response response = begin_response(scene.geometry, contacts, {}, 1, scene.start);
  resolve_contacts(response, scene.end);
  std::vector<Pull> pulls(contacts.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) pulls[response.groups.order[i]] = response.pulls[i];
  return pulls;
}

}  // namespace drape::test

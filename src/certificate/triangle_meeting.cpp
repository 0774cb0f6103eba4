#include "certificate/triangle_meeting.h"

#include <algorithm>

#include "certificate/orientation.h"

namespace drape {
namespace {

bool are_on_one_line(const TrianglePoints& t) { return projection_axis(t[0], t[1], t[2]) < 0; }

// Of four points on one line: along it, as along each axis, their order is the same or the reverse.
bool boxes_meet(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  for (int k = 0; k < 3; ++k)
    if (std::max(p[k], q[k]) < std::min(a[k], b[k]) || std::max(a[k], b[k]) < std::min(p[k], q[k]))
      return false;
  return true;
}

// The axis without which four points of one plane can be told apart; -1 where they lie on one line.
int axis_of_plane(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  for (const TrianglePoints& t : {TrianglePoints{p, q, a}, {p, q, b}, {a, b, p}, {a, b, q}})
    if (const int axis = projection_axis(t[0], t[1], t[2]); axis >= 0) return axis;
  return -1;
}

// Of four points of one plane, seen along `axis`.
bool segments_meet_in_plane(int axis, const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  const int at_p = orientation_without(axis, a, b, p), at_q = orientation_without(axis, a, b, q);
  const int at_a = orientation_without(axis, p, q, a), at_b = orientation_without(axis, p, q, b);
  return at_p * at_q <= 0 && at_a * at_b <= 0 && boxes_meet(p, q, a, b);
}

bool segments_meet(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) {
  if (!boxes_meet(p, q, a, b) || orientation(p, q, a, b) != 0) return false;
  const int axis = axis_of_plane(p, q, a, b);
  return axis < 0 || segments_meet_in_plane(axis, p, q, a, b);
}

bool meets_an_edge(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  return segments_meet(p, q, t[0], t[1]) || segments_meet(p, q, t[1], t[2]) ||
         segments_meet(p, q, t[2], t[0]);
}

// Of a point in the triangle's plane.
bool is_inside(const Vec3& p, const TrianglePoints& t, int axis) {
  const int a = orientation_without(axis, t[0], t[1], p), b = orientation_without(axis, t[1], t[2], p),
            c = orientation_without(axis, t[2], t[0], p);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool meets_in_plane(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const int axis = projection_axis(t[0], t[1], t[2]);
  return (axis >= 0 && is_inside(p, t, axis)) || meets_an_edge(p, q, t);
}

bool an_edge_meets(const TrianglePoints& from, const TrianglePoints& to) {
  for (int k = 0; k < 3; ++k)
    if (segment_meets_triangle(from[k], from[(k + 1) % 3], to)) return true;
  return false;
}

// Whether all corners of `t` lie strictly on one side of the plane of `plane`.
bool is_on_one_side(const TrianglePoints& t, const TrianglePoints& plane) {
  const auto side = [&](const Vec3& p) { return orientation(plane[0], plane[1], plane[2], p); };
  const int first = side(t[0]);
  return first != 0 && side(t[1]) == first && side(t[2]) == first;
}

// What a triangle consists of, seen from its first corner: pieces (corner, f, g), of which only the corner
// itself lies on no segment from the corner to (f, g). One on a line is the segments to its other corners.
struct Fan {
  std::array<TrianglePoints, 2> pieces;
  int count = 0;
};

Fan fan_of(const TrianglePoints& t) {
  if (!are_on_one_line(t)) return {{t}, 1};
  Fan fan;
  for (const Vec3& end : {t[1], t[2]})
    if (end != t[0]) fan.pieces[fan.count++] = {t[0], end, end};
  return fan;
}

// Two pieces that have more than the corner in common have a segment from it in common, whose end lies on
// the far side of one of them.
bool pieces_meet(const TrianglePoints& a, const TrianglePoints& b) {
  return segment_meets_triangle(a[1], a[2], b) || segment_meets_triangle(b[1], b[2], a);
}

bool both_corners_are_on_one_side(const TrianglePoints& t, const TrianglePoints& plane) {
  const auto side = [&](const Vec3& p) { return orientation(plane[0], plane[1], plane[2], p); };
  const int first = side(t[1]);
  return first != 0 && side(t[2]) == first;
}

// Of three points on one line: whether r lies beyond q, seen from p.
bool is_beyond(const Vec3& p, const Vec3& q, const Vec3& r) { return r != q && segments_meet(p, r, q, q); }

}  // namespace

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const TrianglePoints& t) {
  const int side_p = orientation(t[0], t[1], t[2], p), side_q = orientation(t[0], t[1], t[2], q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return meets_in_plane(p, q, t);
  const int ab = orientation(p, q, t[0], t[1]), bc = orientation(p, q, t[1], t[2]),
            ca = orientation(p, q, t[2], t[0]);
  return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

bool triangles_meet(const TrianglePoints& a, const TrianglePoints& b) {
  if (is_on_one_side(a, b) || is_on_one_side(b, a)) return false;
  return an_edge_meets(a, b) || an_edge_meets(b, a);
}

bool meet_beyond_vertex(const TrianglePoints& a, const TrianglePoints& b) {
  if (both_corners_are_on_one_side(a, b) || both_corners_are_on_one_side(b, a)) return false;
  const Fan of_a = fan_of(a), of_b = fan_of(b);
  for (int i = 0; i < of_a.count; ++i)
    for (int k = 0; k < of_b.count; ++k)
      if (pieces_meet(of_a.pieces[i], of_b.pieces[k])) return true;
  return false;
}

bool meet_beyond_edge(const TrianglePoints& a, const TrianglePoints& b) {
  const Vec3 &u = a[0], &w = a[1];
  if (orientation(u, w, a[2], b[2]) != 0) return false;
  if (u == w) return meet_beyond_vertex({u, a[2], a[2]}, {u, b[2], b[2]});
  const int axis_a = projection_axis(u, w, a[2]), axis_b = projection_axis(u, w, b[2]);
  if (axis_a >= 0 && axis_b >= 0)
    return orientation_without(axis_a, u, w, a[2]) == orientation_without(axis_a, u, w, b[2]);
  if (axis_a >= 0 || axis_b >= 0) return false;
  return (is_beyond(u, w, a[2]) && is_beyond(u, w, b[2])) || (is_beyond(w, u, a[2]) && is_beyond(w, u, b[2]));
}

}  // namespace drape

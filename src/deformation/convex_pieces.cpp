#include "deformation/convex_pieces.h"

#include <algorithm>
#include <cmath>

namespace drape {
namespace {

// Vertices, boundary edges (in the order of their triangles' corners) and one triangle of a piece.
struct Piece {
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> boundary;
  int triangle = -1;
};

std::vector<Piece> pieces_of(const Sheet& sheet, const std::vector<int>& piece_of) {
  std::vector<Piece> pieces;
  if (!piece_of.empty())
    pieces.resize(static_cast<std::size_t>(*std::max_element(piece_of.begin(), piece_of.end())) + 1);
  for (int v = 0; v < static_cast<int>(piece_of.size()); ++v) pieces[piece_of[v]].vertices.push_back(v);
  for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
    const Triangle& triangle = sheet.triangles[t];
    Piece& piece = pieces[piece_of[triangle[0]]];
    piece.triangle = t;
    for (int k = 0; k < 3; ++k)
      if (opposite_vertex(sheet.topology, sheet.triangles, t, k) < 0)
        piece.boundary.push_back({triangle[k], triangle[(k + 1) % 3]});
  }
  return pieces;
}

bool is_flat(const std::vector<Vec3>& x, const Piece& piece, const Vec3& normal, double tolerance) {
  const Vec3& origin = x[piece.vertices[0]];
  return std::all_of(piece.vertices.begin(), piece.vertices.end(),
                     [&](int v) { return std::abs(normal.dot(x[v] - origin)) <= tolerance; });
}

// Boundary edges run counter-clockwise as their triangles do: in a convex piece the whole boundary is on the
// left of each.
bool is_outline_convex(const std::vector<Vec3>& x, const Piece& piece, const Vec3& normal, double tolerance) {
  for (const auto& [from, to] : piece.boundary) {
    const Vec3 inward = normal.cross((x[to] - x[from]).normalized());
    for (const auto& edge : piece.boundary)
      if (inward.dot(x[edge[0]] - x[from]) < -tolerance) return false;
  }
  return !piece.boundary.empty();
}

bool is_convex(const Sheet& sheet, const Piece& piece) {
  if (piece.triangle < 0) return false;
  const std::vector<Vec3>& x = sheet.rest_positions;
  const auto& [a, b, c] = sheet.triangles[piece.triangle];
  const Vec3 normal = (x[b] - x[a]).cross(x[c] - x[a]).normalized();
  double size = 0;
  for (const int v : piece.vertices) size = std::max(size, (x[v] - x[a]).norm());
  return is_flat(x, piece, normal, 1e-6 * size) && is_outline_convex(x, piece, normal, 1e-6 * size);
}

}  // namespace

std::vector<char> convex_pieces(const Sheet& sheet, const std::vector<int>& piece_of) {
  std::vector<char> convex;
  for (const Piece& piece : pieces_of(sheet, piece_of)) convex.push_back(is_convex(sheet, piece));
  return convex;
}

}  // namespace drape

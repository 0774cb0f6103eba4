#include "deformation/momentum.h"

namespace drape {

namespace {

struct Inertia {
  Vec3 centre = Vec3::Zero();
  Mat3 tensor = Mat3::Zero();
};

Inertia inertia_of(const FreePiece& piece, const std::vector<double>& masses, const std::vector<Vec3>& x) {
  Inertia inertia;
  double total = 0;
  for (const int v : piece.vertices) {
    total += masses[v];
    inertia.centre += masses[v] * x[v];
  }
  inertia.centre /= total;
  for (const int v : piece.vertices) {
    const Vec3 r = x[v] - inertia.centre;
    inertia.tensor += masses[v] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  return inertia;
}

}  // namespace

void restore_angular_momentum(const FreePiece& piece, const std::vector<double>& masses,
                              const std::vector<Vec3>& start, const std::vector<Vec3>& before_pull,
                              std::vector<Vec3>& x) {
  const Inertia inertia = inertia_of(piece, masses, start);
  Vec3 lost = Vec3::Zero();
  for (const int v : piece.vertices)
    lost += masses[v] * (start[v] - inertia.centre).cross(before_pull[v] - x[v]);
  // A line of points has no inertia about itself, and needs none.
  const Mat3 tensor = inertia.tensor + 1e-12 * inertia.tensor.trace() * Mat3::Identity();
  const Vec3 turn = tensor.inverse() * lost;
  for (const int v : piece.vertices) x[v] += turn.cross(start[v] - inertia.centre);
}

}  // namespace drape

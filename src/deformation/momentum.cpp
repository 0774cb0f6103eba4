#include "deformation/momentum.h"

namespace drape {

namespace {

// Of a piece at one time, all about its centre of mass.
struct Momenta {
  double mass = 0;
  Vec3 centre = Vec3::Zero();
  Vec3 linear = Vec3::Zero();
  Vec3 angular = Vec3::Zero();
};

Momenta momenta_of(const FreePiece& piece, const std::vector<double>& masses, const std::vector<Vec3>& x,
                   const std::vector<Vec3>& v) {
  Momenta momenta;
  for (const int i : piece.vertices) {
    momenta.mass += masses[i];
    momenta.centre += masses[i] * x[i];
    momenta.linear += masses[i] * v[i];
  }
  momenta.centre /= momenta.mass;
  for (const int i : piece.vertices) momenta.angular += masses[i] * (x[i] - momenta.centre).cross(v[i]);
  return momenta;
}

Mat3 inertia_about(const FreePiece& piece, const Vec3& centre, const std::vector<double>& masses,
                   const std::vector<Vec3>& x) {
  Mat3 tensor = Mat3::Zero();
  for (const int i : piece.vertices) {
    const Vec3 r = x[i] - centre;
    tensor += masses[i] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
  }
  // A line of points has no inertia about itself, and needs none.
  return tensor + 1e-12 * tensor.trace() * Mat3::Identity();
}

}  // namespace

void restore_momenta(const FreePiece& piece, const std::vector<double>& masses, const std::vector<Vec3>& x0,
                     const std::vector<Vec3>& v0, const std::vector<Vec3>& a, double step,
                     std::vector<Vec3>& x1, std::vector<Vec3>& v1) {
  const Momenta before = momenta_of(piece, masses, x0, v0), after = momenta_of(piece, masses, x1, v1);
  const Momenta rate = momenta_of(piece, masses, x0, a);
  const Vec3 shift = (before.linear + step * rate.linear - after.linear) / after.mass;
  const Vec3 lost = before.angular + step * rate.angular - after.angular;
  const Vec3 turn = inertia_about(piece, after.centre, masses, x1).inverse() * lost;
  const Vec3 way = step / before.mass * (before.linear + step * rate.linear);
  const Vec3 astray = before.centre + way - after.centre;
  for (const int i : piece.vertices) {
    v1[i] += shift + turn.cross(x1[i] - after.centre);
    x1[i] += astray;
  }
}

}  // namespace drape

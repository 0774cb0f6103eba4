#include "deformation/momentum.h"

#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t block = 1024;

// Sums over points, each times its mass, with positions from a reference point.
struct Moments {
  double mass = 0;
  Vec3 place = Vec3::Zero(), linear = Vec3::Zero(), angular = Vec3::Zero();

  void add(double m, const Vec3& x, const Vec3& v) {
    mass += m;
    place += m * x;
    linear += m * v;
    angular += m * x.cross(v);
  }
  void add(const Moments& other) {
    mass += other.mass;
    place += other.place;
    linear += other.linear;
    angular += other.angular;
  }
  Vec3 centre() const { return place / mass; }
  Vec3 angular_about_centre() const { return angular - centre().cross(linear); }
};

// What a step's start, its end and its accelerations amount to.
struct StepMoments {
  Moments start, end, rate;
  Mat3 spread = Mat3::Zero();  // of m x x^T at the end

  void add(const StepMoments& other) {
    start.add(other.start);
    end.add(other.end);
    rate.add(other.rate);
    spread += other.spread;
  }
};

template <typename MomentsOfPoint>
StepMoments sum_over(const FreePiece& piece, const MomentsOfPoint& add_point) {
  std::vector<StepMoments> parts((piece.vertices.size() + block - 1) / block);
  parallel_blocks(piece.vertices.size(), block, [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t i = begin; i < end; ++i) add_point(piece.vertices[i], parts[part]);
  });
  StepMoments sum;
  for (const StepMoments& part : parts) sum.add(part);
  return sum;
}

Mat3 inertia_about_centre(const StepMoments& moments) {
  const Vec3 centre = moments.end.centre();
  const Mat3 spread = moments.spread - moments.end.mass * centre * centre.transpose();
  const Mat3 tensor = spread.trace() * Mat3::Identity() - spread;
  // A line of points has no inertia about itself, and needs none.
  return tensor + 1e-12 * tensor.trace() * Mat3::Identity();
}

}  // namespace

void restore_momenta(const FreePiece& piece, const std::vector<double>& masses, const std::vector<Vec3>& x0,
                     const std::vector<Vec3>& v0, const std::vector<Vec3>& a, double step,
                     std::vector<Vec3>& x1, std::vector<Vec3>& v1) {
  const Vec3 reference = x0[piece.vertices.front()];
  const StepMoments moments = sum_over(piece, [&](int i, StepMoments& sum) {
    const Vec3 from = x0[i] - reference, to = x1[i] - reference;
    sum.start.add(masses[i], from, v0[i]);
    sum.rate.add(masses[i], from, a[i]);
    sum.end.add(masses[i], to, v1[i]);
    sum.spread += masses[i] * to * to.transpose();
  });
  const auto& [start, end, rate, spread] = moments;
  const Vec3 linear = start.linear + step * rate.linear;
  const Vec3 angular = start.angular_about_centre() + step * rate.angular_about_centre();
  const Vec3 shift = (linear - end.linear) / end.mass;
  const Vec3 turn = inertia_about_centre(moments).inverse() * (angular - end.angular_about_centre());
  const Vec3 astray = start.centre() + step / start.mass * linear - end.centre();
  const Vec3 centre = reference + end.centre();
  parallel_for_each(piece.vertices.size(), block, [&](std::size_t k) {
    const int i = piece.vertices[k];
    v1[i] += shift + turn.cross(x1[i] - centre);
    x1[i] += astray;
  });
}

}  // namespace drape

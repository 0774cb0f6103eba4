#include "deformation/momentum.h"

#include <array>

#include "core/double_lanes.h"
#include "core/parallel.h"

namespace drape {
namespace {

constexpr std::size_t block = 512;
static_assert(block % DoubleLanes::count == 0, "no four points are of two blocks");

// Sums over points, each times its mass, with places from a reference point; every lane has its own.
struct Moments {
  LaneVectors place, linear, angular;

  void add(DoubleLanes m, const LaneVectors& x, const LaneVectors& v) {
    const LaneVectors momentum = m * v;
    place = multiply_add(m, x, place);
    linear = linear + momentum;
    angular = angular + cross(x, momentum);
  }
  void add(const Moments& other) {
    place = place + other.place;
    linear = linear + other.linear;
    angular = angular + other.angular;
  }
};

// What a step's start, with what its accelerations make of the velocities, and its end amount to.
struct StepMoments {
  DoubleLanes mass;
  Moments start, end;
  LaneVectors squares, products;  // at the end: of m x2, m y2 and m z2; of m y z, m z x and m x y

  void add_spread(DoubleLanes m, const LaneVectors& x) {
    const LaneVectors p = m * x;
    squares = squares + LaneVectors{p.x * x.x, p.y * x.y, p.z * x.z};
    products = products + LaneVectors{p.y * x.z, p.z * x.x, p.x * x.y};
  }
  void add(const StepMoments& other) {
    mass = mass + other.mass;
    start.add(other.start);
    end.add(other.end);
    squares = squares + other.squares;
    products = products + other.products;
  }
};

// Calls add_four(first, sum) for each four points of `count`, the last of them perhaps fewer.
template <typename AddFour>
StepMoments sum_over(std::size_t count, const AddFour& add_four) {
  std::vector<StepMoments> parts((count + block - 1) / block);
  parallel_blocks(count, block, [&](std::size_t begin, std::size_t end, std::size_t part) {
    StepMoments sum{};
    for (std::size_t first = begin; first < end; first += DoubleLanes::count) add_four(first, sum);
    parts[part] = sum;
  });
  StepMoments sum{};
  for (const StepMoments& part : parts) sum.add(part);
  return sum;
}

// Lanes beyond the last point repeat it, without a mass.
struct FourMasses {
  FourIndices vertices;
  DoubleLanes masses;
};

FourMasses four_masses(const FreePiece& piece, const std::vector<double>& masses, std::size_t first) {
  FourMasses points{};
  std::array<double, DoubleLanes::count> mass{};
  for (std::size_t lane = 0; lane < mass.size(); ++lane) {
    const bool is_there = first + lane < piece.vertices.size();
    points.vertices[lane] = is_there ? piece.vertices[first + lane] : piece.vertices.back();
    mass[lane] = is_there ? masses[points.vertices[lane]] : 0;
  }
  points.masses = load_lanes(mass.data(), in_order);
  return points;
}

// All lanes of Moments together.
struct Totals {
  Vec3 centre, linear, angular_about_centre;
};

Totals totals(const Moments& moments, double mass) {
  const Vec3 centre = sum_of_lanes(moments.place) / mass, linear = sum_of_lanes(moments.linear);
  return {centre, linear, sum_of_lanes(moments.angular) - centre.cross(linear)};
}

Mat3 inertia_about_centre(const StepMoments& moments, double mass, const Vec3& centre) {
  const Vec3 squares = sum_of_lanes(moments.squares), products = sum_of_lanes(moments.products);
  Mat3 spread = squares.asDiagonal();
  spread(1, 2) = spread(2, 1) = products.x();
  spread(2, 0) = spread(0, 2) = products.y();
  spread(0, 1) = spread(1, 0) = products.z();
  spread -= mass * centre * centre.transpose();
  const Mat3 tensor = spread.trace() * Mat3::Identity() - spread;
  // A line of points has no inertia about itself, and needs none.
  return tensor + 1e-12 * tensor.trace() * Mat3::Identity();
}

}  // namespace

void restore_momenta(const FreePiece& piece, const std::vector<double>& masses, const std::vector<Vec3>& x0,
                     const std::vector<Vec3>& v0, const std::vector<Vec3>& a, double step,
                     std::vector<Vec3>& x1, std::vector<Vec3>& v1) {
  const Vec3 reference = x0[piece.vertices.front()];
  const LaneVectors origin{reference.x(), reference.y(), reference.z()};
  const StepMoments moments = sum_over(piece.vertices.size(), [&](std::size_t first, StepMoments& sum) {
    const auto [vertices, m] = four_masses(piece, masses, first);
    const LaneVectors to = load_lanes(x1.data(), vertices) - origin;
    const LaneVectors pushed =
        multiply_add(DoubleLanes(step), load_lanes(a.data(), vertices), load_lanes(v0.data(), vertices));
    sum.mass = sum.mass + m;
    sum.start.add(m, load_lanes(x0.data(), vertices) - origin, pushed);
    sum.end.add(m, to, load_lanes(v1.data(), vertices));
    sum.add_spread(m, to);
  });
  const double mass = sum_of_lanes(moments.mass);
  const Totals start = totals(moments.start, mass), end = totals(moments.end, mass);
  const Vec3 shift = (start.linear - end.linear) / mass;
  const Vec3 turn = inertia_about_centre(moments, mass, end.centre).inverse() *
                    (start.angular_about_centre - end.angular_about_centre);
  const Vec3 astray = start.centre + step / mass * start.linear - end.centre;
  const Vec3 centre = reference + end.centre;
  parallel_for_each(piece.vertices.size(), block, [&](std::size_t k) {
    const int i = piece.vertices[k];
    v1[i] += shift + turn.cross(x1[i] - centre);
    x1[i] += astray;
  });
}

}  // namespace drape

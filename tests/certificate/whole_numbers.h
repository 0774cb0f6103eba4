#pragma once

#include <array>
#include <random>

#include "core/vector.h"

namespace drape::test {

// Geometry in whole numbers, by other means than the code under test: what they say is exact.
using Whole = std::array<long long, 3>;
using WholeTriangle = std::array<Whole, 3>;

__extension__ typedef __int128 Long;

Vec3 to_vector(const Whole& p, double scale = 1, double offset = 0);

// The determinant of (a - d, b - d, c - d).
Long determinant(const Whole& a, const Whole& b, const Whole& c, const Whole& d);

// Whether two closed triangles, of whatever shape, meet: no axis separates them. Coordinates up to 1000.
bool no_axis_separates(const WholeTriangle& a, const WholeTriangle& b);

// Whether two triangles of some area with the same first corner share more than it: whether the wedges at the
// corner do.
bool wedges_overlap(const WholeTriangle& a, const WholeTriangle& b);

bool has_area(const WholeTriangle& t);

class WholeRandom {
 public:
  explicit WholeRandom(unsigned seed) : engine_(seed) {}
  long long number(long long largest) {
    return std::uniform_int_distribution<long long>(-largest, largest)(engine_);
  }
  Whole point(long long largest) {
    const long long x = number(largest), y = number(largest);
    return {x, y, number(largest)};
  }
  WholeTriangle triangle(long long largest) {
    const Whole a = point(largest), b = point(largest);
    return {a, b, point(largest)};
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace drape::test

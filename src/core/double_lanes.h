#pragma once

// Four doubles side by side, as lanes.h has floats: the same bits as four doubles one by one.

#include <array>
#include <cmath>

#include "core/lanes.h"
#include "core/vector.h"

namespace drape {

struct DoubleLanes {
  static constexpr int count = 4;
  __m256d v;
  DoubleLanes() = default;
  DoubleLanes(__m256d value) : v(value) {}
  DoubleLanes(double value) : v(_mm256_set1_pd(value)) {}
};
inline DoubleLanes operator+(DoubleLanes a, DoubleLanes b) { return _mm256_add_pd(a.v, b.v); }
inline DoubleLanes operator-(DoubleLanes a, DoubleLanes b) { return _mm256_sub_pd(a.v, b.v); }
inline DoubleLanes operator*(DoubleLanes a, DoubleLanes b) { return _mm256_mul_pd(a.v, b.v); }
inline DoubleLanes operator/(DoubleLanes a, DoubleLanes b) { return _mm256_div_pd(a.v, b.v); }

inline DoubleLanes square_root(DoubleLanes a) { return _mm256_sqrt_pd(a.v); }
inline double square_root(double a) { return std::sqrt(a); }

// a * b + c and c - a * b, rounded once.
inline DoubleLanes multiply_add(DoubleLanes a, DoubleLanes b, DoubleLanes c) {
  return _mm256_fmadd_pd(a.v, b.v, c.v);
}
inline DoubleLanes subtract_product(DoubleLanes a, DoubleLanes b, DoubleLanes c) {
  return _mm256_fnmadd_pd(a.v, b.v, c.v);
}

// test > 0 ? yes : no, lane by lane.
inline DoubleLanes where_positive(DoubleLanes test, DoubleLanes yes, DoubleLanes no) {
  return _mm256_blendv_pd(no.v, yes.v, _mm256_cmp_pd(test.v, _mm256_setzero_pd(), _CMP_GT_OQ));
}
inline double where_positive(double test, double yes, double no) { return test > 0 ? yes : no; }

using LaneVectors = LaneVec3<DoubleLanes>;
using FourIndices = std::array<int, DoubleLanes::count>;
constexpr FourIndices in_order = {0, 1, 2, 3};

inline DoubleLanes load_lanes(const double* numbers, const FourIndices& i) {
  return _mm256_set_pd(numbers[i[3]], numbers[i[2]], numbers[i[1]], numbers[i[0]]);
}

// Four rows to and from columns: its own inverse.
inline void transpose(__m256d& a, __m256d& b, __m256d& c, __m256d& d) {
  const __m256d ab_low = _mm256_unpacklo_pd(a, b), ab_high = _mm256_unpackhi_pd(a, b);
  const __m256d cd_low = _mm256_unpacklo_pd(c, d), cd_high = _mm256_unpackhi_pd(c, d);
  a = _mm256_permute2f128_pd(ab_low, cd_low, 0x20);
  b = _mm256_permute2f128_pd(ab_high, cd_high, 0x20);
  c = _mm256_permute2f128_pd(ab_low, cd_low, 0x31);
  d = _mm256_permute2f128_pd(ab_high, cd_high, 0x31);
}

// Three doubles of a vector are a register but for its last place, which is not read.
inline __m256i three_places() { return _mm256_set_epi64x(0, -1, -1, -1); }

inline LaneVectors load_lanes(const Vec3* points, const FourIndices& i) {
  const auto row = [&](int lane) { return _mm256_maskload_pd(points[i[lane]].data(), three_places()); };
  __m256d a = row(0), b = row(1), c = row(2), d = row(3);
  transpose(a, b, c, d);
  return {a, b, c};
}

inline std::array<Vec3, DoubleLanes::count> each_lane(const LaneVectors& value) {
  __m256d a = value.x.v, b = value.y.v, c = value.z.v, d = _mm256_setzero_pd();
  transpose(a, b, c, d);
  std::array<Vec3, DoubleLanes::count> result;
  const auto put = [&](int lane, __m256d row) {
    _mm_storeu_pd(result[lane].data(), _mm256_castpd256_pd128(row));
    _mm_store_sd(result[lane].data() + 2, _mm256_extractf128_pd(row, 1));
  };
  put(0, a), put(1, b), put(2, c), put(3, d);
  return result;
}

inline double sum_of_lanes(DoubleLanes a) {
  alignas(32) double lanes[DoubleLanes::count];
  _mm256_store_pd(lanes, a.v);
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}
inline Vec3 sum_of_lanes(const LaneVectors& a) {
  return {sum_of_lanes(a.x), sum_of_lanes(a.y), sum_of_lanes(a.z)};
}

}  // namespace drape

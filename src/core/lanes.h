#pragma once

// Eight floats side by side. Vector instructions are in this file and in double_lanes.h only. Every operation
// is exact to the last bit as IEEE 754 has it (no estimates, no contraction), so eight lanes give the same
// bits as eight floats one by one.

#include <immintrin.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace drape {

// Eight floats, or indices, as they lie in memory.
struct alignas(32) LaneRow {
  float values[8];
};
// Vertices, kept as places of floats in an array of Point4, without a sign, and lane i next to lane i + 4,
// which go together into one register: fewer instructions for each of many loads.
class alignas(32) IndexRow {
 public:
  int vertex(int lane) const { return static_cast<int>(places_[slot(lane)] / 4); }
  void set(int lane, int vertex) { places_[slot(lane)] = 4 * static_cast<std::uint32_t>(vertex); }
  // Places of lanes i and i + 4.
  struct Pair {
    std::uint32_t low, high;
  };
  Pair pair(int i) const {
    std::uint64_t both = 0;
    std::memcpy(&both, places_ + static_cast<std::ptrdiff_t>(2) * i, sizeof both);
    return {static_cast<std::uint32_t>(both), static_cast<std::uint32_t>(both >> 32)};
  }

 private:
  static int slot(int lane) { return 2 * (lane % 4) + lane / 4; }
  std::uint32_t places_[8];
};

// A point of single precision with a fourth number of its own.
struct alignas(16) Point4 {
  float x, y, z, w;
};

// A Point4 in a register.
struct PointLanes {
  __m128 v;
};
inline PointLanes load_point(const Point4& point) { return {_mm_load_ps(&point.x)}; }
inline void store_point(PointLanes value, Point4& point) { _mm_store_ps(&point.x, value.v); }
inline PointLanes operator+(PointLanes a, PointLanes b) { return {_mm_add_ps(a.v, b.v)}; }
inline PointLanes operator-(PointLanes a, PointLanes b) { return {_mm_sub_ps(a.v, b.v)}; }
// a + s b in x, y, z, and w of a.
inline PointLanes add_multiple(PointLanes a, float s, PointLanes b) {
  return {_mm_blend_ps(_mm_add_ps(a.v, _mm_mul_ps(_mm_set1_ps(s), b.v)), a.v, 8)};
}
// s a in x, y, z, and w of a.
inline PointLanes scaled(float s, PointLanes a) {
  return {_mm_blend_ps(_mm_mul_ps(_mm_set1_ps(s), a.v), a.v, 8)};
}

struct Lanes {
  static constexpr int count = 8;
  __m256 v;
  Lanes() = default;
  Lanes(__m256 value) : v(value) {}
  Lanes(float value) : v(_mm256_set1_ps(value)) {}
};
inline Lanes operator+(Lanes a, Lanes b) { return _mm256_add_ps(a.v, b.v); }
inline Lanes operator-(Lanes a, Lanes b) { return _mm256_sub_ps(a.v, b.v); }
inline Lanes operator*(Lanes a, Lanes b) { return _mm256_mul_ps(a.v, b.v); }
inline Lanes operator/(Lanes a, Lanes b) { return _mm256_div_ps(a.v, b.v); }
inline Lanes operator-(Lanes a) { return _mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f)); }

inline Lanes square_root(Lanes a) { return _mm256_sqrt_ps(a.v); }
inline float square_root(float a) { return std::sqrt(a); }

// a * b + c, rounded once.
inline Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return _mm256_fmadd_ps(a.v, b.v, c.v); }
inline float multiply_add(float a, float b, float c) { return std::fma(a, b, c); }
// c - a * b, rounded once.
inline Lanes subtract_product(Lanes a, Lanes b, Lanes c) { return _mm256_fnmadd_ps(a.v, b.v, c.v); }
inline float subtract_product(float a, float b, float c) { return std::fma(-a, b, c); }

// test > 0 ? yes : no, lane by lane.
inline Lanes where_positive(Lanes test, Lanes yes, Lanes no) {
  return _mm256_blendv_ps(no.v, yes.v, _mm256_cmp_ps(test.v, _mm256_setzero_ps(), _CMP_GT_OQ));
}
inline float where_positive(float test, float yes, float no) { return test > 0 ? yes : no; }
inline bool all_positive(Lanes test) {
  return _mm256_movemask_ps(_mm256_cmp_ps(test.v, _mm256_setzero_ps(), _CMP_GT_OQ)) == 0xff;
}
inline bool all_positive(float test) { return test > 0; }

// Three coordinates (and a fourth number) of one point, or of several.
template <typename Number>
struct LaneVec3 {
  Number x, y, z;
};
template <typename Number>
struct LanePoint {
  LaneVec3<Number> p;
  Number w;
};

template <typename Number>
LaneVec3<Number> operator+(const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <typename Number>
LaneVec3<Number> operator-(const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <typename Number>
LaneVec3<Number> operator*(Number s, const LaneVec3<Number>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <typename Number>
LaneVec3<Number> multiply_add(Number s, const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return {multiply_add(s, a.x, b.x), multiply_add(s, a.y, b.y), multiply_add(s, a.z, b.z)};
}
template <typename Number>
LaneVec3<Number> subtract_product(Number s, const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return {subtract_product(s, a.x, b.x), subtract_product(s, a.y, b.y), subtract_product(s, a.z, b.z)};
}
template <typename Number>
Number dot(const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return multiply_add(a.x, b.x, multiply_add(a.y, b.y, a.z * b.z));
}
template <typename Number>
LaneVec3<Number> cross(const LaneVec3<Number>& a, const LaneVec3<Number>& b) {
  return {subtract_product(a.z, b.y, a.y * b.z), subtract_product(a.x, b.z, a.z * b.x),
          subtract_product(a.y, b.x, a.x * b.y)};
}

// How kernels read and write: as eight lanes, or one of them (`lane`) as a float.
template <typename Number>
struct LaneAccess;

template <>
struct LaneAccess<float> {
  int lane = 0;
  int begin() const { return lane; }
  int end() const { return lane + 1; }
  float load(const LaneRow& row) const { return row.values[lane]; }
  void store(LaneRow& row, float value) const { row.values[lane] = value; }
  LanePoint<float> gather(const Point4* points, const IndexRow& indices) const {
    const Point4& point = points[indices.vertex(lane)];
    return {{point.x, point.y, point.z}, point.w};
  }
  void scatter(Point4* points, const IndexRow& indices, const LanePoint<float>& value) const {
    points[indices.vertex(lane)] = {value.p.x, value.p.y, value.p.z, value.w};
  }
};

// Four rows of two points each (lane i and lane i + 4) to and from columns: its own inverse.
inline void transpose_halves(__m256& a, __m256& b, __m256& c, __m256& d) {
  const __m256 ab_low = _mm256_unpacklo_ps(a, b), ab_high = _mm256_unpackhi_ps(a, b);
  const __m256 cd_low = _mm256_unpacklo_ps(c, d), cd_high = _mm256_unpackhi_ps(c, d);
  a = _mm256_shuffle_ps(ab_low, cd_low, _MM_SHUFFLE(1, 0, 1, 0));
  b = _mm256_shuffle_ps(ab_low, cd_low, _MM_SHUFFLE(3, 2, 3, 2));
  c = _mm256_shuffle_ps(ab_high, cd_high, _MM_SHUFFLE(1, 0, 1, 0));
  d = _mm256_shuffle_ps(ab_high, cd_high, _MM_SHUFFLE(3, 2, 3, 2));
}

// Loads and transposes beat the gather instruction by half and more on the processors of 2019 to 2023.
template <>
struct LaneAccess<Lanes> {
  int begin() const { return 0; }
  int end() const { return Lanes::count; }
  Lanes load(const LaneRow& row) const { return _mm256_load_ps(row.values); }
  void store(LaneRow& row, Lanes value) const { _mm256_store_ps(row.values, value.v); }
  LanePoint<Lanes> gather(const Point4* points, const IndexRow& indices) const {
    const float* first = &points->x;
    const auto two = [&](int i) {
      const auto [low, high] = indices.pair(i);
      return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(first + low)), _mm_load_ps(first + high),
                                  1);
    };
    __m256 a = two(0), b = two(1), c = two(2), d = two(3);
    transpose_halves(a, b, c, d);
    return {{a, b, c}, d};
  }
  void scatter(Point4* points, const IndexRow& indices, const LanePoint<Lanes>& value) const {
    __m256 a = value.p.x.v, b = value.p.y.v, c = value.p.z.v, d = value.w.v;
    transpose_halves(a, b, c, d);
    const auto two = [&](int i, __m256 pair) {
      const auto [low, high] = indices.pair(i);
      _mm_store_ps(&points->x + low, _mm256_castps256_ps128(pair));
      _mm_store_ps(&points->x + high, _mm256_extractf128_ps(pair, 1));
    };
    two(0, a), two(1, b), two(2, c), two(3, d);
  }
};

}  // namespace drape

#pragma once

#include <array>
#include <cmath>

namespace drape {

// A number as the exact sum of doubles that do not overlap, the smallest first, without zeros. Sums and
// products of expansions are exact as long as nothing over- or underflows. Source: J. R. Shewchuk, Adaptive
// precision floating-point arithmetic and fast robust geometric predicates, Discrete & Computational Geometry
// 18, 1997: expansion-sum and scale-expansion.
template <int capacity>
struct Expansion {
  std::array<double, capacity> parts;
  int count = 0;

  void append(double part) {
    if (part != 0) parts[count++] = part;
  }
  // The largest part outweighs all others.
  int sign() const { return count == 0 ? 0 : (parts[count - 1] > 0 ? 1 : -1); }
};

// a + b = sum + rest, exactly.
inline void exact_sum(double a, double b, double& sum, double& rest) {
  sum = a + b;
  const double b_in_sum = sum - a;
  rest = (a - (sum - b_in_sum)) + (b - b_in_sum);
}

// a - b
inline Expansion<2> exact_difference(double a, double b) {
  double sum = 0, rest = 0;
  exact_sum(a, -b, sum, rest);
  Expansion<2> result;
  result.append(rest);
  result.append(sum);
  return result;
}

// The first `count` parts of `e`, and `addend` added to them.
template <int capacity>
void grow(Expansion<capacity>& e, double addend) {
  const int count = e.count;
  e.count = 0;
  for (int i = 0; i < count; ++i) {
    double rest = 0;
    exact_sum(addend, e.parts[i], addend, rest);
    e.append(rest);
  }
  e.append(addend);
}

template <int m, int n>
Expansion<m + n> operator+(const Expansion<m>& a, const Expansion<n>& b) {
  Expansion<m + n> sum;
  for (int i = 0; i < a.count; ++i) sum.append(a.parts[i]);
  for (int i = 0; i < b.count; ++i) grow(sum, b.parts[i]);
  return sum;
}

template <int n>
Expansion<n> operator-(Expansion<n> a) {
  for (int i = 0; i < a.count; ++i) a.parts[i] = -a.parts[i];
  return a;
}

template <int m, int n>
Expansion<m + n> operator-(const Expansion<m>& a, const Expansion<n>& b) {
  return a + -b;
}

template <int n>
Expansion<2 * n> operator*(const Expansion<n>& e, double factor) {
  Expansion<2 * n> product;
  for (int i = 0; i < e.count; ++i) {
    const double high = e.parts[i] * factor;
    const double low = std::fma(e.parts[i], factor, -high);
    grow(product, low);
    grow(product, high);
  }
  return product;
}

template <int m, int n>
Expansion<2 * m * n> operator*(const Expansion<m>& a, const Expansion<n>& b) {
  Expansion<2 * m * n> sum;
  for (int i = 0; i < b.count; ++i) {
    const Expansion<2 * m> product = a * b.parts[i];
    for (int k = 0; k < product.count; ++k) grow(sum, product.parts[k]);
  }
  return sum;
}

}  // namespace drape

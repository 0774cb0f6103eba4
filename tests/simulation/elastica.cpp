#include "simulation/elastica.h"

#include <cmath>

namespace drape::test {
namespace {

struct Shot {
  double end_curvature;
  Tip tip;
};

// Midpoint rule from the clamp, where the curvature is `curvature`. `load` = rho g / B.
Shot shoot(double length, double load, double curvature) {
  constexpr int parts = 2000;
  const double h = length / parts;
  double angle = 0;
  Tip tip{0, 0};
  for (int i = 0; i < parts; ++i) {
    const double middle = angle + 0.5 * h * curvature;
    const double unbent = h * load * (length - (i + 0.5) * h) * std::cos(middle);
    angle += h * (curvature - 0.5 * unbent);
    curvature -= unbent;
    tip.x += h * std::cos(middle);
    tip.y -= h * std::sin(middle);
  }
  return {curvature, tip};
}

}  // namespace

Tip elastica_tip(double length, double rigidity, double density) {
  const double load = density * 9.81 / rigidity;
  double low = 0, high = 0.5 * load * length * length;  // the clamp's curvature, were the strip level
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (shoot(length, load, middle).end_curvature > 0 ? high : low) = middle;
  }
  return shoot(length, load, high).tip;
}

}  // namespace drape::test

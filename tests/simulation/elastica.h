#pragma once

namespace drape::test {

struct Tip {
  double x, y;  // m from the clamp, y up
};

// Where the tip of a strip of `length` (m) rests that is clamped level and bends under its weight: the
// elastica B th'' = -rho g (L - s) cos th, th(0) = 0, th'(L) = 0, with th the angle below the level, B the
// `rigidity` (N m) and rho the `density` (kg/m2). Exact, for it hangs by shooting.
Tip elastica_tip(double length, double rigidity, double density);

}  // namespace drape::test

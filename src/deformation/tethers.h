#pragma once

#include <vector>

#include "core/lanes.h"
#include "deformation/sheet.h"
#include "deformation/split_points.h"

namespace drape {

// Long-range attachments (Kim, Chentanez, Mueller-Fischer 2012): no point is farther from a pinned one than
// the rest shape's way between them. A pull over many edges takes many sweeps to reach a pin; a tether takes
// one. Its length has the slack that the material itself gives under the weight of its piece, so that soft
// cloth still stretches by its own stiffness.
struct Tether {
  int vertex, pin;
  float length;  // m
};
struct TetherStage {
  std::vector<Tether> tethers;  // one a vertex at most
};

// From each vertex to one vertex of the nearest group of pinned neighbours. `gravity` in m/s2.
TetherStage build_tethers(const Sheet& sheet, const std::vector<double>& masses,
                          const std::vector<char>& pinned, double gravity);

// Vectors from the pin to the vertex where a step starts, one for each tether.
void load_tethers(const TetherStage& stage, const SplitPoints& start, std::vector<Point4>& base);

void pull_tethers(const TetherStage& stage, const std::vector<Point4>& base, std::vector<Point4>& offsets);

}  // namespace drape

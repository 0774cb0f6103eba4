#pragma once

#include <vector>

#include "deformation/sheet.h"

namespace drape::bench {

// A square sheet in the plane z = 0, held at its two upper corners: the cloth of section 6.1 of the paper.
struct HangingSheet {
  Sheet sheet;
  std::vector<double> masses;
  std::vector<char> pinned;
  std::vector<Vec3> gravity;  // m/s2, of each point; none where pinned

  double side = 0;  // m
};

HangingSheet hanging_sheet(int points_a_side, double side, const ElasticMaterial& material);

// Where it starts to swing from, as in the paper's test of speed: its lower corners pulled out and forward.
std::vector<Vec3> with_corners_pulled(const HangingSheet& hanging);

}  // namespace drape::bench

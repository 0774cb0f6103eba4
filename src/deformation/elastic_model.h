#pragma once

#include <vector>

#include "deformation/bending.h"
#include "deformation/clusters.h"
#include "deformation/fibres.h"
#include "deformation/sheet.h"

namespace drape {

// The default deformation model, built for one step length and one set of pinned points.
struct ElasticModel {
  HingeStage hinges;
  ClusterStage outer_corners;
  ClusterStage own_triangles;
  FibreStage fibres;
  std::vector<double> inverse_masses;  // 1/kg; 0 where pinned
  double step;                         // seconds
};

// Pinned points weigh 1e4 times their mass in clusters, so that clusters turn about them.
ElasticModel build_elastic_model(const Sheet& sheet, const std::vector<double>& masses,
                                 const std::vector<char>& pinned, double step);

// x* -> x**: the weak and wide stages first, so that the stiff ones have the last word. Of these the fibres
// go before the own triangles: the other way round, a hanging sheet stretches five times as much.
void pull_to_goals(const ElasticModel& model, FibreScratch& scratch, std::vector<Vec3>& x);

}  // namespace drape

#pragma once

#include "scene/description.h"
#include "simulation/cache.h"

namespace drape::app {

// What Cusick's drape test finds (BS 5058, ISO 9073-9; G. E. Cusick, The measurement of fabric drape, J.
// Text. Inst. 59, 1968).
struct DrapeFigures {
  double coefficient =
      0;          // percent: the share of the ring between table and flat cloth that the shadow covers
  int folds = 0;  // the nodes of the shadow's outline
};

// Of a frame of the scene, which has a drape test. The shadow falls straight down.
DrapeFigures measure_drape(const SceneDescription& scene, const CachedFrame& frame);

}  // namespace drape::app

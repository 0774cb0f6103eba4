#pragma once

#include <vector>

#include "app/frame_surfaces.h"

namespace drape::app {

// The points that each cloth is drawn with in a frame, smoothed as far as that lets nothing meet: Loop's
// surface goes through corners that the simulated one goes round, and so into a neighbour or a collider that
// is as near as contact allows. Where it does, its points go back towards the flat triangles, which are the
// simulated surface, by halves and, in the end, all the way.
std::vector<std::vector<Vec3f>> drawn_points(const PreparedScene& scene, const CachedFrame& frame);

// All cloths as one surface; `points` as above.
ClothSurface as_one_surface(const PreparedScene& scene, const std::vector<std::vector<Vec3f>>& points);

}  // namespace drape::app

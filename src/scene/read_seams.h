#pragma once

#include <vector>

#include "scene/description.h"
#include "scene/section.h"

namespace drape {

// The list `seams` of a scene whose cloths are read. Frame n is at the time n / fps.
std::vector<SeamInput> read_seams(const Section& scene, const std::vector<ClothDescription>& cloths,
                                  double fps);

}  // namespace drape

#pragma once

#include "scene/description.h"
#include "scene/section.h"

namespace drape {

// A key `look` of the section, over what `look` holds already.
void read_look(const Section& owner, Look& look);

}  // namespace drape

#pragma once

#include <vector>

#include "app/console.h"
#include "app/frame_surfaces.h"
#include "app/options.h"
#include "app/run.h"
#include "render/rasterizer.h"

namespace drape::app {

// Draws frames from the cache into the folder of frames, several at a time. A picture that is there already
// is kept if all that it depends on is unchanged. Throws Interrupted once the frames in work are finished.
void render_frames(Run& run, const std::vector<int>& frames, const Options& options, const Console& console);

// The picture of one cached frame.
render::Image draw_frame(const Run& run, int frame, const Options& options);

}  // namespace drape::app

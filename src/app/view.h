#pragma once

#include "render/view.h"
#include "scene/description.h"
#include "simulation/cache.h"

namespace drape::app {

// From where, in what light and over what ground a frame is seen.
render::View frame_view(const SceneDescription& scene, const CachedFrame& frame);

render::Settings picture_settings(const RenderDescription& render);

// The camera's place in a frame; an orbit comes round to its start after the last frame.
render::Camera camera_at(const CameraDescription& camera, const TimeSettings& time, int frame);

// Whether a plane collider is drawn as the ground: it is level.
bool is_level(const RigidPose& pose);

}  // namespace drape::app

#include "app/view.h"

#include <variant>

#include "core/rigid_motion.h"

namespace drape::app {

render::Camera camera_at(const CameraDescription& camera, const TimeSettings& time, int frame) {
  Vec3 eye = camera.at;
  if (camera.orbit) {
    const double passed =
        static_cast<double>(frame - time.first_frame) / (time.last_frame - time.first_frame + 1);
    const auto [sine, cosine] = sin_cos_degrees(camera.orbit->start + 360 * camera.orbit->turns * passed);
    eye = camera.look_at +
          Vec3(camera.orbit->radius * sine, camera.orbit->height, camera.orbit->radius * cosine);
  }
  return {eye.cast<float>(), camera.look_at.cast<float>(), static_cast<float>(camera.field_of_view)};
}

bool is_level(const RigidPose& pose) { return pose.rotation(1, 1) > 0.9999; }

// The highest of the level planes: the others lie inside what is solid under it.
static render::Ground find_ground(const SceneDescription& scene, const CachedFrame& frame) {
  render::Ground ground;
  for (std::size_t i = 0; i < scene.colliders.size(); ++i) {
    const ColliderDescription& collider = scene.colliders[i];
    const bool is_plane = std::holds_alternative<PlaneShape>(collider.input.shape);
    if (!collider.visible || !is_plane || !is_level(frame.collider_poses[i])) continue;
    const auto height = static_cast<float>(frame.collider_poses[i].translation.y());
    if (!ground.visible || height > ground.height) ground = {true, height, collider.look.material.color};
  }
  return ground;
}

render::View frame_view(const SceneDescription& scene, const CachedFrame& frame) {
  render::View view;
  view.camera = camera_at(scene.camera, scene.time, frame.frame);
  view.sun = scene.sun;
  view.sky = scene.sky;
  view.ground = find_ground(scene, frame);
  view.backdrop = scene.render.backdrop;
  view.exposure = static_cast<float>(scene.render.exposure);
  return view;
}

static int passes_for(Quality quality) {
  switch (quality) {
    case Quality::draft:
      return 2;
    case Quality::preview:
      return 6;
    case Quality::final:
      return 32;
  }
  return 6;
}

render::Settings picture_settings(const RenderDescription& render) {
  return {render.width, render.height, passes_for(render.quality)};
}

}  // namespace drape::app

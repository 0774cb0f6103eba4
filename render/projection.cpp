#include "render/projection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/axes.h"

namespace drape::render {

Sphere bounding_sphere(const std::vector<Surface>& surfaces) {
  Eigen::AlignedBox3f box;
  for (const Surface& surface : surfaces) {
    for (const Vec3f& point : surface.positions) box.extend(point);
  }
  if (box.isEmpty()) return {};
  Sphere sphere{box.center(), 0};
  for (const Surface& surface : surfaces) {
    for (const Vec3f& point : surface.positions) {
      sphere.radius = std::max(sphere.radius, (point - sphere.center).norm());
    }
  }
  return sphere;
}

// The fade is 2^-(distance^2 / half_distance^2): at 3 half-distances 1/512 is left, less than a step of a
// pixel.
float ground_half_distance(const Camera& camera) { return 1.5f * (camera.eye - camera.target).norm(); }
float ground_reach(const Camera& camera) { return 3 * ground_half_distance(camera); }

static Mat4f view_matrix(const Camera& camera) {
  const Axes axes = axes_along(camera.eye - camera.target);
  Mat4f view = Mat4f::Identity();
  view.row(0).head<3>() = axes.right;
  view.row(1).head<3>() = axes.up;
  view.row(2).head<3>() = axes.forward;
  view.col(3).head<3>() = -view.topLeftCorner<3, 3>() * camera.eye;
  return view;
}

struct DepthRange {
  float near_plane;
  float far_plane;
};

static DepthRange depth_range(const View& view, const Sphere& scene) {
  const Camera& camera = view.camera;
  const float to_target = (camera.eye - camera.target).norm();
  const float to_scene = (camera.eye - scene.center).norm();
  const float to_ground = to_target + ground_reach(camera) + std::abs(camera.target.y() - view.ground.height);
  const float nearest = view.ground.visible ? 0.0f : to_scene - scene.radius;
  return {std::max(0.01f * to_target, nearest),
          1.01f * std::max({to_scene + scene.radius, 2 * to_target, view.ground.visible ? to_ground : 0.0f})};
}

// As in the OpenGL 2.1 reference, gluPerspective; the offset moves the picture's centre.
static Mat4f perspective(const View& view, const Settings& settings, const DepthRange& range,
                         const Vec2f& offset) {
  const float half_angle = view.camera.vertical_field_of_view * std::numbers::pi_v<float> / 360;
  const float scale = 1 / std::tan(half_angle);
  const float width = static_cast<float>(settings.width);
  const float height = static_cast<float>(settings.height);
  const float depth = range.near_plane - range.far_plane;
  Mat4f projection = Mat4f::Zero();
  projection(0, 0) = scale * height / width;
  projection(1, 1) = scale;
  projection(0, 2) = -2 * offset.x() / width;
  projection(1, 2) = -2 * offset.y() / height;
  projection(2, 2) = (range.far_plane + range.near_plane) / depth;
  projection(2, 3) = 2 * range.far_plane * range.near_plane / depth;
  projection(3, 2) = -1;
  return projection;
}

Mat4f camera_projection(const View& view, const Settings& settings, const Sphere& scene,
                        const Vec2f& offset) {
  return perspective(view, settings, depth_range(view, scene), offset) * view_matrix(view.camera);
}

}  // namespace drape::render

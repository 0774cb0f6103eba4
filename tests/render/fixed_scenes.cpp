#include "render/fixed_scenes.h"

#include <cmath>
#include <numbers>

#include "render/projection.h"

namespace drape::render::test {

static constexpr float pi = std::numbers::pi_v<float>;

static Vec3f sheet_normal(const std::function<Vec3f(float, float)>& point, float u, float v) {
  const float step = 1e-3f;
  const Vec3f along_u = point(u + step, v) - point(u - step, v);
  const Vec3f along_v = point(u, v + step) - point(u, v - step);
  return along_v.cross(along_u).normalized();
}

// Both triangles of each cell of a grid with `columns` points a row.
static std::vector<Triangle> grid_triangles(int columns, int rows) {
  std::vector<Triangle> triangles;
  for (int row = 0; row + 1 < rows; ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const int a = row * columns + column;
      triangles.push_back({a, a + columns, a + 1});
      triangles.push_back({a + 1, a + columns, a + columns + 1});
    }
  }
  return triangles;
}

Surface make_sheet(int cells, const std::function<Vec3f(float u, float v)>& point) {
  Surface sheet;
  for (int row = 0; row <= cells; ++row) {
    for (int column = 0; column <= cells; ++column) {
      const Vec2f uv = Vec2f(static_cast<float>(column), static_cast<float>(row)) / static_cast<float>(cells);
      sheet.positions.push_back(point(uv.x(), uv.y()));
      sheet.normals.push_back(sheet_normal(point, uv.x(), uv.y()));
      sheet.uvs.push_back(uv);
    }
  }
  sheet.triangles = grid_triangles(cells + 1, cells + 1);
  sheet.two_sided = true;
  return sheet;
}

Surface make_ball(const Vec3f& center, float radius) {
  const int cells = 48;
  Surface ball = make_sheet(cells, [&](float u, float v) {
    const float ring = radius * std::sin(pi * v);
    const float turn = 2 * pi * u;
    return Vec3f(center + Vec3f(-ring * std::cos(turn), radius * std::cos(pi * v), ring * std::sin(turn)));
  });
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    ball.normals[i] = (ball.positions[i] - center).normalized();
  }
  ball.two_sided = false;
  ball.material.color = {0.78f, 0.76f, 0.72f};
  ball.material.translucency = 0;
  return ball;
}

Surface make_wall() {
  return make_sheet(1, [](float u, float v) { return Vec3f(2 * u - 1, 1 - 2 * v, 0); });
}

View view_from_z(float distance) {
  View view;
  view.camera.eye = {0, 0, distance};
  return view;
}

void light_head_on(View& view) {
  view.sun.direction = {0, 0, -1};
  view.sun.size = 0;
  view.sky.intensity = 0;
}

static Vec3f wave(float u, float v) {
  const float x = 2 * u - 1;
  const float z = 1.6f * v - 0.8f;
  const float height = 0.09f * std::sin(5 * x + 1.5f * std::sin(2 * z)) + 0.05f * std::sin(9 * z + 3 * x);
  return {x, 0.25f + height, z};
}

static Vec3f curtain(float u, float v) {
  const float x = 1.4f * u - 0.7f;
  const float depth = 0.02f + 0.09f * v;
  return {x, 1.35f - 1.25f * v, depth * std::sin(22 * x + 2 * std::sin(3 * x) + 1.3f * v)};
}

static View view_on_ground(const Vec3f& eye, const Vec3f& target) {
  View view;
  view.camera.eye = eye;
  view.camera.target = target;
  view.ground.visible = true;
  return view;
}

static FixedScene wave_scene(const std::string& name, Pattern pattern) {
  FixedScene scene{name, {make_sheet(48, wave)}, view_on_ground({1.4f, 1.2f, 1.8f}, {0, 0.2f, 0})};
  scene.surfaces[0].material.pattern = pattern;
  return scene;
}

static FixedScene curtain_scene(const std::string& name, float eye_z) {
  FixedScene scene{name, {make_sheet(48, curtain)}, view_on_ground({0.8f, 1, eye_z}, {0, 0.68f, 0})};
  scene.surfaces[0].material.color = {0.24f, 0.34f, 0.55f};
  scene.surfaces[0].material.back = {0.80f, 0.66f, 0.30f};
  return scene;
}

std::vector<FixedScene> fixed_scenes() {
  const FixedScene ball{
      "ball", {make_ball({0, 0.5f, 0}, 0.5f)}, view_on_ground({1.4f, 1.2f, 1.8f}, {0, 0.4f, 0})};
  return {ball,
          wave_scene("plain_wave", Pattern::plain),
          wave_scene("checker_wave", Pattern::checker),
          wave_scene("stripe_wave", Pattern::stripe),
          wave_scene("tartan_wave", Pattern::tartan),
          curtain_scene("curtain_front", 2.6f),
          curtain_scene("curtain_back", -2.6f)};
}

Vec3f pixel(const Image& image, int x, int y) {
  const std::size_t first = 3 * (static_cast<std::size_t>(y) * image.width + x);
  return Vec3f(image.rgb[first], image.rgb[first + 1], image.rgb[first + 2]);
}

Vec2f seen_at(const Vec3f& point, const View& view, const Settings& settings) {
  const Vec4f clip = camera_projection(view, settings, {point, 1}, Vec2f::Zero()) * point.homogeneous();
  const Vec2f half_size =
      0.5f * Vec2f(static_cast<float>(settings.width), static_cast<float>(settings.height));
  return half_size.cwiseProduct(Vec2f(1 + clip.x() / clip.w(), 1 - clip.y() / clip.w()));
}

}  // namespace drape::render::test

#include "app/picture_key.h"

#include <sstream>
#include <type_traits>

#include "core/error.h"
#include "core/file.h"
#include "core/hash.h"

namespace drape::app {
namespace fs = std::filesystem;

template <typename Number>
static void add_number(Hasher& hasher, Number number) {
  static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
  hasher.add(&number, sizeof number);
}

static void add_color(Hasher& hasher, const render::Color& color) {
  hasher.add(color.data(), 3 * sizeof(float));
}

// Vectors of numbers without padding.
template <typename Item>
static void add_items(Hasher& hasher, const std::vector<Item>& items) {
  add_number(hasher, items.size());
  hasher.add(items.data(), items.size() * sizeof(Item));
}

// The bindings name every member: one that is added later stops this from compiling until it is hashed too.
static void add_material(Hasher& hasher, const render::Material& material) {
  const auto& [color, back, accent, pattern, scale, sheen, translucency] = material;
  for (const render::Color& each : {color, back, accent}) add_color(hasher, each);
  add_number(hasher, pattern);
  for (const float number : {scale, sheen, translucency}) add_number(hasher, number);
}

static void add_surface(Hasher& hasher, const render::Surface& surface) {
  const auto& [positions, normals, uvs, triangles, material, two_sided] = surface;
  add_items(hasher, positions);
  add_items(hasher, normals);
  add_items(hasher, uvs);
  add_items(hasher, triangles);
  add_material(hasher, material);
  add_number(hasher, two_sided);
}

static void add_camera(Hasher& hasher, const render::Camera& camera) {
  const auto& [eye, target, field_of_view] = camera;
  add_color(hasher, eye);
  add_color(hasher, target);
  add_number(hasher, field_of_view);
}

static void add_lights(Hasher& hasher, const render::Sun& sun, const render::Sky& sky) {
  const auto& [direction, color, sun_intensity, size] = sun;
  const auto& [top, horizon, ground, sky_intensity] = sky;
  for (const Vec3f& each : {direction, color, top, horizon, ground}) add_color(hasher, each);
  for (const float number : {sun_intensity, size, sky_intensity}) add_number(hasher, number);
}

static void add_view(Hasher& hasher, const render::View& view) {
  const auto& [camera, sun, sky, ground, backdrop, exposure] = view;
  add_camera(hasher, camera);
  add_lights(hasher, sun, sky);
  const auto& [visible, height, color] = ground;
  add_number(hasher, visible);
  add_number(hasher, height);
  add_color(hasher, color);
  add_color(hasher, backdrop);
  add_number(hasher, exposure);
}

std::uint64_t picture_key(const std::vector<render::Surface>& surfaces, const render::View& view,
                          const render::Settings& settings) {
  Hasher hasher;
  for (const render::Surface& surface : surfaces) add_surface(hasher, surface);
  add_view(hasher, view);
  const auto& [width, height, passes] = settings;
  for (const int number : {width, height, passes}) add_number(hasher, number);
  return hasher.digest();
}

static fs::path origin_path(const fs::path& picture) {
  return picture.parent_path() / ".made_from" / picture.stem();
}

std::optional<PictureOrigin> read_origin(const fs::path& picture) {
  std::error_code ignored;
  if (!fs::exists(origin_path(picture), ignored)) return std::nullopt;
  std::istringstream text(read_file(origin_path(picture)));
  PictureOrigin origin;
  text >> std::hex >> origin.key >> origin.build >> origin.picture_hash;
  return text ? std::optional(origin) : std::nullopt;
}

void write_origin(const fs::path& picture, const PictureOrigin& origin) {
  write_file(origin_path(picture),
             to_hex(origin.key) + " " + to_hex(origin.build) + " " + to_hex(origin.picture_hash) + "\n");
}

std::uint64_t file_hash(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return 0;
  const std::string content = read_file(path);
  return hash_bytes(content.data(), content.size());
}

}  // namespace drape::app

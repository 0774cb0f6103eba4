#include "scene/read_picture.h"

#include <fmt/format.h>

#include "scene/section_values.h"

namespace drape {
namespace {

void read_camera(const Section& scene, CameraDescription& camera) {
  const Section section = open_section(scene, "camera");
  read_numbers(section, "at", camera.at);
  read_numbers(section, "look_at", camera.look_at);
  read_number(section, "fov", camera.field_of_view);
  if (!has(section, "orbit")) return;
  const Section orbit = open_section(section, "orbit");
  CameraDescription::Orbit& circle = camera.orbit.emplace();
  read_number(orbit, "radius", circle.radius);
  read_number(orbit, "height", circle.height);
  read_number(orbit, "start", circle.start);
  read_number(orbit, "turns", circle.turns);
}

void read_sun(const Section& light, render::Sun& sun) {
  const Section section = open_section(light, "sun");
  Vec3 direction = sun.direction.cast<double>();
  read_numbers(section, "direction", direction);
  if (!direction.isZero())
    sun.direction = direction.cast<float>();
  else
    section.problems->add(find_value(section, "direction")->place,
                          fmt::format("{} must not be zero", path_of(section, "direction")));
  read_color(section, "color", sun.color);
  read_number(section, "intensity", sun.intensity);
  read_number(section, "size", sun.size);
}

void read_sky(const Section& light, render::Sky& sky) {
  const Section section = open_section(light, "sky");
  read_color(section, "top", sky.top);
  read_color(section, "horizon", sky.horizon);
  read_color(section, "ground", sky.ground);
  read_number(section, "intensity", sky.intensity);
}

void read_lights(const Section& scene, render::Sun& sun, render::Sky& sky) {
  int suns = 0, skies = 0;
  for (const Section& light : open_list(scene, "lights")) {
    const std::string_view kind = exactly_one(light, "kind", {"sun", "sky"});
    int& count = kind == "sun" ? suns : skies;
    if (!kind.empty() && ++count > 1)
      scene.problems->add(light.place, fmt::format("{} is a second {}: there can be one", light.path, kind));
    if (kind == "sun") read_sun(light, sun);
    if (kind == "sky") read_sky(light, sky);
  }
  if (has(scene, "lights") && suns == 0) sun.intensity = 0;
  if (has(scene, "lights") && skies == 0) sky.intensity = 0;
}

void read_render(const Section& scene, RenderDescription& render) {
  const Section section = open_section(scene, "render");
  std::array<int, 2> resolution{render.width, render.height};
  read_numbers(section, "resolution", resolution);
  render.width = resolution[0];
  render.height = resolution[1];
  int quality = static_cast<int>(render.quality);
  read_choice(section, "quality", quality);
  render.quality = static_cast<Quality>(quality);
  read_number(section, "exposure", render.exposure);
  read_color(section, "backdrop", render.backdrop);
  read_number(open_section(section, "video"), "crf", render.crf);
}

}  // namespace

void read_picture(const Section& scene, SceneDescription& description) {
  read_camera(scene, description.camera);
  read_lights(scene, description.sun, description.sky);
  read_render(scene, description.render);
}

}  // namespace drape

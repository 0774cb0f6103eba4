#include "scene/read_look.h"

#include "scene/section_values.h"

namespace drape {

void read_look(const Section& owner, Look& look) {
  const Section section = open_section(owner, "look");
  render::Material& material = look.material;
  read_color(section, "color", material.color);
  if (has(section, "color")) material.back = material.color;
  read_color(section, "back", material.back);
  read_color(section, "accent", material.accent);
  int pattern = static_cast<int>(material.pattern);
  read_choice(section, "pattern", pattern);
  material.pattern = static_cast<render::Pattern>(pattern);
  read_number(section, "scale", material.pattern_scale);
  read_number(section, "sheen", material.sheen);
  read_number(section, "translucency", material.translucency);
  read_number(section, "subdivide", look.subdivide);
}

}  // namespace drape

#include "render/surface_programs.h"

#include "render/pass_uniforms.h"

namespace drape::render {

static std::string pattern_defines(Pattern pattern) {
  return "#define PATTERN " + std::to_string(static_cast<int>(pattern)) + "\n#define PATTERN_CHECKER " +
         std::to_string(static_cast<int>(Pattern::checker)) + "\n#define PATTERN_STRIPE " +
         std::to_string(static_cast<int>(Pattern::stripe)) + "\n#define PATTERN_TARTAN " +
         std::to_string(static_cast<int>(Pattern::tartan)) + "\n";
}

static ShaderProgram make_program(const GlFunctions& gl, bool two_sided, Pattern pattern) {
  const char* scattering = two_sided ? "cloth.glsl" : "solid.glsl";
  return ShaderProgram(
      gl, pass_defines() + pattern_defines(pattern), {"pass.glsl", "surface.vert"},
      {"pass.glsl", "noise.glsl", "shadow.glsl", "pattern.glsl", scattering, "surface.frag"});
}

const ShaderProgram& SurfacePrograms::variant(const Surface& surface) {
  const Pattern pattern = surface.uvs.empty() ? Pattern::plain : surface.material.pattern;
  const Variant key{surface.two_sided, pattern};
  auto found = surfaces_.find(key);
  if (found == surfaces_.end())
    found = surfaces_.emplace(key, make_program(*gl_, key.first, key.second)).first;
  return found->second;
}

void SurfacePrograms::use_for(const Surface& surface) {
  const Material& material = surface.material;
  const ShaderProgram& program = variant(surface);
  program.use();
  program.set("color", linear_from_srgb(material.color));
  program.set("back", linear_from_srgb(material.back));
  program.set("accent", linear_from_srgb(material.accent));
  program.set("pattern_scale", material.pattern_scale);
  program.set("sheen", material.sheen);
  program.set("translucency", material.translucency);
}

void SurfacePrograms::use_for(const Ground& ground) {
  if (!ground_) {
    ground_.emplace(*gl_, pass_defines(), ShaderProgram::Files{"pass.glsl", "surface.vert"},
                    ShaderProgram::Files{"pass.glsl", "noise.glsl", "shadow.glsl", "ground.frag"});
  }
  ground_->use();
  ground_->set("color", linear_from_srgb(ground.color));
}

}  // namespace drape::render

#pragma once

#include <map>
#include <optional>
#include <utility>

#include "render/shader_program.h"
#include "render/view.h"

namespace drape::render {

// The shader programs of surfaces. Compiling them is what takes time at the start, so each variant is made
// when it is first asked for.
class SurfacePrograms {
 public:
  explicit SurfacePrograms(const GlFunctions& gl) : gl_(&gl) {}
  // In use and with the material's uniforms set when it comes back.
  void use_for(const Surface& surface);
  void use_for(const Ground& ground);

 private:
  using Variant = std::pair<bool, Pattern>;  // two-sided or not
  const ShaderProgram& variant(const Surface& surface);
  const GlFunctions* gl_;
  std::map<Variant, ShaderProgram> surfaces_;
  std::optional<ShaderProgram> ground_;
};

}  // namespace drape::render

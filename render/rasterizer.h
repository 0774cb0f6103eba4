#pragma once

#include <memory>
#include <vector>

#include "render/image.h"
#include "render/view.h"

namespace drape::render {

// Draws surfaces with OpenGL 3.3 core in software, off screen. One object is one context and belongs to the
// thread that made it; two objects in two threads give the same pictures as one. The picture is a function of
// the arguments alone. Each frame takes the same samples, so that what stands still does not flicker.
class Rasterizer {
 public:
  Rasterizer();  // throws RenderError with what to install where no context can be had
  ~Rasterizer();
  Rasterizer(const Rasterizer&) = delete;
  Rasterizer& operator=(const Rasterizer&) = delete;
  Image draw(const std::vector<Surface>& surfaces, const View& view, const Settings& settings);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Call once, before the first Rasterizer, with the number of threads to draw with. All contexts of a process
// share one rasteriser, which takes one picture at a time: it needs threads of its own for contexts in
// several threads to gain by them. The pictures are the same for any number.
void configure_software_rendering(int threads);

}  // namespace drape::render

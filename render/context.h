#pragma once

#include <memory>

namespace drape::render {

// An OpenGL 3.3 core context in software, without a window. It draws into framebuffer objects only. What
// makes contexts (OSMesa now, EGL in time) is seen by context_osmesa.cpp alone.
class Context {
 public:
  Context();  // throws RenderError
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void make_current();
  // The address of an OpenGL function; throws RenderError where there is none of the name.
  using Function = void (*)();
  Function function(const char* name) const;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

}  // namespace drape::render

#pragma once

#include <stdexcept>

namespace drape::render {

// There is no way to draw on this machine, or not at this size. The message says what would help.
class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace drape::render

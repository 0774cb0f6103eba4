#pragma once

#include <stdexcept>
#include <string>

namespace drape {

// Which of a file's animations, by its name or by its number from 0, and how often its shape is taken.
struct ClipRequest {
  std::string name;
  double interval;  // seconds
};

// The file has no such animation: what to say after its name.
class UnknownClip : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace drape

#pragma once

#include <string>
#include <vector>

#include "core/error.h"
#include "scene/node.h"

namespace drape {

// The mistakes found so far: reading goes on after each, so that a user sees all of them at once.
class ProblemList {
 public:
  // A mistake in what the scene says.
  void add(const Place& place, std::string message);
  // A file that cannot be read, or whose content is unfit.
  void add_file_fault(const Place& place, std::string message);
  bool empty() const { return problems_.empty(); }
  std::size_t size() const { return problems_.size(); }

  // Throws InputError with the problems in order of file, line and column, if there are any: exit status 3
  // where files are all that is at fault, 2 otherwise. `first_file` comes first, the command line last.
  void throw_if_any(const std::string& first_file) const;

 private:
  std::vector<Problem> problems_;
  bool scene_at_fault_ = false;
};

}  // namespace drape

#pragma once

#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "scene/node.h"

namespace drape {

// The mistakes found so far: reading goes on after each, so that a user sees all of them at once.
class ProblemList {
 public:
  // A mistake in what the scene says.
  void add(const Place& place, std::string message);
  // One that others at its place only follow from: those that are found later are not told.
  void add_cause(const Place& place, std::string message);
  // Makes what is wrong at `place` follow from what was found at `cause`, if that is a cause.
  void follow(const Place& place, const Place& cause);
  // A file that cannot be read, or whose content is unfit.
  void add_file_fault(const Place& place, std::string message);
  bool empty() const { return problems_.empty(); }
  std::size_t size() const { return problems_.size(); }

  // Throws InputError with the problems in order of file, line and column, if there are any: exit status 3
  // where files are all that is at fault, 2 otherwise. `first_file` comes first, the command line last.
  void throw_if_any(const std::string& first_file) const;

 private:
  std::vector<Problem> problems_;
  std::set<std::tuple<std::string, int, int>> explained_;  // files, lines and columns of causes
  bool scene_at_fault_ = false;
};

}  // namespace drape

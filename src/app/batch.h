#pragma once

#include <string>
#include <vector>

namespace drape::app {

// How one scene of a batch ended.
struct BatchEntry {
  std::string scene;
  int exit_status = 0;
  double seconds = 0;
  std::string result;  // the video, or what went wrong
};

// One line a scene: how it ended, how long it took, and what came of it.
std::string batch_table(const std::vector<BatchEntry>& entries);

// The highest exit status of all.
int worst_status(const std::vector<BatchEntry>& entries);

}  // namespace drape::app

#include "core/error.h"

namespace drape {

std::string to_string(const Problem& problem) {
  std::string text = problem.file;
  if (problem.line > 0) text += ":" + std::to_string(problem.line) + ":" + std::to_string(problem.column);
  if (!text.empty()) text += ": ";
  return text + "error: " + problem.message;
}

static std::string join(const std::vector<Problem>& problems) {
  std::string text;
  for (const Problem& problem : problems) text += (text.empty() ? "" : "\n") + to_string(problem);
  return text;
}

InputError::InputError(std::vector<Problem> problems, int exit_status)
    : std::runtime_error(join(problems)), problems_(std::move(problems)), exit_status_(exit_status) {}

FileError::FileError(const std::string& path, const std::string& reason)
    : std::runtime_error(path + ": " + reason) {}

}  // namespace drape

#include "app/batch.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/exit_status.h"
#include "app/progress.h"

namespace drape::app {

static std::string status_word(int exit_status) {
  switch (static_cast<ExitStatus>(exit_status)) {
    case ExitStatus::done:
      return "done";
    case ExitStatus::usage:
      return "scene error";
    case ExitStatus::file:
      return "file error";
    case ExitStatus::simulation:
      return "simulation failed";
    case ExitStatus::limit:
      return "limit hit";
    case ExitStatus::encoder:
      return "encoder failed";
    default:
      return fmt::format("failed ({})", exit_status);
  }
}

std::string batch_table(const std::vector<BatchEntry>& entries) {
  std::size_t width = 5;
  for (const BatchEntry& entry : entries) width = std::max(width, entry.scene.size());
  std::string table = fmt::format("{:<{}}  {:<17}  {:>8}  {}\n", "scene", width, "ended", "time", "result");
  for (const BatchEntry& entry : entries) {
    table += fmt::format("{:<{}}  {:<17}  {:>8}  {}\n", entry.scene, width, status_word(entry.exit_status),
                         format_duration(entry.seconds), entry.result);
  }
  return table;
}

int worst_status(const std::vector<BatchEntry>& entries) {
  int worst = 0;
  for (const BatchEntry& entry : entries) worst = std::max(worst, entry.exit_status);
  return worst;
}

}  // namespace drape::app

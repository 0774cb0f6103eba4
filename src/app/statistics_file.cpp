#include "app/statistics_file.h"

#include <fmt/format.h>

#include "core/file.h"
#include "core/hash.h"

namespace drape::app {

static std::string header() {
  std::string line =
      "frame,state_hash,largest_stretch,p99_stretch,smallest_stretch,contacts,limited_vertices,kinetic_"
      "energy,"
      "largest_speed,largest_lag,largest_pin_lag,largest_shape_lag";
  for (const std::string_view phase : phase_names) line += fmt::format(",{}_cpu_ms", phase);
  return line + "\n";
}

static std::string row(int frame, const FrameRecord& record) {
  const FrameStatistics& statistics = record.statistics;
  std::string line = fmt::format(
      "{},{},{},{},{},{},{},{},{},{},{},{}", frame, to_hex(record.state_hash), statistics.largest_stretch,
      statistics.p99_stretch, statistics.smallest_stretch, statistics.contacts, statistics.limited_vertices,
      statistics.kinetic_energy, statistics.largest_speed, statistics.largest_lag, statistics.largest_pin_lag,
      statistics.largest_shape_lag);
  for (const double seconds : statistics.profile.cpu_seconds) line += fmt::format(",{:.3f}", 1000 * seconds);
  return line + "\n";
}

void write_statistics(const std::filesystem::path& path, const Manifest& manifest) {
  std::string text = header();
  for (const auto& [frame, record] : manifest.frames) text += row(frame, record);
  write_file(path, text);
}

}  // namespace drape::app

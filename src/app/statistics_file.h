#pragma once

#include <filesystem>

#include "app/manifest.h"

namespace drape::app {

// The figures of each frame as CSV, one line a frame, for spreadsheets and plots.
void write_statistics(const std::filesystem::path& path, const Manifest& manifest);

}  // namespace drape::app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/options.h"

namespace drape::app {

// How two pictures of one name compare.
struct PictureComparison {
  std::string name;
  bool same = false;
  std::string figures;  // or why there are none
};

// Compares two PNG files and writes a heat map to `heat` unless that is empty. Throws FileError where one of
// them can't be read.
PictureComparison compare_pictures(const std::filesystem::path& a, const std::filesystem::path& b,
                                   const DiffOptions& options, const std::filesystem::path& heat);

// Compares two files, or two folders by the names of their PNG files. Throws FileError where a picture of one
// folder is missing in the other.
std::vector<PictureComparison> compare(const std::filesystem::path& a, const std::filesystem::path& b,
                                       const DiffOptions& options);

}  // namespace drape::app

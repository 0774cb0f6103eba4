#include "app/picture_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "render/image_difference.h"
#include "render/png_file.h"

namespace drape::app {
namespace fs = std::filesystem;

static constexpr int heat_full_scale = 64;  // in steps of 1/255: a difference that nobody overlooks

static PictureComparison different_sizes(const std::string& name, const render::Image& a,
                                         const render::Image& b) {
  return {name, false, fmt::format("sizes differ: {}x{} and {}x{}", a.width, a.height, b.width, b.height)};
}

PictureComparison compare_pictures(const fs::path& a, const fs::path& b, const DiffOptions& options,
                                   const fs::path& heat) {
  const render::Image first = render::read_png(a);
  const render::Image second = render::read_png(b);
  const std::string name = a.filename().string();
  if (first.width != second.width || first.height != second.height)
    return different_sizes(name, first, second);
  const auto difference = render::compare_images(first, second, options.tolerance);
  if (!heat.empty()) render::write_png(heat, render::heat_map(first, second, heat_full_scale));
  return {name, difference.share_over <= options.share,
          fmt::format("largest {}/255, mean {:.4f}/255, {:.3f} % of the pixels over {}/255",
                      difference.largest, difference.mean, 100 * difference.share_over, options.tolerance)};
}

static std::set<std::string> picture_names(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".png") names.insert(entry.path().filename().string());
  }
  return names;
}

static void check_names(const fs::path& a, const fs::path& b, const std::set<std::string>& names_a,
                        const std::set<std::string>& names_b) {
  if (names_a.empty()) throw FileError(a.string(), "holds no PNG files");
  std::vector<std::string> unpaired;
  std::set_symmetric_difference(names_a.begin(), names_a.end(), names_b.begin(), names_b.end(),
                                std::back_inserter(unpaired));
  if (unpaired.empty()) return;
  const fs::path& without = names_a.contains(unpaired.front()) ? b : a;
  throw FileError((without / unpaired.front()).string(),
                  fmt::format("is missing ({} in all)", unpaired.size()));
}

std::vector<PictureComparison> compare(const fs::path& a, const fs::path& b, const DiffOptions& options) {
  const fs::path heat = options.heat;
  if (!fs::is_directory(a) || !fs::is_directory(b)) return {compare_pictures(a, b, options, heat)};
  const auto names = picture_names(a);
  check_names(a, b, names, picture_names(b));
  std::vector<PictureComparison> comparisons;
  for (const std::string& name : names) {
    comparisons.push_back(compare_pictures(a / name, b / name, options, heat.empty() ? heat : heat / name));
  }
  return comparisons;
}

}  // namespace drape::app

#include "scene/suggestion.h"

#include <algorithm>

namespace drape {

// The distance of optimal string alignment, by rows of the usual table; three rows are kept for swaps.
int edit_distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), row(b.size() + 1), next(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    next[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = row[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      next[j] = std::min({replaced, row[j] + 1, next[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        next[j] = std::min(next[j], before[j - 2] + 1);
    }
    std::swap(before, row);
    std::swap(row, next);
  }
  return row[b.size()];
}

std::string join(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text.append(text.empty() ? "" : ", ").append(word);
  return text;
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& known,
                       std::string_view plural) {
  constexpr std::size_t longest_word = 64;  // the table grows with the product of the lengths
  std::string_view nearest;
  int least = std::max(1, static_cast<int>(std::min(word.size(), longest_word)) / 3) + 1;
  for (const std::string_view candidate : known) {
    if (word.size() > longest_word) break;
    const int distance = edit_distance(word, candidate);
    if (distance < least) nearest = candidate, least = distance;
  }
  if (!nearest.empty()) return "; did you mean `" + std::string(nearest) + "`?";
  return "; known " + std::string(plural) + ": " + join(known);
}

}  // namespace drape

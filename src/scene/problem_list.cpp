#include "scene/problem_list.h"

#include <algorithm>
#include <string_view>
#include <tuple>

namespace drape {

// Nobody reads on after so many, and a hostile file can hold a hundred thousand.
static constexpr std::size_t most_problems = 100;

static Problem problem_at(const Place& place, std::string message) {
  const int column = place.line > 0 ? place.column : 0;
  return {place.file ? *place.file : std::string(), place.line, column, std::move(message)};
}

static auto key_of(const Place& place) {
  return std::tuple(place.file ? *place.file : std::string(), place.line, place.column);
}

void ProblemList::add_cause(const Place& place, std::string message) {
  add(place, std::move(message));
  explained_.insert(key_of(place));
}

void ProblemList::follow(const Place& place, const Place& cause) {
  if (explained_.contains(key_of(cause))) explained_.insert(key_of(place));
}

void ProblemList::add(const Place& place, std::string message) {
  if (explained_.contains(key_of(place))) return;
  problems_.push_back(problem_at(place, std::move(message)));
  scene_at_fault_ = true;
}

void ProblemList::add_file_fault(const Place& place, std::string message) {
  problems_.push_back(problem_at(place, std::move(message)));
}

void ProblemList::throw_if_any(const std::string& first_file) const {
  if (problems_.empty()) return;
  std::vector<Problem> sorted = problems_;
  const auto rank = [&](const Problem& problem) {
    const bool elsewhere = problem.file != first_file;
    return std::tuple(problem.line == 0 && elsewhere, elsewhere, std::string_view(problem.file), problem.line,
                      problem.column);
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const Problem& a, const Problem& b) { return rank(a) < rank(b); });
  if (sorted.size() > most_problems) {
    const std::size_t more = sorted.size() - most_problems;
    sorted.resize(most_problems);
    sorted.push_back({first_file, 0, 0, "and " + std::to_string(more) + " more problems"});
  }
  throw InputError(std::move(sorted), scene_at_fault_ ? 2 : 3);
}

}  // namespace drape

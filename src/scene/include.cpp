#include "scene/include.h"

#include <fmt/format.h>

#include "core/file.h"
#include "scene/scene_file.h"
#include "scene/yaml_document.h"

namespace drape {
namespace fs = std::filesystem;
namespace {

constexpr int deepest_include = 8;
constexpr int most_files = 64;

// Puts what `from` has and `into` has not into `into`.
void merge(Node& into, Node&& from) {
  for (MapEntry& entry : from.entries) {
    MapEntry* own = find_entry(into, entry.key);
    if (own == nullptr)
      into.entries.push_back(std::move(entry));
    else if (own->value.kind == Node::Kind::map && entry.value.kind == Node::Kind::map)
      merge(own->value, std::move(entry.value));
  }
}

// Takes the key out of the map, so that what reads the scene after this sees one tree.
std::vector<Node> take_includes(Node& root, ProblemList& problems) {
  MapEntry* entry = find_entry(root, "include");
  if (entry == nullptr) return {};
  Node value = std::move(entry->value);
  root.entries.erase(root.entries.begin() + (entry - root.entries.data()));
  for (const Node& item : value.items) {
    if (item.kind == Node::Kind::scalar) continue;
    problems.add(item.place, fmt::format("include must be a list of files, not of {}", describe(item)));
    return {};
  }
  if (value.kind != Node::Kind::sequence)
    problems.add(value.place, fmt::format("include must be a list of files, not {}", describe(value)));
  return std::move(value.items);
}

class TreeReader {
 public:
  TreeReader(fs::path scene_folder, ProblemList& problems)
      : scene_folder_(std::move(scene_folder)), problems_(problems) {}

  // `asked_at` is the place of the include, for the scene itself that of its file.
  std::optional<Node> read(const fs::path& path, const Place& asked_at, int depth) {
    if (!check_limits(asked_at, depth)) return std::nullopt;
    const auto file = std::make_shared<const std::string>(path.string());
    const auto text = read_text(path, asked_at);
    if (!text) return std::nullopt;
    auto root = parse_yaml(*text, file, budget_, problems_);
    if (!root) return std::nullopt;
    if (root->kind == Node::Kind::map) merge_includes(*root, path, depth);
    return root;
  }

 private:
  bool check_limits(const Place& asked_at, int depth) {
    if (depth <= deepest_include && ++files_ <= most_files) return true;
    problems_.add(asked_at, fmt::format("include: more than {} deep, or more than {} files", deepest_include,
                                        most_files));
    return false;
  }

  std::optional<std::string> read_text(const fs::path& path, const Place& asked_at) {
    std::error_code ignored;
    const std::uintmax_t size = fs::file_size(path, ignored);
    if (!ignored && size > largest_document) {
      problems_.add({std::make_shared<const std::string>(path.string())},
                    fmt::format("{} bytes; a scene has at most {}", size, largest_document));
      return std::nullopt;
    }
    try {
      return read_file(path);
    } catch (const FileError& error) {
      problems_.add_file_fault(asked_at, error.what());
      return std::nullopt;
    }
  }

  // From the last to the first: what comes first into the tree wins.
  void merge_includes(Node& root, const fs::path& path, int depth) {
    const std::vector<Node> includes = take_includes(root, problems_);
    for (auto item = includes.rbegin(); item != includes.rend(); ++item) {
      const auto included =
          find_scene_file(item->text, "include", path.parent_path(), scene_folder_, item->place, problems_);
      auto tree = included ? read(*included, item->place, depth + 1) : std::nullopt;
      if (!tree) continue;
      if (tree->kind != Node::Kind::map)
        problems_.add(item->place,
                      fmt::format("include: {} must hold a map, not {}", quote(item->text), describe(*tree)));
      else
        merge(root, std::move(*tree));
    }
  }

  fs::path scene_folder_;
  ProblemList& problems_;
  DocumentBudget budget_;
  int files_ = 0;
};

}  // namespace

std::optional<Node> read_tree(const fs::path& scene_path, ProblemList& problems) {
  return TreeReader(scene_path.parent_path(), problems).read(scene_path, Place{}, 0);
}

}  // namespace drape

#include "scene/load.h"

#include <fmt/format.h>

#include <charconv>

#include "scene/include.h"
#include "scene/override.h"
#include "scene/problem_list.h"
#include "scene/read_cloths.h"
#include "scene/read_colliders.h"
#include "scene/read_measure.h"
#include "scene/read_picture.h"
#include "scene/read_seams.h"
#include "scene/section.h"
#include "scene/section_values.h"
#include "scene/variables.h"

namespace drape {
namespace {

// "first-last", or a count from 1; nothing where the text is neither.
std::optional<std::array<int, 2>> parse_frames(std::string_view text) {
  const std::size_t dash = text.find('-');
  const bool is_range = dash != std::string_view::npos;
  const auto first = is_range ? parse_quantity(text.substr(0, dash), Quantity::plain) : ParsedNumber{1, {}};
  const auto last = parse_quantity(text.substr(is_range ? dash + 1 : 0), Quantity::plain);
  const auto fits = [](const ParsedNumber& number) {
    return number.mistake.empty() && number.value >= 1 && number.value <= frame_rule.greatest &&
           number.value == static_cast<int>(number.value);
  };
  if (!fits(first) || !fits(last) || first.value > last.value) return std::nullopt;
  return std::array{static_cast<int>(first.value), static_cast<int>(last.value)};
}

void read_frames(const Section& time, TimeSettings& settings) {
  const Node* node = find_value(time, "frames");
  if (node == nullptr) return;
  const auto frames = node->kind == Node::Kind::scalar ? parse_frames(node->text) : std::nullopt;
  if (!frames)
    return time.problems->add(node->place,
                              fmt::format("time.frames must be `first-last` or a count, of frames "
                                          "from 1 to {}, not {}",
                                          frame_rule.greatest, describe(*node)));
  settings.first_frame = (*frames)[0];
  settings.last_frame = (*frames)[1];
}

void read_time(const Section& scene, TimeSettings& settings) {
  const Section time = open_section(scene, "time");
  read_number(time, "fps", settings.fps);
  read_frames(time, settings);
  read_number(time, "step", settings.step);
}

void read_world(const Section& scene, SceneDescription& description) {
  const Section simulation = open_section(scene, "simulation");
  int model = static_cast<int>(description.model);
  read_choice(simulation, "model", model);
  description.model = static_cast<DeformationModel>(model);
  read_number(simulation, "alpha", description.alpha);
  read_numbers(simulation, "gravity", description.gravity);
  const Section wind = open_section(simulation, "wind");
  read_numbers(wind, "velocity", description.wind.velocity);
  read_number(wind, "gust", description.wind.gust);
  read_number(wind, "gust_size", description.wind.gust_size);
  read_number(wind, "seed", description.wind.seed);
  read_number(wind, "drag", description.wind.drag);
  read_number(wind, "tangential_drag", description.wind.tangential_drag);
  read_number(wind, "lift", description.wind.lift);
  read_boolean(simulation, "self_collision", description.self_collision);
}

// It is shown on one line.
void read_name(const Section& scene, std::string& name) {
  constexpr std::size_t longest = 100;
  read_text(scene, "name", name);
  const bool is_safe = name.size() <= longest && name.find_first_of("/\n\r\t") == std::string::npos;
  if (has(scene, "name") && !is_safe)
    scene.problems->add(find_value(scene, "name")->place,
                        fmt::format("name must be one line without /, of at most {} bytes", longest));
}

SceneDescription read_scene(const Node& root, const std::filesystem::path& path, ProblemList& problems) {
  SceneDescription description;
  description.file = path.string();
  description.name = path.stem().string();
  const Section scene = open_scene(root, problems);
  int version = 1;
  read_number(scene, "version", version);
  read_name(scene, description.name);
  read_time(scene, description.time);
  read_world(scene, description);
  description.cloths = read_cloths(scene, path.parent_path(), description.time.fps);
  description.colliders = read_colliders(scene, path.parent_path(), description.time.fps);
  description.seams = read_seams(scene, description.cloths, description.time.fps);
  read_measure(scene, description);
  read_picture(scene, description);
  return description;
}

}  // namespace

SceneDescription load_scene(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  ProblemList problems;
  std::optional<Node> root = read_tree(path, problems);
  problems.throw_if_any(path.string());
  if (root->kind == Node::Kind::null)
    problems.add({std::make_shared<const std::string>(path.string())},
                 "is empty; a scene starts with `version: 1`");
  problems.throw_if_any(path.string());
  for (const std::string& text : overrides) apply_override(text, *root, problems);
  substitute_variables(*root, problems);
  SceneDescription description = read_scene(*root, path, problems);
  problems.throw_if_any(path.string());
  return description;
}

}  // namespace drape

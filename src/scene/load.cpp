#include "scene/load.h"

#include <fmt/format.h>

#include "scene/include.h"
#include "scene/override.h"
#include "scene/problem_list.h"
#include "scene/read_cloths.h"
#include "scene/read_colliders.h"
#include "scene/read_facts.h"
#include "scene/read_frame_range.h"
#include "scene/read_measure.h"
#include "scene/read_picture.h"
#include "scene/read_seams.h"
#include "scene/section.h"
#include "scene/section_values.h"
#include "scene/variables.h"
#include "simulation/colliders.h"

namespace drape {
namespace {

void read_time(const Section& scene, TimeSettings& settings) {
  const Section time = open_section(scene, "time");
  read_number(time, "fps", settings.fps);
  read_frame_range(time, "frames", settings.first_frame, settings.last_frame);
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
  read_boolean(simulation, "sleep", description.sleep);
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

// A pin keeps its vertices in the frame of what it follows, and what deforms has none.
void check_followers(const SceneDescription& scene, ProblemList& problems) {
  for (const ClothDescription& cloth : scene.cloths)
    for (const PinInput& pin : cloth.input.pins) {
      if (!pin.collider || *pin.collider >= static_cast<int>(scene.colliders.size())) continue;
      const ColliderInput& collider = scene.colliders[*pin.collider].input;
      if (deforms(collider))
        problems.add(cloth.place,
                     fmt::format("cloths.{}: a pin can't follow {}, which changes its shape: give "
                                 "the pin an animation of its own",
                                 cloth.input.name, collider.name));
    }
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
  check_followers(description, problems);
  description.seams = read_seams(scene, description.cloths, description.time.fps);
  read_measure(scene, description);
  read_facts(scene, description);
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

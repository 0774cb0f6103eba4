#include "scene/read_facts.h"

#include <fmt/format.h>

#include "scene/read_frame_range.h"
#include "scene/read_part_name.h"

namespace drape {
namespace {

bool is_of_a_place(FactQuantity quantity) { return quantity >= FactQuantity::lowest; }

std::optional<double> read_bound(const Section& test, std::string_view name) {
  if (!has(test, name)) return std::nullopt;
  double value = 0;
  read_number(test, name, value);
  return value;
}

void check_bounds(const Section& test, const SceneFact& fact) {
  if (!fact.least && !fact.most)
    test.problems->add(test.place, fmt::format("{} needs a bound: least, most or both", test.path));
  if (fact.least && fact.most && *fact.least > *fact.most)
    test.problems->add(find_value(test, "least")->place,
                       fmt::format("{} is {}, more than the most, {}: nothing can be between them",
                                   path_of(test, "least"), *fact.least, *fact.most));
}

void check_cloth(const Section& test, const SceneFact& fact) {
  if (!fact.cloth || is_of_a_place(fact.quantity)) return;
  test.problems->add(find_value(test, "cloth")->place,
                     fmt::format("{}: {} is of all cloths together; of one cloth there are lowest, highest, "
                                 "middle_x, middle_y, middle_z and turn",
                                 path_of(test, "cloth"), fact_name(fact.quantity)));
}

// What says which frames there are: time.frames, or what stands in place of a map of time. Null: nothing.
const Node* frames_of_scene(const Section& scene) {
  const Node* time = find_value(scene, "time");
  if (time == nullptr || time->kind != Node::Kind::map) return time;
  const MapEntry* frames = find_entry(*time, "frames");
  return frames != nullptr ? &frames->value : nullptr;
}

// A fact about frames that no run makes would never be tested. The command line may say that there are fewer,
// to be quick. Where the scene's frames are a mistake, nobody knows which it makes.
void check_frames(const Section& test, const SceneFact& fact, const Section& scene,
                  const TimeSettings& time) {
  const Node *frames = find_value(test, "frames"), *all = frames_of_scene(scene);
  const bool are_made = fact.first_frame >= time.first_frame && fact.last_frame <= time.last_frame;
  if (frames == nullptr || are_made || (all != nullptr && all->is_overridden)) return;
  if (all != nullptr) test.problems->follow(frames->place, all->place);
  test.problems->add(
      frames->place,
      fmt::format("{} is {}-{}, but the scene has frames {}-{} (time.frames): name frames that it has, or "
                  "let it have more",
                  path_of(test, "frames"), fact.first_frame, fact.last_frame, time.first_frame,
                  time.last_frame));
}

SceneFact read_fact(const Section& test, const Section& scene, const SceneDescription& description) {
  SceneFact fact;
  int quantity = 0;
  read_choice(test, "what", quantity);
  fact.quantity = static_cast<FactQuantity>(quantity);
  fact.first_frame = description.time.first_frame;
  fact.last_frame = description.time.last_frame;
  read_frame_range(test, "frames", fact.first_frame, fact.last_frame);
  fact.cloth = read_part_name(test, "cloth", description.cloths, scene, "cloths");
  fact.least = read_bound(test, "least");
  fact.most = read_bound(test, "most");
  check_bounds(test, fact);
  check_cloth(test, fact);
  check_frames(test, fact, scene, description.time);
  return fact;
}

}  // namespace

void read_facts(const Section& scene, SceneDescription& description) {
  for (const Section& test : open_list(scene, "test"))
    description.facts.push_back(read_fact(test, scene, description));
}

std::string_view fact_name(FactQuantity quantity) {
  return find_key("test.*", "what")->choices[static_cast<std::size_t>(quantity)];
}

}  // namespace drape

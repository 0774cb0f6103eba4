#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/node.h"
#include "scene/problem_list.h"
#include "scene/scene_keys.h"

namespace drape {

// A map of a scene that is being read. Opening it has checked that it is a map, and that all of its keys are
// known and those that are required there.
struct Section {
  const Node* node = nullptr;  // null: the section is not there, so all its keys have their defaults
  std::string keys;            // where the table lists its keys: "cloths.*.material"
  std::string path;            // what the user calls it: "cloths.napkin.material"; empty for the scene
  Place place;                 // of its key
  ProblemList* problems = nullptr;
};

Section open_scene(const Node& root, ProblemList& problems);

// The section `name` of a section; one without a node where it is not there, or is no map (which is a
// problem).
Section open_section(const Section& parent, std::string_view name);

// The sections of a named map or of a list, in the order of the text, without those that are no maps.
struct NamedSection {
  std::string name;
  Section section;
};
std::vector<NamedSection> open_named(const Section& parent, std::string_view name, int most);
std::vector<Section> open_list(const Section& parent, std::string_view name);

bool has(const Section& section, std::string_view name);
const Node* find_value(const Section& section, std::string_view name);

// "cloths.napkin.material.friction"
std::string path_of(const Section& section, std::string_view name);

// The one of `names` that the section has. None or several of them are a problem and give an empty name.
std::string_view exactly_one(const Section& section, std::string_view what,
                             std::initializer_list<std::string_view> names);

}  // namespace drape

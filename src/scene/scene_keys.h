#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/quantity.h"

namespace drape {

// The table of all keys that a scene may have: what reads and checks a scene goes by it, and whatever
// describes the format (the reference scene, an editor's schema) can be held against it.

enum class KeyKind {
  section,  // a map of keys that the table lists
  named,    // a map from names that the user chooses to sections
  list,     // a list of sections
  number,
  boolean,
  text,
  file,             // a path relative to the scene's file, under its folder
  files,            // a list of those
  choice,           // one of a few words
  color,            // "#rrggbb", "#rgb" or [r, g, b] from 0 to 1
  numbers,          // a list of `count` numbers
  pair,             // a list of two numbers, or one that is both
  indices,          // a list of whole numbers
  axis_signs,       // a list of -x, +x, -y, +y, -z, +z
  frame_range,      // "first-last", or a count
  keyframes,        // a list of [frame, number]
  point_keyframes,  // a list of [frame, [x, y, z]]
  variables,        // a map from names to anything
};

// What a number may be; both ends of the range are in it.
struct NumberRule {
  Quantity quantity = Quantity::plain;
  double least = 0;
  double greatest = 0;
  bool whole = false;
};

// The path of a key has `*` where a name or the items of a list stand: "cloths.*.pins.*.until".
struct Key {
  std::string_view path;
  KeyKind kind = KeyKind::section;
  std::string_view help;   // one line: meaning, and the unit where it is not the quantity's
  NumberRule number = {};  // of one number, of each of several, or of a keyframe's value
  int count = 0;           // of numbers
  std::span<const std::string_view> choices = {};
  // Where a section's keys are listed, where not under its own path: sections that occur twice share a list.
  // Of a named map: those of its sections.
  std::string_view keys_under = {};
  bool required = false;
};

inline constexpr NumberRule frame_rule = {Quantity::plain, 0, 100'000, true};
inline constexpr int most_materials = 100;
inline constexpr int most_cloths = 100;
inline constexpr int most_colliders = 1000;
inline constexpr int most_made_points = 4'000'000;  // of the grids and discs of all cloths together

std::span<const Key> scene_keys();

// The key `name` of the section whose keys are listed under `section` ("" for the top), or null.
const Key* find_key(std::string_view section, std::string_view name);

// Where the keys of a section, or of each section of a named map or a list, are listed.
std::string keys_listed_under(const Key& key);

// The names of the keys that are listed under `section`, in the order of the table.
std::vector<std::string_view> key_names(std::string_view section);

}  // namespace drape

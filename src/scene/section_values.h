#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"
#include "render/view.h"
#include "scene/section.h"

namespace drape {

// Each reads the value of a key, by its line of the table, into `value`, and leaves `value` as it is where
// the key is not there or its value is a mistake, which goes to the section's problems.
void read_number(const Section& section, std::string_view name, double& value);
void read_number(const Section& section, std::string_view name, float& value);
void read_number(const Section& section, std::string_view name, int& value);
void read_boolean(const Section& section, std::string_view name, bool& value);
void read_text(const Section& section, std::string_view name, std::string& value);
void read_numbers(const Section& section, std::string_view name, Vec3& value);
void read_numbers(const Section& section, std::string_view name, std::array<double, 2>& value);
void read_numbers(const Section& section, std::string_view name, std::array<int, 2>& value);
// One number for both, or two.
void read_pair(const Section& section, std::string_view name, std::array<double, 2>& value);
void read_color(const Section& section, std::string_view name, render::Color& value);

// The place of the key's word in the table's list of choices.
void read_choice(const Section& section, std::string_view name, int& value);

// For values inside of others: the number in `node`, which the user knows as `path`.
std::optional<double> number_in(const Node& node, const NumberRule& rule, const std::string& path,
                                ProblemList& problems);
// Several numbers in a list of just so many; empty where there is a mistake.
std::vector<double> numbers_in(const Node& node, const NumberRule& rule, int count, const std::string& path,
                               ProblemList& problems);

}  // namespace drape

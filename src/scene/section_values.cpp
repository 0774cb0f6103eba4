#include "scene/section_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/color.h"
#include "scene/suggestion.h"

namespace drape {

static std::string with_unit(double value, const NumberRule& rule) {
  const std::string_view unit = unit_of(rule.quantity);
  return fmt::format("{}{}{}", value, unit.empty() ? "" : " ", unit);
}

static std::string range_of(const NumberRule& rule) {
  if (rule.least == rule.greatest) return with_unit(rule.least, rule);
  return fmt::format("from {} to {}", with_unit(rule.least, rule), with_unit(rule.greatest, rule));
}

static ParsedNumber parse_by_rule(const Node& node, const NumberRule& rule) {
  if (node.kind != Node::Kind::scalar) return {0, fmt::format("must be a number, not {}", describe(node))};
  ParsedNumber number = parse_quantity(node.text, rule.quantity);
  if (!number.mistake.empty()) return number;
  if (rule.whole && number.value != std::floor(number.value))
    number.mistake = fmt::format("must be a whole number, not {}", describe(node));
  else if (number.value < rule.least || number.value > rule.greatest)
    number.mistake = fmt::format("must be {}, but is {}", range_of(rule), describe(node));
  return number;
}

std::optional<double> number_in(const Node& node, const NumberRule& rule, const std::string& path,
                                ProblemList& problems) {
  const ParsedNumber number = parse_by_rule(node, rule);
  if (number.mistake.empty()) return number.value;
  problems.add(node.place, path + " " + number.mistake);
  return std::nullopt;
}

std::vector<double> numbers_in(const Node& node, const NumberRule& rule, int count, const std::string& path,
                               ProblemList& problems) {
  if (node.kind != Node::Kind::sequence || node.items.size() != static_cast<std::size_t>(count)) {
    const std::string found =
        node.kind == Node::Kind::sequence ? fmt::format("one of {}", node.items.size()) : describe(node);
    problems.add(node.place, fmt::format("{} must be a list of {} numbers, not {}", path, count, found));
    return {};
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < node.items.size(); ++i)
    if (const auto value = number_in(node.items[i], rule, fmt::format("{}[{}]", path, i), problems))
      values.push_back(*value);
  if (values.size() != node.items.size()) values.clear();
  return values;
}

template <typename Number>
static void read_one(const Section& section, std::string_view name, Number& value) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  const NumberRule& rule = find_key(section.keys, name)->number;
  if (const auto number = number_in(*node, rule, path_of(section, name), *section.problems))
    value = static_cast<Number>(*number);
}

template <typename Numbers>
static void read_several(const Section& section, std::string_view name, Numbers& values) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  const Key& key = *find_key(section.keys, name);
  const auto numbers = numbers_in(*node, key.number, key.count, path_of(section, name), *section.problems);
  using Number = std::decay_t<decltype(values[0])>;
  std::transform(numbers.begin(), numbers.end(), std::begin(values),
                 [](double number) { return static_cast<Number>(number); });
}

void read_number(const Section& section, std::string_view name, double& value) {
  read_one(section, name, value);
}
void read_number(const Section& section, std::string_view name, float& value) {
  read_one(section, name, value);
}
void read_number(const Section& section, std::string_view name, int& value) {
  read_one(section, name, value);
}

void read_numbers(const Section& section, std::string_view name, Vec3& value) {
  read_several(section, name, value);
}
void read_numbers(const Section& section, std::string_view name, std::array<double, 2>& value) {
  read_several(section, name, value);
}
void read_numbers(const Section& section, std::string_view name, std::array<int, 2>& value) {
  read_several(section, name, value);
}

void read_pair(const Section& section, std::string_view name, std::array<double, 2>& value) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  if (node->kind == Node::Kind::sequence) return read_several(section, name, value);
  read_one(section, name, value[0]);
  value[1] = value[0];
}

void read_boolean(const Section& section, std::string_view name, bool& value) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  if (node->kind == Node::Kind::scalar && (node->text == "true" || node->text == "false"))
    value = node->text == "true";
  else
    section.problems->add(node->place, fmt::format("{} must be true or false, not {}", path_of(section, name),
                                                   describe(*node)));
}

void read_text(const Section& section, std::string_view name, std::string& value) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  if (node->kind == Node::Kind::scalar && !node->text.empty())
    value = node->text;
  else
    section.problems->add(node->place,
                          fmt::format("{} must be text, not {}", path_of(section, name), describe(*node)));
}

void read_choice(const Section& section, std::string_view name, int& value) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  const auto choices = find_key(section.keys, name)->choices;
  const auto found = std::find(choices.begin(), choices.end(), node->text);
  if (node->kind == Node::Kind::scalar && found != choices.end()) {
    value = static_cast<int>(found - choices.begin());
    return;
  }
  const std::vector<std::string_view> words(choices.begin(), choices.end());
  std::string message =
      fmt::format("{} must be one of {}, not {}", path_of(section, name), join(words), describe(*node));
  const std::string hint = suggestion(node->text, words, "");
  if (hint.ends_with('?')) message += hint;
  section.problems->add(node->place, std::move(message));
}

void read_color(const Section& section, std::string_view name, render::Color& value) {
  const Node* node = find_value(section, name);
  if (node == nullptr) return;
  const std::string path = path_of(section, name);
  if (node->kind == Node::Kind::sequence) {
    const auto parts = numbers_in(*node, {Quantity::plain, 0, 1}, 3, path, *section.problems);
    for (std::size_t i = 0; i < parts.size(); ++i) value[static_cast<int>(i)] = static_cast<float>(parts[i]);
  } else if (const auto color = node->kind == Node::Kind::scalar ? parse_color(node->text) : std::nullopt) {
    value = *color;
  } else {
    const std::string hint = node->kind == Node::Kind::null ? " (# without quotes starts a comment)" : "";
    section.problems->add(node->place,
                          fmt::format("{} must be a colour, \"#rrggbb\" or [r, g, b] from 0 to 1, "
                                      "not {}{}",
                                      path, describe(*node), hint));
  }
}

}  // namespace drape

#include "scene/quantity.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <numbers>

#include "scene/suggestion.h"

namespace drape {

// value in SI = number * multiply / divide: a quotient of whole numbers is rounded once, so that "9 mm" and
// "0.009" are the same.
struct Unit {
  Quantity quantity;
  std::string_view name;
  double multiply = 1;
  double divide = 1;
};

// The first unit of a quantity is the one that plain numbers are in.
static constexpr std::array units = {
    Unit{Quantity::length, "m"},
    Unit{Quantity::length, "cm", 1, 100},
    Unit{Quantity::length, "mm", 1, 1000},
    Unit{Quantity::time, "s"},
    Unit{Quantity::time, "ms", 1, 1000},
    Unit{Quantity::time, "us", 1, 1'000'000},
    Unit{Quantity::time, "min", 60},
    Unit{Quantity::angle, "deg"},
    Unit{Quantity::angle, "rad", 180, std::numbers::pi},
    Unit{Quantity::area_density, "kg/m2"},
    Unit{Quantity::area_density, "g/m2", 1, 1000},
    Unit{Quantity::speed, "m/s"},
    Unit{Quantity::speed, "cm/s", 1, 100},
    Unit{Quantity::speed, "km/h", 1000, 3600},
    Unit{Quantity::acceleration, "m/s2"},
    Unit{Quantity::tension, "N/m"},
    Unit{Quantity::tension, "kN/m", 1000},
    Unit{Quantity::flexural_rigidity, "N m"},
    Unit{Quantity::flexural_rigidity, "mN m", 1, 1000},
    Unit{Quantity::flexural_rigidity, "uN m", 1, 1'000'000},
    Unit{Quantity::rate, "1/s"},
    Unit{Quantity::rate, "Hz"},
    Unit{Quantity::pressure, "Pa"},
    Unit{Quantity::pressure, "hPa", 100},
    Unit{Quantity::pressure, "kPa", 1000},
};

static std::string_view name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::plain:
      return "a number";
    case Quantity::length:
      return "a length";
    case Quantity::time:
      return "a time";
    case Quantity::angle:
      return "an angle";
    case Quantity::area_density:
      return "a mass per area";
    case Quantity::speed:
      return "a speed";
    case Quantity::acceleration:
      return "an acceleration";
    case Quantity::tension:
      return "a stiffness per width";
    case Quantity::flexural_rigidity:
      return "a flexural rigidity";
    case Quantity::rate:
      return "a rate";
    case Quantity::pressure:
      return "a pressure";
  }
  return "a number";
}

std::vector<std::string_view> units_of(Quantity quantity) {
  std::vector<std::string_view> names;
  for (const Unit& unit : units)
    if (unit.quantity == quantity) names.push_back(unit.name);
  return names;
}

std::string_view unit_of(Quantity quantity) {
  for (const Unit& unit : units)
    if (unit.quantity == quantity) return unit.name;
  return {};
}

static std::size_t count_digits(std::string_view text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  return end == std::string_view::npos ? text.size() : end;
}

// The length of the decimal number that a text starts with; 0 where it starts with none.
static std::size_t number_length(std::string_view text) {
  std::size_t length = text.starts_with('+') || text.starts_with('-') ? 1 : 0;
  const std::size_t whole = count_digits(text.substr(length));
  length += whole;
  std::size_t fraction = 0;
  if (length < text.size() && text[length] == '.') {
    fraction = count_digits(text.substr(length + 1));
    length += 1 + fraction;
  }
  if (whole + fraction == 0) return 0;
  if (length < text.size() && (text[length] == 'e' || text[length] == 'E')) {
    const std::size_t sign = length + 1 < text.size() && (text[length + 1] == '+' || text[length + 1] == '-');
    const std::size_t exponent = count_digits(text.substr(length + 1 + sign));
    if (exponent > 0) length += 1 + sign + exponent;
  }
  return length;
}

static bool has_leading_zero(std::string_view number) {
  if (number.starts_with('+') || number.starts_with('-')) number.remove_prefix(1);
  return number.starts_with('0') && count_digits(number) > 1;
}

static bool names_no_finite_number(std::string_view text) {
  for (const std::string_view word : {".inf", "-.inf", "+.inf", ".nan", "inf", "-inf", "nan", "infinity"})
    if (text.size() == word.size() && std::equal(text.begin(), text.end(), word.begin(), [](char a, char b) {
          return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b;
        }))
      return true;
  return false;
}

static std::string not_a_number(std::string_view text, Quantity quantity) {
  if (names_no_finite_number(text)) return fmt::format("must be finite, but is `{}`", text);
  const std::string_view unit = unit_of(quantity);
  if (unit.empty()) return fmt::format("must be a number, not `{}`", text);
  return fmt::format("must be {} (a number, in {}), not `{}`", name_of(quantity), join(units_of(quantity)),
                     text);
}

static ParsedNumber parse_decimal(std::string_view number) {
  if (has_leading_zero(number))
    return {0, fmt::format("must not start with a zero, which some take for an octal number: `{}`", number)};
  if (number.starts_with('+')) number.remove_prefix(1);  // from_chars knows no plus
  ParsedNumber result;
  const auto [end, status] = std::from_chars(number.data(), number.data() + number.size(), result.value);
  if (status != std::errc() || end != number.data() + number.size())
    result.mistake = fmt::format("is out of the range of numbers: `{}`", number);
  return result;
}

static const Unit* find_unit(std::string_view name, Quantity quantity) {
  for (const Unit& unit : units)
    if (unit.quantity == quantity && unit.name == name) return &unit;
  return nullptr;
}

static std::string not_a_unit(std::string_view name, Quantity quantity) {
  if (quantity == Quantity::plain) return fmt::format("takes no unit, but has `{}`", name);
  return fmt::format("must be {}, in {}, not in `{}`", name_of(quantity), join(units_of(quantity)), name);
}

ParsedNumber parse_quantity(std::string_view text, Quantity quantity) {
  const std::size_t length = number_length(text);
  if (length == 0) return {0, not_a_number(text, quantity)};
  const ParsedNumber number = parse_decimal(text.substr(0, length));
  std::string_view name = text.substr(length);
  name.remove_prefix(std::min(name.find_first_not_of(' '), name.size()));
  if (!number.mistake.empty() || name.empty()) return number;
  if (const Unit* unit = find_unit(name, quantity)) return {number.value * unit->multiply / unit->divide, {}};
  const bool is_more_of_a_number = name.find_first_of(".0123456789") == 0;
  return {0, is_more_of_a_number ? not_a_number(text, quantity) : not_a_unit(name, quantity)};
}

}  // namespace drape

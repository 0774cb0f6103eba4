#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape {

// What a number measures. Plain numbers are SI, but for angles, which are in degrees.
enum class Quantity {
  plain,              // no unit
  length,             // m
  time,               // s
  angle,              // degrees
  area_density,       // kg/m2
  speed,              // m/s
  acceleration,       // m/s2
  tension,            // N/m
  flexural_rigidity,  // N m
  rate,               // 1/s
  pressure,           // Pa
};

// "m" for a length; empty for what is plain.
std::string_view unit_of(Quantity quantity);

// The units that a quantity may be written in.
std::vector<std::string_view> units_of(Quantity quantity);

// A number read from text, or what is wrong with it: words that follow the name of the key ("must be ...").
struct ParsedNumber {
  double value = 0;
  std::string mistake;  // empty: it is a number
};

// A decimal number, and a unit that fits the quantity or none: "2 ms", "-5e-3", "30deg". Nothing that readers
// of YAML understand in different ways: no leading zeros, hexadecimal digits, underscores, infinities.
ParsedNumber parse_quantity(std::string_view text, Quantity quantity);

}  // namespace drape

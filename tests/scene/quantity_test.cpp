#include "scene/quantity.h"

#include <gtest/gtest.h>

namespace drape {

static double value(std::string_view text, Quantity quantity = Quantity::plain) {
  const ParsedNumber number = parse_quantity(text, quantity);
  EXPECT_EQ(number.mistake, "") << text;
  return number.value;
}

static std::string mistake(std::string_view text, Quantity quantity = Quantity::plain) {
  return parse_quantity(text, quantity).mistake;
}

TEST(Quantity, ReadsDecimalNumbers) {
  EXPECT_EQ(value("0"), 0);
  EXPECT_EQ(value("-12.5"), -12.5);
  EXPECT_EQ(value("+3"), 3);
  EXPECT_EQ(value(".5"), 0.5);
  EXPECT_EQ(value("2."), 2);
  EXPECT_EQ(value("1e-5"), 1e-5);
  EXPECT_EQ(value("1E+2"), 100);
  EXPECT_EQ(value("0.25"), 0.25);
}

TEST(Quantity, UnitsGiveTheSameBitsAsPlainNumbers) {
  EXPECT_EQ(value("9 mm", Quantity::length), 0.009);
  EXPECT_EQ(value("3cm", Quantity::length), 0.03);
  EXPECT_EQ(value("2 ms", Quantity::time), 0.002);
  EXPECT_EQ(value("200 g/m2", Quantity::area_density), 0.2);
  EXPECT_EQ(value("36 km/h", Quantity::speed), 10);
  EXPECT_EQ(value("30 deg", Quantity::angle), 30);
  EXPECT_EQ(value("10 uN m", Quantity::flexural_rigidity), 1e-5);
  EXPECT_EQ(value("2 1/s", Quantity::rate), 2);
}

TEST(Quantity, TurnsRadiansIntoDegrees) {
  EXPECT_DOUBLE_EQ(value("3.14159265358979312 rad", Quantity::angle), 180);
}

TEST(Quantity, RefusesWhatReadersOfYamlDisagreeOn) {
  EXPECT_EQ(mistake("010"), "must not start with a zero, which some take for an octal number: `010`");
  EXPECT_EQ(mistake("-08"), "must not start with a zero, which some take for an octal number: `-08`");
  EXPECT_EQ(mistake(".inf"), "must be finite, but is `.inf`");
  EXPECT_EQ(mistake("-.Inf"), "must be finite, but is `-.Inf`");
  EXPECT_EQ(mistake("NaN"), "must be finite, but is `NaN`");
  EXPECT_EQ(mistake("1e999"), "is out of the range of numbers: `1e999`");
  EXPECT_EQ(mistake("0x10"), "takes no unit, but has `x10`");
  EXPECT_EQ(mistake("1_000"), "takes no unit, but has `_000`");
  EXPECT_EQ(mistake("1:30"), "takes no unit, but has `:30`");
}

TEST(Quantity, RefusesWhatIsNoNumber) {
  EXPECT_EQ(mistake(""), "must be a number, not ``");
  EXPECT_EQ(mistake("-"), "must be a number, not `-`");
  EXPECT_EQ(mistake("."), "must be a number, not `.`");
  EXPECT_EQ(mistake("two"), "must be a number, not `two`");
  EXPECT_EQ(mistake("1 2"), "must be a number, not `1 2`");
  EXPECT_EQ(mistake("1.2.3"), "must be a number, not `1.2.3`");
  EXPECT_EQ(mistake("x", Quantity::length), "must be a length (a number, in m, cm, mm), not `x`");
}

TEST(Quantity, SaysWhichUnitsFit) {
  EXPECT_EQ(mistake("2 mm", Quantity::time), "must be a time, in s, ms, us, min, not in `mm`");
  EXPECT_EQ(mistake("5 MM", Quantity::length), "must be a length, in m, cm, mm, not in `MM`");
  EXPECT_EQ(mistake("5 %"), "takes no unit, but has `%`");
}

}  // namespace drape

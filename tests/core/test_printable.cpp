#include "core/printable.h"

#include <gtest/gtest.h>

namespace drape {
namespace {

TEST(Printable, NamesOfAllLanguagesStay) {
  for (const char* name : {"walk", "göhn", "歩く", "🐟", ""}) EXPECT_EQ(printable(name, 100), name);
}

TEST(Printable, WhatATerminalWouldObeyGoes) {
  EXPECT_EQ(printable("a\x1b[2Jb\nc\x7f", 100), "a?[2Jb?c?");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J\xC2\xA0",
                      100),
            "?2J\xC2\xA0");  // U+009B starts a command, too
  EXPECT_EQ(printable(std::string_view("\0", 1), 100), "?");
}

TEST(Printable, BytesThatAreNoUtf8Go) {
  EXPECT_EQ(printable("\xFFz", 100), "?z");
  EXPECT_EQ(printable("\xC0\xAF", 100), "??");       // overlong
  EXPECT_EQ(printable("\xED\xA0\x80", 100), "???");  // a surrogate
  EXPECT_EQ(printable("\xE2\x82", 100), "??");       // cut off
}

TEST(Printable, IsCutBetweenCharacters) {
  EXPECT_EQ(printable("abcd", 3), "abc");
  EXPECT_EQ(printable("abä", 3), "ab");
  EXPECT_EQ(printable("abä", 4), "abä");
}

}  // namespace
}  // namespace drape

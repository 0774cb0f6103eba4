#include "scene/yaml_document.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/scene_text.h"

namespace drape {

static Node parse(const std::string& text) {
  ProblemList problems;
  DocumentBudget budget;
  auto node = parse_yaml(text, std::make_shared<const std::string>("a.yaml"), budget, problems);
  problems.throw_if_any("a.yaml");
  return std::move(*node);
}

static std::string words_of(const std::string& text) {
  try {
    parse(text);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

static std::string repeat(const std::string& text, int times) {
  std::string result;
  for (int i = 0; i < times; ++i) result += text;
  return result;
}

TEST(Document, CountsPlacesFromOne) {
  const Node root = parse("a: 1\nb:\n  c: [x, yy]\n");
  EXPECT_EQ(root.place.line, 1);
  const MapEntry& b = root.entries.at(1);
  EXPECT_EQ(b.place.line, 2);
  const MapEntry& c = b.value.entries.at(0);
  EXPECT_EQ(c.place.line, 3);
  EXPECT_EQ(c.place.column, 3);
  EXPECT_EQ(c.value.items.at(1).place.column, 10);
  EXPECT_EQ(*c.place.file, "a.yaml");
}

TEST(Document, KeepsScalarsAsText) {
  const Node root = parse("[010, .inf, yes, 'a b', \"#fff\", ~, 1e3]");
  EXPECT_EQ(root.items.at(0).text, "010");
  EXPECT_EQ(root.items.at(1).text, ".inf");
  EXPECT_EQ(root.items.at(2).text, "yes");
  EXPECT_EQ(root.items.at(3).text, "a b");
  EXPECT_EQ(root.items.at(4).text, "#fff");
  EXPECT_EQ(root.items.at(5).kind, Node::Kind::null);
  EXPECT_EQ(root.items.at(6).text, "1e3");
}

TEST(Document, ExpandsAliases) {
  const Node root = parse("a: &x {k: [1, 2]}\nb: *x\n");
  EXPECT_EQ(root.entries.at(1).value.entries.at(0).value.items.size(), 2u);
}

TEST(Document, TakesAByteOrderMarkAndForeignLineEnds) {
  EXPECT_EQ(parse("\xEF\xBB\xBF"
                  "a: 1\r\nb: 2\r\n")
                .entries.size(),
            2u);
}

TEST(Document, TakesNoMoreThanAMebibyte) {
  const std::string comment = "#" + std::string(largest_document - 2, ' ') + "\n";
  EXPECT_EQ(words_of(comment), "");
  EXPECT_EQ(words_of(comment + "\n"), "a.yaml: error: 1048577 bytes; a scene has at most 1048576");
}

TEST(Document, TakesNoMoreThan64Levels) {
  EXPECT_EQ(words_of(repeat("[", 63) + "1" + repeat("]", 63)), "");
  EXPECT_EQ(words_of(repeat("[", 64) + repeat("]", 64)), "");
  EXPECT_EQ(words_of(repeat("[", 65) + repeat("]", 65)), "a.yaml:1:65: error: nested deeper than 64 levels");
  EXPECT_NE(words_of(repeat("[", 500'000)), "");
}

TEST(Document, CountsLevelsThroughAliases) {
  const std::string forty = repeat("[", 40) + repeat("]", 40);
  EXPECT_EQ(words_of("- &a " + forty + "\n- " + repeat("[", 30) + "*a" + repeat("]", 30) + "\n"),
            "a.yaml:2:33: error: nested deeper than 64 levels");
}

TEST(Document, TakesNoMoreThan100000Values) {
  EXPECT_EQ(words_of("[" + repeat("1,", 99'998) + "1]"), "");
  EXPECT_EQ(words_of("[" + repeat("1,", 99'999) + "1]"),
            "a.yaml:1:200000: error: more than 100000 values, with aliases expanded");
}

TEST(Document, CountsTextThroughAliases) {
  const std::string words = words_of("- &a " + std::string(100'000, 'x') + "\n" + repeat("- *a\n", 50));
  EXPECT_EQ(words, "a.yaml:10:3: error: more than 1048576 bytes of text, with aliases expanded");
}

TEST(Document, RefusesAnAliasToItself) {
  EXPECT_EQ(words_of("a: &x [*x]\n"), "a.yaml:1:8: error: an alias stands inside of what it stands for");
}

TEST(Document, RefusesWhatYamlHasAndASceneHasNot) {
  EXPECT_EQ(words_of("a: !!str 1\n"),
            "a.yaml:1:4: error: the tag `tag:yaml.org,2002:str` has no meaning in a scene");
  EXPECT_EQ(words_of("[1]: 2\n"), "a.yaml:1:1: error: a key must be text");
  EXPECT_EQ(words_of("? {a: 1}\n: 2\n"), "a.yaml:1:3: error: a key must be text");
}

TEST(Document, RefusesControlCharacters) {
  EXPECT_EQ(words_of(std::string("a: \0b", 5)), "a.yaml:1:4: error: the control character 0x00 is not text");
  EXPECT_EQ(words_of("a: 1\nb: \x1B[0m"), "a.yaml:2:4: error: the control character 0x1B is not text");
}

TEST(Document, RefusesWhatEscapesBringBack) {
  EXPECT_EQ(words_of("a: \"\\e[2J\"\n"), "a.yaml:1:4: error: the control character 0x1B is not text");
  EXPECT_EQ(words_of("\"a\\nb\": 1\n"), "a.yaml:1:1: error: a key must be one line");
}

// The parser complains about the line after the colour, or about the end of the text.
TEST(Document, PointsAtAColorWithoutQuotesThatLeavesABracketOpen) {
  const std::string words =
      "error: not YAML: # without quotes starts a comment, so that the rest of this line is not read; a "
      "colour "
      "needs them: ";
  EXPECT_EQ(words_of("look: {color: #ff0000}\nb: {c: 1}\n"), "a.yaml:1:15: " + words + "\"#ff0000\"");
  EXPECT_EQ(words_of("a: 1\nlook: {color: #f00, sheen: 1}\n"), "a.yaml:2:15: " + words + "\"#f00\"");
  EXPECT_EQ(words_of("a: [\"#abc\", #00ff00]\nb: 1\n"), "a.yaml:1:13: " + words + "\"#00ff00\"");
  EXPECT_EQ(words_of("a: {pattern: \"x, #y\", color: #f00}\nb: 1\n"), "a.yaml:1:30: " + words + "\"#f00\"");
  EXPECT_EQ(words_of("a: {n: 'it''s, #y', m: \"\\\", #z\", color: #f00}\nb: 1\n"),
            "a.yaml:1:41: " + words + "\"#f00\"");
  EXPECT_EQ(words_of("a: [\n  {color: #f00},\n  {color: \"#0f0\"}\n]\n"),
            "a.yaml:2:11: " + words + "\"#f00\"");
}

TEST(Document, BlamesNoOtherCommentForAnOpenBracket) {
  const std::string open = ": error: not YAML: a `{` is not closed, or a comma is missing before this";
  EXPECT_EQ(words_of("a: {b: 1 #abc\nc: 2\n"), "a.yaml:2:1" + open);      // after the value
  EXPECT_EQ(words_of("a: {b: \"x #abc\"\nc: 2\n"), "a.yaml:2:1" + open);  // in quotes
  EXPECT_EQ(words_of("a: {b: #red\nc: 2\n"), "a.yaml:2:2" + open);        // no colour
  EXPECT_EQ(words_of("name: \"red, #abc is nice\"\na: {b: 1\nc: 2\n"), "a.yaml:3:2" + open);
  EXPECT_EQ(words_of("cloths:  #add more, please\n  a: {b: 1\n  c: 2\n"), "a.yaml:3:4" + open);
  EXPECT_EQ(words_of("back: #f00\nb: 1\nc: 2\nd: 3\na: {b: 1 c: 2}\n"), "a.yaml:5:11" + open);
  EXPECT_EQ(words_of("a: {b: 1, c: #f00\n}\nd: {e: 1\nf: 2\n"), "a.yaml:4:2" + open);  // closed
}

TEST(Document, QuotesWithoutCuttingACharacter) {
  EXPECT_EQ(quote("short"), "`short`");
  const std::string letters(59, 'x');
  EXPECT_EQ(quote(letters + "\xC3\xA4\xC3\xA4"), "`" + letters + "...`");
  EXPECT_EQ(quote("one\ntwo"), "`one...`");
}

TEST(Document, RefusesBrokenUtf8) {
  EXPECT_EQ(words_of("a: \xC3\xA4\n"), "");
  EXPECT_EQ(words_of("a: \xFF\n"), "a.yaml:1:4: error: byte 0xFF is not UTF-8");
  EXPECT_EQ(words_of("a: \xC0\xAF\n"), "a.yaml:1:4: error: byte 0xC0 is not UTF-8");      // overlong
  EXPECT_EQ(words_of("a: \xED\xA0\x80\n"), "a.yaml:1:4: error: byte 0xED is not UTF-8");  // a surrogate
  EXPECT_EQ(words_of("a: \xE2\x82"), "a.yaml:1:4: error: byte 0xE2 is not UTF-8");        // cut off
}

}  // namespace drape

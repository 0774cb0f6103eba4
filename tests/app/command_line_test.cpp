#include "app/command_line.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace drape::app {
namespace {

CommandLine parse(std::vector<const char*> words) {
  words.insert(words.begin(), "drape");
  return parse_command_line(static_cast<int>(words.size()), words.data());
}

TEST(CommandLine, BecomesOptions) {
  const CommandLine line = parse(
      {"render", "a.yaml",     "-D", "time.step=1 ms", "-D",    "name=b",    "-f",    "1-9",        "--chunk",
       "2/3",    "-j",         "4",  "--resolution",   "64x36", "--quality", "draft", "--progress", "json",
       "-q",     "--overwrite"});
  EXPECT_EQ(line.error, "");
  EXPECT_EQ(line.options.command, Command::render);
  EXPECT_EQ(line.options.inputs, std::vector<std::string>({"a.yaml"}));
  EXPECT_EQ(line.options.overrides,
            std::vector<std::string>(
                {"time.step=1 ms", "name=b", "render.resolution=[64, 36]", "render.quality=draft"}));
  EXPECT_EQ(line.options.frames, "1-9");
  EXPECT_EQ(line.options.chunk.count, 3);
  EXPECT_EQ(line.options.threads, 4);
  EXPECT_EQ(line.options.progress, ProgressStyle::json);
  EXPECT_EQ(line.options.verbosity, -1);
  EXPECT_TRUE(line.options.overwrite);
}

TEST(CommandLine, EachCommandHasHelpWithAnExample) {
  for (const char* command :
       {"run", "simulate", "render", "encode", "still", "validate", "info", "export", "verify", "diff"}) {
    const CommandLine line = parse({command, "--help"});
    EXPECT_EQ(line.error, "");
    EXPECT_NE(line.answer.find(std::string("Example:\n  drape ") + command), std::string::npos) << command;
  }
}

TEST(CommandLine, NamesTheCommandsWhereOneIsMistyped) {
  EXPECT_EQ(parse({"rnu", "a.yaml"}).error,
            "drape: error: there is no command 'rnu'; the commands are run, simulate, render, encode, still, "
            "validate, info, export, measure, verify, diff\n");
}

TEST(CommandLine, SaysHowToSetTheFramesWhereNoFlagDoes) {
  const std::string words =
      " has no --frames, since it is for all frames of the scene: set these with -D time.frames=1-N\n";
  EXPECT_EQ(parse({"run", "a.yaml", "--frames", "5"}).error, "drape: error: 'run'" + words);
  EXPECT_EQ(parse({"simulate", "-f", "5", "a.yaml"}).error, "drape: error: 'simulate'" + words);
  EXPECT_EQ(parse({"encode", "a.yaml", "--frames=5"}).error, "drape: error: 'encode'" + words);
  EXPECT_EQ(parse({"run", "a.yaml", "-f5"}).error, "drape: error: 'run'" + words);
  EXPECT_NE(parse({"run", "--help", "-f"}).answer.find("drape run"), std::string::npos);
  EXPECT_EQ(parse({"run", "-o", "-f", "a.yaml"}).error.find("time.frames"), std::string::npos);
  EXPECT_EQ(parse({"run", "a.yaml", "-x"}).error.find("time.frames"), std::string::npos);
  EXPECT_EQ(parse({"render", "a.yaml", "--frames", "5"}).error, "");
  EXPECT_EQ(parse({"diff", "a.png", "b.png", "-f"}).error.find("time.frames"), std::string::npos);
}

TEST(CommandLine, RefusesWhatACommandDoesNotTake) {
  EXPECT_NE(parse({}).error, "");
  EXPECT_NE(parse({"run"}).error, "");
  EXPECT_NE(parse({"simulate", "a.yaml", "b.yaml"}).error, "");
  EXPECT_NE(parse({"run", "a.yaml", "--progress", "sometimes"}).error, "");
  EXPECT_NE(parse({"run", "a.yaml", "--resume", "--overwrite"}).error, "");
  EXPECT_NE(parse({"diff", "a.png"}).error, "");
  EXPECT_THROW(parse({"run", "a.yaml", "--resolution", "big"}), InputError);
}

}  // namespace
}  // namespace drape::app

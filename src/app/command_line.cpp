#include "app/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "app/frame_range.h"
#include "app/program.h"

namespace drape::app {

// CLI11 would print the rule of each check behind the flag, where the type's name stands already.
static CLI::Validator without_description(CLI::Validator check) { return check.description(""); }

// A flag that takes one of a few words.
template <typename Choice>
static void add_choice(CLI::App& command, const char* flag, Choice& value, const char* help,
                       const std::vector<std::pair<std::string, Choice>>& choices) {
  std::vector<std::string> words;
  words.reserve(choices.size());
  for (const auto& choice : choices) words.push_back(choice.first);
  const auto choose = [&value, choices](const std::string& word) {
    for (const auto& choice : choices) {
      if (choice.first == word) value = choice.second;
    }
  };
  command.add_option_function<std::string>(flag, choose, help)
      ->check(without_description(CLI::IsMember(words)))
      ->type_name(fmt::format("{}", fmt::join(words, "|")));
}

static void add_scenes(CLI::App& command, Options& options, const char* help, bool many) {
  auto* scenes = command.add_option("scene", options.inputs, help)->required();
  scenes->expected(1, many ? CLI::detail::expected_max_vector_size : 1);
  scenes->type_name("SCENE");
}

// Flags of every command that reads a scene.
static void add_scene_flags(CLI::App& command, Options& options) {
  command.add_option("-o,--output", options.output, "Where the results go")->type_name("PATH");
  command.add_option("-D,--define", options.overrides, "Set a key of the scene: -D time.step=\"1 ms\"")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

static void add_picture_flags(CLI::App& command, Options& options) {
  const auto set_resolution = [&options](const std::string& text) {
    options.overrides.push_back("render.resolution=" + resolution_as_yaml(text));
  };
  const auto set_quality = [&options](const std::string& quality) {
    options.overrides.push_back("render.quality=" + quality);
  };
  command.add_option_function<std::string>("--resolution", set_resolution, "Size of the pictures, 1280x720")
      ->type_name("WxH");
  command.add_option_function<std::string>("--quality", set_quality, "How many passes a picture gets")
      ->type_name("draft|preview|final");
}

static void add_frames(CLI::App& command, Options& options, const char* help) {
  command.add_option("-f,--frames", options.frames, help)->type_name("FRAMES");
}

static void add_chunk(CLI::App& command, Options& options) {
  const auto set_chunk = [&options](const std::string& text) { options.chunk = parse_chunk(text); };
  command.add_option_function<std::string>("--chunk", set_chunk, "Only the i-th of n equal parts")
      ->type_name("I/N");
}

static void add_restart_flags(CLI::App& command, Options& options) {
  auto* resume =
      command.add_flag("--resume", options.resume,
                       "Go on from results that another build of drape made (from those of this build "
                       "it always goes on)");
  command.add_flag("--overwrite", options.overwrite, "Make everything anew")->excludes(resume);
}

static void add_threads(CLI::App& command, Options& options) {
  command.add_option("-j,--threads", options.threads, "Threads to use; one a core by default")
      ->check(without_description(CLI::Range(1, 1024)))
      ->type_name("N");
}

static void add_statistics(CLI::App& command, Options& options) {
  command.add_option("--stats", options.statistics_file, "Also write the figures of each frame, as CSV")
      ->type_name("FILE");
}

static void add_console_flags(CLI::App& command, Options& options) {
  add_choice<ProgressStyle>(command, "--progress", options.progress, "How progress is shown on stderr",
                            {{"auto", ProgressStyle::automatic},
                             {"bar", ProgressStyle::bar},
                             {"lines", ProgressStyle::lines},
                             {"json", ProgressStyle::json},
                             {"none", ProgressStyle::none}});
  add_choice<UseColor>(
      command, "--color", options.color, "Colours on stderr; NO_COLOR is obeyed",
      {{"auto", UseColor::automatic}, {"always", UseColor::always}, {"never", UseColor::never}});
  const auto be_verbose = [&options](std::int64_t) { options.verbosity = 1; };
  const auto be_quiet = [&options](std::int64_t) { options.verbosity = -1; };
  auto* verbose = command.add_flag("-v,--verbose", be_verbose, "Say more");
  command.add_flag("-q,--quiet", be_quiet, "Say nothing but errors")->excludes(verbose);
}

namespace {

// Adds a subcommand with its example; it tells `options` when it was chosen.
class Subcommands {
 public:
  Subcommands(CLI::App& app, Options& options) : app_(app), options_(options) {}

  CLI::App& add(Command command, const char* name, const char* help, const char* example) {
    CLI::App* subcommand = app_.add_subcommand(name, help);
    subcommand->footer(fmt::format("Example:\n  {}", example));
    subcommand->callback([this, command] { options_.command = command; });
    add_console_flags(*subcommand, options_);
    return *subcommand;
  }

 private:
  CLI::App& app_;
  Options& options_;
};

}  // namespace

static void add_run(Subcommands& commands, Options& options) {
  CLI::App& command = commands.add(Command::run, "run", "Simulate, render and encode: the main job",
                                   "drape run scenes/hello_drape.yaml -o out/hello_drape --quality draft");
  add_scenes(command, options, "Scene files; several are a batch, with a table at the end", true);
  add_scene_flags(command, options);
  add_picture_flags(command, options);
  add_restart_flags(command, options);
  add_threads(command, options);
  add_statistics(command, options);
}

static void add_simulate(Subcommands& commands, Options& options) {
  CLI::App& command = commands.add(Command::simulate, "simulate", "Only the simulation, into the cache",
                                   "drape simulate scenes/hello_drape.yaml -D time.frames=1-240");
  add_scenes(command, options, "A scene file, or the folder of an earlier run", false);
  add_scene_flags(command, options);
  add_restart_flags(command, options);
  add_threads(command, options);
  add_statistics(command, options);
}

static void add_render(Subcommands& commands, Options& options) {
  CLI::App& command = commands.add(Command::render, "render", "Only the pictures, from the cache",
                                   "drape render out/hello_drape -f 1-100x5 --resolution 640x360");
  add_scenes(command, options, "A scene file, or the folder of an earlier run", false);
  add_scene_flags(command, options);
  add_picture_flags(command, options);
  add_frames(command, options, "Which frames: 1-100, 1-100x5, 1,5,9-12");
  add_chunk(command, options);
  add_restart_flags(command, options);
  add_threads(command, options);
}

static void add_encode(Subcommands& commands, Options& options) {
  CLI::App& command = commands.add(Command::encode, "encode", "Only the video, from the pictures",
                                   "drape encode out/hello_drape -D render.video.crf=23");
  add_scenes(command, options, "A scene file, or the folder of an earlier run", false);
  add_scene_flags(command, options);
}

static void add_still(Subcommands& commands, Options& options) {
  CLI::App& command = commands.add(Command::still, "still", "One picture, from the cache",
                                   "drape still out/hello_drape -f 60 -o hello.png --quality final");
  add_scenes(command, options, "A scene file, or the folder of an earlier run", false);
  add_scene_flags(command, options);
  add_picture_flags(command, options);
  add_frames(command, options, "The frame");
}

static void add_validate_and_info(Subcommands& commands, Options& options) {
  CLI::App& validate = commands.add(Command::validate, "validate", "Read everything and list every mistake",
                                    "drape validate scenes/hello_drape.yaml scenes/flag.yaml");
  add_scenes(validate, options, "Scene files", true);
  add_scene_flags(validate, options);
  CLI::App& info = commands.add(Command::info, "info", "Sizes, steps, and an estimate of memory and time",
                                "drape info scenes/hello_drape.yaml --quality final");
  add_scenes(info, options, "A scene file, or the folder of an earlier run", false);
  add_scene_flags(info, options);
  add_picture_flags(info, options);
}

static void add_export(Subcommands& commands, Options& options) {
  CLI::App& command =
      commands.add(Command::export_geometry, "export", "Geometry for other programs, a file a frame",
                   "drape export out/hello_drape --format obj -o hello_obj");
  add_scenes(command, options, "A scene file, or the folder of an earlier run", false);
  add_scene_flags(command, options);
  add_frames(command, options, "Which frames: 1-100, 1-100x5, 1,5,9-12");
  add_choice<GeometryFormat>(command, "--format", options.format, "OBJ (one object a cloth) or PLY",
                             {{"obj", GeometryFormat::obj}, {"ply", GeometryFormat::ply}});
  command.add_flag("--colliders", options.with_colliders, "Also the colliders");
}

static void add_measure(Subcommands& commands, Options& options) {
  CLI::App& command =
      commands.add(Command::measure, "measure", "What the scene's `measure` asks for, from the cache",
                   "drape measure out/cusick --json");
  add_scenes(command, options, "A scene file, or the folder of an earlier run", false);
  add_scene_flags(command, options);
  add_frames(command, options, "The frame; the last by default");
  command.add_flag("--json", options.as_json, "One JSON object in place of a line for each figure");
}

static void add_verify(Subcommands& commands, Options& options) {
  CLI::App& command = commands.add(Command::verify, "verify",
                                   "Certify frames: nothing meets, nothing is in a collider, all is finite",
                                   "drape verify out/hello_drape -f 60-90\n  drape verify cloth.####.obj "
                                   "--rest flat.obj --json -o pictures");
  add_scenes(
      command, options,
      "A scene file, the folder of a run, or OBJ and PLY files of anyone's: names, a folder, or a pattern",
      true);
  add_scene_flags(command, options);
  add_frames(command, options, "Which frames: 1-100, 1-100x5, 1,5,9-12");
  command
      .add_option("--rest", options.rest_file,
                  "The mesh whose edges are unstretched; by default rest.obj beside the frames, if it has "
                  "their faces, or the first. Faces that a file has after those of this mesh are colliders")
      ->type_name("FILE");
  command.add_flag("--json", options.as_json, "One JSON object in place of the table");
  add_threads(command, options);
}

static void add_diff(Subcommands& commands, Options& options) {
  CLI::App& command = commands.add(Command::diff, "diff", "Compare two pictures, or two folders of pictures",
                                   "drape diff out/a/frames out/b/frames --heat out/heat");
  command
      .add_option("pictures", options.inputs,
                  "Two PNG files, or two folders with PNG files of the same names")
      ->required()
      ->expected(2)
      ->type_name("PATH");
  command.add_option("--tolerance", options.diff.tolerance, "Steps of 1/255 that a channel may differ by")
      ->check(without_description(CLI::Range(0, 255)))
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--share", options.diff.share, "Share of the pixels that may differ by more")
      ->check(without_description(CLI::Range(0.0, 1.0)))
      ->type_name("SHARE")
      ->capture_default_str();
  command.add_option("--heat", options.diff.heat, "Write a heat map here (for folders: into this folder)")
      ->type_name("PATH");
}

static void add_subcommands(Subcommands& commands, Options& options) {
  add_run(commands, options);
  add_simulate(commands, options);
  add_render(commands, options);
  add_encode(commands, options);
  add_still(commands, options);
  add_validate_and_info(commands, options);
  add_export(commands, options);
  add_measure(commands, options);
  add_verify(commands, options);
  add_diff(commands, options);
}

// CLI11 has no words of its own for a mistyped command.
static std::string unknown_command(const CLI::App& app, int argument_count, const char* const* arguments) {
  if (argument_count < 2 || arguments[1][0] == '-') return "";
  std::string names;
  for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (subcommand->get_name() == arguments[1]) return "";
    names += (names.empty() ? "" : ", ") + subcommand->get_name();
  }
  return fmt::format("drape: error: there is no command '{}'; the commands are {}\n", arguments[1], names);
}

static bool is_frames_flag(std::string_view word) {
  return word.starts_with("-f") || word == "--frames" || word.starts_with("--frames=");
}

// CLI11 takes what follows the flag for another scene. Which frames a scene has is a key of its own.
static bool has_misplaced_frames(const CLI::App& command) {
  const auto takes = [&](const char* flag) { return command.get_option_no_throw(flag) != nullptr; };
  const std::vector<std::string> unknown = command.remaining();
  return takes("--define") && !takes("--frames") &&
         std::any_of(unknown.begin(), unknown.end(), is_frames_flag);
}

static std::string words_of(const CLI::App& app, const std::string& refusal) {
  const auto commands = app.get_subcommands();
  if (commands.empty() || !has_misplaced_frames(*commands.front())) return "drape: error: " + refusal;
  return fmt::format(
      "drape: error: '{}' has no --frames, since it is for all frames of the scene: set these with "
      "-D time.frames=1-N\n",
      commands.front()->get_name());
}

// CLI11 answers --help and --version by an exception too: with an exit code of 0.
static void record_refusal(const CLI::App& app, const CLI::ParseError& refusal, CommandLine& result) {
  std::ostringstream out;
  std::ostringstream err;
  app.exit(refusal, out, err);
  if (refusal.get_exit_code() == 0) {
    result.answer = out.str();
  } else {
    result.error = words_of(app, err.str());
  }
}

CommandLine parse_command_line(int argument_count, const char* const* arguments) {
  CommandLine result;
  CLI::App app{"Drape renders animations of cloth: a scene file in, pictures and a video out.", "drape"};
  app.set_version_flag("--version", fmt::format("drape {}", program_version()));
  app.require_subcommand(1);
  app.footer("`drape COMMAND --help` shows the flags of a command and an example.");
  Subcommands commands(app, result.options);
  add_subcommands(commands, result.options);
  result.error = unknown_command(app, argument_count, arguments);
  if (!result.error.empty()) return result;
  try {
    app.parse(argument_count, arguments);
  } catch (const CLI::ParseError& refusal) {
    record_refusal(app, refusal, result);
  }
  return result;
}

}  // namespace drape::app

#include <chrono>
#include <filesystem>
#include <set>

#include "app/batch.h"
#include "app/certify_run.h"
#include "app/commands.h"
#include "app/encode.h"
#include "app/exit_status.h"
#include "app/failure.h"
#include "app/interrupt.h"
#include "app/render_frames.h"
#include "app/run.h"
#include "app/simulate.h"
#include "app/statistics_file.h"
#include "core/error.h"

namespace drape::app {
namespace fs = std::filesystem;

// Makes the film; its path.
static std::string make_film(const std::string& input, const std::string& output, const Options& options,
                             const Console& console) {
  Run run = open_run(input, options.overrides, output);
  simulate(run, options, console);
  if (!options.statistics_file.empty()) write_statistics(options.statistics_file, run.manifest);
  certify_run(run, options, console);
  render_frames(run, chosen_frames(run, options), options, console);
  encode(run, console);
  return run.folder.video().string();
}

// What tells a scene from the others of a batch: a folder's name as it is, a file's without its ending.
static std::string name_in_batch(const std::string& input) {
  fs::path path = fs::absolute(input).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();  // "out/film/"
  std::error_code ignored;
  return (fs::is_directory(path, ignored) ? path.filename() : path.stem()).string();
}

// In a batch, -o names the folder that the scenes' folders go into.
static std::string output_in_batch(const std::string& input, const std::string& output) {
  return output.empty() ? "" : (fs::path(output) / name_in_batch(input)).string();
}

static void check_batch(const Options& options) {
  std::vector<Problem> problems;
  if (!options.statistics_file.empty())
    problems.push_back({"", 0, 0, "--stats takes one scene, not several"});
  std::set<std::string> names;
  for (const std::string& input : options.inputs) {
    if (!names.insert(name_in_batch(input)).second) {
      problems.push_back(
          {input, 0, 0, "another scene of this batch has the same name and would write to the same folder"});
    }
  }
  if (!problems.empty()) throw InputError(problems);
}

// A scene that fails is an entry of the table, and the next one's turn. Only a signal ends the batch.
static BatchEntry try_scene(const std::string& input, const Options& options, const Console& console) {
  BatchEntry entry;
  entry.scene = input;
  try {
    entry.result = make_film(input, output_in_batch(input, options.output), options, console);
  } catch (const Interrupted&) {
    throw;
  } catch (...) {
    const Failure failure = describe_current_exception();
    for (const std::string& line : failure.lines) complain(console, line);
    entry.exit_status = failure.exit_status;
    entry.result = failure.lines.front();
  }
  return entry;
}

static int run_batch(const Options& options, const Console& console) {
  using Clock = std::chrono::steady_clock;
  check_batch(options);
  std::vector<BatchEntry> entries;
  for (const std::string& input : options.inputs) {
    note(console, input);
    const auto start = Clock::now();
    entries.push_back(try_scene(input, options, console));
    entries.back().seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  print_result(batch_table(entries));
  return worst_status(entries);
}

int run_command(const Options& options, const Console& console) {
  if (options.inputs.size() > 1) return run_batch(options, console);
  print_result(make_film(options.inputs.front(), options.output, options, console));
  return static_cast<int>(ExitStatus::done);
}

}  // namespace drape::app

#include "app/encode.h"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <fstream>

#include "app/frame_range.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/stage_timer.h"
#include "app/subprocess.h"
#include "core/error.h"

namespace drape::app {
namespace fs = std::filesystem;

static int frame_count(const Run& run) { return run.scene.time.last_frame - run.scene.time.first_frame + 1; }

// Pictures without a record, such as parts drawn on several machines, are taken as they are.
static void check_origin(const Run& run) {
  const auto record = read_manifest(run.folder.manifest());
  if (!record || record->fingerprint == run.manifest.fingerprint) return;
  throw FileError(run.folder.frames().string(),
                  fmt::format("its pictures are of other settings than the scene has now: run `drape run {}`",
                              run.input));
}

// The bytes of a PNG file that hold its width and height.
static std::string size_bytes(const fs::path& picture) {
  std::array<char, 24> head{};
  std::ifstream stream(picture, std::ios::binary);
  if (!stream.read(head.data(), head.size())) return "";
  return {head.data() + 16, 8};
}

// ffmpeg would leave out what is missing, and scale what differs, without a word.
static void check_pictures(const Run& run) {
  std::string first_size;
  for (const int frame : all_frames(run.scene.time.first_frame, run.scene.time.last_frame)) {
    const fs::path picture = run.folder.frames() / frame_file_name(frame, ".png");
    const std::string size = size_bytes(picture);
    if (size.empty())
      throw FileError(picture.string(), fmt::format("is missing: run `drape render {}`", run.input));
    if (first_size.empty()) first_size = size;
    if (size != first_size) {
      throw FileError(picture.string(),
                      fmt::format("is not of the first frame's size: run `drape render {}`", run.input));
    }
  }
}

// ffmpeg takes "name:" at the start for a protocol, "-" for a flag, and "%" for the number of the frame.
static std::string plain_path(const fs::path& path) {
  return path.is_absolute() ? path.string() : (fs::path(".") / path).string();
}

static std::string frame_pattern(const fs::path& folder) {
  std::string pattern;
  for (const char letter : plain_path(folder)) pattern += letter == '%' ? "%%" : std::string(1, letter);
  return pattern + "/frame_%04d.png";
}

using Words = std::vector<std::string>;

static Words input_words(const Run& run) {
  const TimeSettings& time = run.scene.time;
  return {
      "-framerate", fmt::format("{}", time.fps),        "-start_number", fmt::format("{}", time.first_frame),
      "-i",         frame_pattern(run.folder.frames()), "-frames:v",     fmt::format("{}", frame_count(run))};
}

// H.264 needs even sizes.
static Words color_words() {
  const std::string filter =
      "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";
  return {"-vf",   filter,       "-colorspace", "bt709",        "-color_primaries",
          "bt709", "-color_trc", "bt709",       "-color_range", "tv"};
}

// The bytes of H.264 depend on the number of threads, so that is not left to the machine.
static Words output_words(const Run& run, const fs::path& target) {
  return {"-c:v",      "libx264",
          "-crf",      fmt::format("{}", run.scene.render.crf),
          "-threads",  "4",
          "-movflags", "+faststart",
          "-f",        "mp4",
          "-progress", "pipe:1",
          "-nostats",  plain_path(target)};
}

Words encoder_arguments(const Run& run, const fs::path& target) {
  Words words = {"ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
  for (const Words& part : {input_words(run), color_words(), output_words(run, target)}) {
    words.insert(words.end(), part.begin(), part.end());
  }
  return words;
}

static void check_result(const ProcessResult& result, int encoded, int expected) {
  throw_if_stopped();
  if (!result.was_found) {
    throw EncoderError(
        "ffmpeg is not installed, so there is no video; the frames are done. Install it (Debian: "
        "apt-get install ffmpeg) and run `drape encode`");
  }
  if (result.exit_status != 0) {
    throw EncoderError(fmt::format("ffmpeg failed with status {}: {}", result.exit_status, result.errors));
  }
  if (encoded != expected)
    throw EncoderError(fmt::format("ffmpeg encoded {} of {} frames", encoded, expected));
}

namespace {

// A name to write under until the file is whole; what is left under it is removed.
class Aside {
 public:
  explicit Aside(fs::path target) : target_(std::move(target)) {
    path_ = target_;
    path_ += fmt::format(".part{}", getpid());
  }
  ~Aside() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  const fs::path& path() const { return path_; }
  void rename_to_target() const {
    std::error_code error;
    fs::rename(path_, target_, error);
    if (error) throw FileError(target_.string(), "cannot be written: " + error.message());
  }

 private:
  fs::path target_;
  fs::path path_;
};

}  // namespace

// The number in a line "frame=12", which ffmpeg reports as it goes; `before` where the line is another.
static int encoded_frames(std::string_view line, int before) {
  constexpr std::string_view label = "frame=";
  if (!line.starts_with(label)) return before;
  int number = before;
  std::from_chars(line.data() + label.size(), line.data() + line.size(), number);
  return number;
}

// The CPU time that ffmpeg took.
static double run_encoder(const Run& run, const Console& console) {
  const int expected = frame_count(run);
  Progress progress(console, "encode", expected);
  const Aside video(run.folder.video());
  int encoded = 0;
  const auto result = run_process(encoder_arguments(run, video.path()), [&](std::string_view line) {
    const int before = encoded;
    encoded = encoded_frames(line, encoded);
    if (encoded != before) progress.update(encoded);
  });
  check_result(result, encoded, expected);
  video.rename_to_target();
  return result.cpu_seconds;
}

void encode(Run& run, const Console& console) {
  check_origin(run);
  check_pictures(run);
  StageTiming timing;
  {
    const StageTimer timer(timing);
    timing.cpu_seconds = run_encoder(run, console);
  }
  run.manifest.stages["encode"] = timing;
  update_record(run);
}

}  // namespace drape::app

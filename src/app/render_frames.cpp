#include "app/render_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "app/interrupt.h"
#include "app/picture_key.h"
#include "app/program.h"
#include "app/progress.h"
#include "app/stage_timer.h"
#include "app/view.h"
#include "render/png_file.h"

namespace drape::app {

namespace {

// The arguments of Rasterizer::draw.
struct Picture {
  std::vector<render::Surface> surfaces;
  render::View view;
  render::Settings settings;
};

// What the workers share.
struct Job {
  const Run& run;
  const std::vector<int>& frames;
  const Options& options;
  const PreparedScene scene;
  const std::uint64_t build;
  Progress& progress;
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex{};  // guards what follows, and the progress
  int finished = 0;
  int drawn = 0;
  std::map<int, std::uint64_t> picture_hashes{};
  std::exception_ptr failure{};
};

}  // namespace

static Picture describe_picture(const Run& run, const PreparedScene& scene, int frame) {
  const CachedFrame cached = read_cached_frame(run.folder.cache(), run.manifest.fingerprint, frame);
  return {frame_surfaces(scene, cached), frame_view(run.scene, cached), picture_settings(run.scene.render)};
}

static render::Image draw(render::Rasterizer& rasterizer, const Picture& picture) {
  return rasterizer.draw(picture.surfaces, picture.view, picture.settings);
}

// Whether the picture in the folder is the one that would be drawn now.
static bool is_current(const Job& job, const std::filesystem::path& path, std::uint64_t key) {
  if (job.options.overwrite) return false;
  const auto origin = read_origin(path);
  if (!origin || origin->key != key) return false;
  const bool same_program = origin->build == job.build || job.options.resume;
  return same_program && origin->picture_hash == file_hash(path);
}

// Draws the frame unless it is there; the hash of its file, and whether it was drawn.
static std::pair<std::uint64_t, bool> provide_frame(const Job& job,
                                                    std::optional<render::Rasterizer>& rasterizer,
                                                    int frame) {
  const auto path = job.run.folder.frames() / frame_file_name(frame, ".png");
  const Picture picture = describe_picture(job.run, job.scene, frame);
  const std::uint64_t key = picture_key(picture.surfaces, picture.view, picture.settings);
  if (is_current(job, path, key)) return {file_hash(path), false};
  if (!rasterizer) rasterizer.emplace();  // only where there is something to draw: a context takes a second
  render::write_png(path, draw(*rasterizer, picture));
  const std::uint64_t picture_hash = file_hash(path);
  write_origin(path, {key, job.build, picture_hash});
  return {picture_hash, true};
}

static void work(Job& job) {
  std::optional<render::Rasterizer> rasterizer;
  while (!job.failed && stop_signal() == 0) {
    const std::size_t index = job.next++;
    if (index >= job.frames.size()) return;
    const auto [hash, was_drawn] = provide_frame(job, rasterizer, job.frames[index]);
    const std::lock_guard lock(job.mutex);
    job.picture_hashes[job.frames[index]] = hash;
    job.drawn += was_drawn ? 1 : 0;
    job.progress.update(++job.finished);
  }
}

static void work_and_catch(Job& job) {
  try {
    work(job);
  } catch (...) {
    const std::lock_guard lock(job.mutex);
    if (!job.failed) job.failure = std::current_exception();
    job.failed = true;
  }
}

static void run_workers(Job& job, int threads) {
  std::vector<std::jthread> workers;
  for (int i = 0; i < threads; ++i) workers.emplace_back([&job] { work_and_catch(job); });
}

static int thread_count(const Options& options) {
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  return options.threads > 0 ? options.threads : std::max(1, cores);
}

// Parts of a film are drawn by several processes, perhaps at a time: they leave the record alone.
static void record_pictures(Run& run, const Job& job) {
  if (job.options.chunk.count > 1) return;
  for (const auto& [frame, hash] : job.picture_hashes) {
    const auto record = run.manifest.frames.find(frame);
    if (record != run.manifest.frames.end()) record->second.picture_hash = hash;
  }
  update_record(run);
}

void render_frames(Run& run, const std::vector<int>& frames, const Options& options, const Console& console) {
  render::configure_software_rendering(thread_count(options));
  Progress progress(console, "render", static_cast<int>(frames.size()));
  Job job{run, frames, options, prepare_scene(run.scene), program_build(), progress};
  StageTiming timing;
  {
    const StageTimer timer(timing);
    run_workers(job, std::min(thread_count(options), static_cast<int>(frames.size())));
  }
  if (job.failure && job.drawn == 0) std::rethrow_exception(job.failure);
  if (job.drawn > 0) run.manifest.stages["render"] = timing;
  record_pictures(run, job);
  detail(console, fmt::format("render    {} drawn, {} kept", job.drawn, job.finished - job.drawn));
  if (job.failure) std::rethrow_exception(job.failure);
  throw_if_stopped();
}

render::Image draw_frame(const Run& run, int frame, const Options& options) {
  render::configure_software_rendering(thread_count(options));
  const Picture picture = describe_picture(run, prepare_scene(run.scene), frame);
  render::Rasterizer rasterizer;
  return draw(rasterizer, picture);
}

}  // namespace drape::app

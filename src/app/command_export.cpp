#include <filesystem>

#include "app/collider_surface.h"
#include "app/commands.h"
#include "app/exit_status.h"
#include "app/geometry_file.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/run.h"
#include "core/file.h"
#include "simulation/cache.h"
#include "simulation/colliders.h"

namespace drape::app {
namespace fs = std::filesystem;

namespace {

// What to export, and how.
struct Export {
  const Run& run;
  const Options& options;
  fs::path folder;
  std::vector<TriangleMesh> colliders;  // empty where they are not asked for
};

}  // namespace

static std::vector<Vec3f> moved(const TriangleMesh& mesh, const RigidPose& pose) {
  std::vector<Vec3f> positions;
  for (const Vec3& position : mesh.positions) positions.push_back(pose(position).cast<float>());
  return positions;
}

static void write(const Export& job, const std::string& name, const std::vector<GeometryPart>& parts) {
  if (job.options.format == GeometryFormat::obj)
    return write_file(job.folder / (name + ".obj"), to_obj(parts));
  write_file(job.folder / (name + ".ply"), to_ply(parts));
}

static void export_rest(const Export& job) {
  std::vector<GeometryPart> parts;
  for (const ClothDescription& cloth : job.run.scene.cloths) {
    parts.push_back({cloth.input.name, &cloth.input.mesh, moved(cloth.input.mesh, RigidPose{})});
  }
  write(job, "rest", parts);
}

static void export_frame(const Export& job, int frame) {
  const CachedFrame cached = read_cached_frame(job.run.folder.cache(), job.run.manifest.fingerprint, frame);
  std::vector<GeometryPart> parts;
  auto next = cached.positions.begin();
  for (const ClothDescription& cloth : job.run.scene.cloths) {
    const auto end = next + static_cast<std::ptrdiff_t>(cloth.input.mesh.positions.size());
    parts.push_back({cloth.input.name, &cloth.input.mesh, {next, end}});
    next = end;
  }
  auto shaped = cached.collider_points.begin();
  for (std::size_t i = 0; i < job.colliders.size(); ++i) {
    const TriangleMesh& mesh = job.colliders[i];
    const ColliderInput& collider = job.run.scene.colliders[i].input;
    const auto end = shaped + (deforms(collider) ? static_cast<std::ptrdiff_t>(mesh.positions.size()) : 0);
    parts.push_back(
        {collider.name, &mesh,
         deforms(collider) ? std::vector<Vec3f>(shaped, end) : moved(mesh, cached.collider_poses[i])});
    shaped = end;
  }
  write(job, frame_file_name(frame, ""), parts);
}

static Export prepare(const Run& run, const Options& options) {
  const char* default_name = options.format == GeometryFormat::obj ? "obj" : "ply";
  Export job{
      run, options, options.output.empty() ? run.folder.root / default_name : fs::path(options.output), {}};
  if (!options.with_colliders) return job;
  for (const auto& collider : run.scene.colliders)
    job.colliders.push_back(collider_mesh(collider.input.shape));
  return job;
}

// Here -o names the folder of the export, so the run is the input's own.
int export_command(const Options& options, const Console& console) {
  const Run run = open_run(options.inputs.front(), options.overrides, "");
  const Export job = prepare(run, options);
  const auto frames = chosen_frames(run, options);
  Progress progress(console, "export", static_cast<int>(frames.size()));
  export_rest(job);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    throw_if_stopped();
    export_frame(job, frames[i]);
    progress.update(static_cast<int>(i + 1));
  }
  print_result(job.folder.string());
  return static_cast<int>(ExitStatus::done);
}

}  // namespace drape::app

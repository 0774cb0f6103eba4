#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include "app/certificate_report.h"
#include "app/commands.h"
#include "app/exit_status.h"
#include "app/fact_check.h"
#include "app/fault_picture.h"
#include "app/interrupt.h"
#include "app/manifest.h"
#include "app/mesh_sequence.h"
#include "app/progress.h"
#include "app/run.h"
#include "app/triangle_names.h"
#include "core/error.h"
#include "core/parallel.h"
#include "render/png_file.h"

namespace drape::app {
namespace fs = std::filesystem;

namespace {

// A surface with what is wrong with it, and how its triangles are called.
struct Fault {
  ClothSurface surface;
  CertifiedSurface certified;
  std::function<std::string(int)> triangle_name;
};

// Frames to certify, wherever they come from.
struct Frames {
  int count = 0;
  std::function<FrameCertificate(int)> certify;
  std::function<Fault(int)> find_fault;  // of a frame that is not certified
  // What a scene says that its frames must show.
  std::function<std::vector<FactResult>(const std::vector<FrameCertificate>&)> check_facts;
  fs::path folder;  // for pictures; empty: none
  std::function<std::string(int)> picture_name;
};

}  // namespace

static void need_frames(const Run& run, const std::vector<int>& frames, bool all_were_meant) {
  for (const int frame : frames) {
    if (fs::exists(cached_frame_path(run.folder.cache(), frame))) continue;
    const bool has_some = all_were_meant && frame > frames.front();
    const std::string way_out =
        has_some ? fmt::format(", or verify those that are there: -f {}-{}", frames.front(), frame - 1) : "";
    throw FileError(
        run.folder.cache().string(),
        fmt::format("there is no frame {} yet: run 'drape simulate {}'{}", frame, run.input, way_out));
  }
}

// What is simulated counts first: where it is at fault, what is drawn follows.
static Fault fault_of(const Run& run, const CertifiedScene& scene, const CachedFrame& frame) {
  Fault fault;
  fault.surface = simulated_surface(scene, frame);
  fault.certified = certify_simulated(scene, frame);
  fault.triangle_name = [&run](int t) { return name_in_cloth(run.scene, t); };
  if (!is_clean(fault.certified)) return fault;
  fault.surface = drawn_surface(scene, frame);
  fault.certified = certify_drawn(scene, frame);
  fault.triangle_name = [&run, &scene](int t) { return name_in_drawn(scene, run.scene, t); };
  return fault;
}

static Frames frames_of_run(const Run& run, const CertifiedScene& scene, const Options& options) {
  const std::vector<int> numbers = chosen_frames(run, options);
  need_frames(run, numbers, options.frames.empty());
  const auto read = [&run, numbers](int i) {
    return read_cached_frame(run.folder.cache(), run.manifest.fingerprint, numbers[i]);
  };
  Frames frames;
  frames.count = static_cast<int>(numbers.size());
  frames.certify = [&scene, read](int i) { return certify_frame(scene, read(i)); };
  frames.find_fault = [&run, &scene, read](int i) { return fault_of(run, scene, read(i)); };
  frames.check_facts = [&run, numbers](const std::vector<FrameCertificate>& certificates) {
    return check_facts(run, numbers, certificates);
  };
  frames.folder = options.output.empty() ? run.folder.root / "verify" : fs::path(options.output);
  frames.picture_name = [numbers](int i) { return frame_file_name(numbers[i], ".png"); };
  return frames;
}

static CertifiedSurface certify(const MeshFrame& frame) {
  const CertifiedCollider colliders{std::nullopt, frame.colliders};
  return certify(frame.surface, {colliders}, {RigidPose{}});
}

static FrameCertificate certify_file(const MeshSequence& sequence, int i) {
  const MeshFrame frame = read_mesh_frame(sequence, sequence.files[i]);
  const CertifiedSurface certified = certify(frame);
  const StretchRange stretch =
      edge_stretch(frame.rest_positions, frame.surface.positions, frame.surface.triangles);
  return {sequence.files[i].string(), certified.is_finite, stretch.smallest, stretch.largest,
          certified.figures,          std::nullopt};
}

static Frames frames_of_files(const MeshSequence& sequence, const Options& options) {
  Frames frames;
  frames.count = static_cast<int>(sequence.files.size());
  frames.certify = [&sequence](int i) { return certify_file(sequence, i); };
  frames.find_fault = [&sequence](int i) {
    Fault fault;
    const MeshFrame frame = read_mesh_frame(sequence, sequence.files[i]);
    fault.surface = frame.surface;
    fault.certified = certify(frame);
    fault.triangle_name = [](int t) { return fmt::format("triangle {}", t + 1); };
    return fault;
  };
  frames.check_facts = [](const std::vector<FrameCertificate>&) { return std::vector<FactResult>(); };
  frames.folder = options.output;
  frames.picture_name = [&sequence](int i) { return sequence.files[i].stem().string() + ".png"; };
  return frames;
}

static std::vector<FrameCertificate> certify_all(const Frames& frames, const Console& console) {
  Progress progress(console, "verify", frames.count);
  std::vector<FrameCertificate> certificates;
  for (int i = 0; i < frames.count; ++i) {
    throw_if_stopped();
    certificates.push_back(frames.certify(i));
    progress.update(i + 1);
  }
  return certificates;
}

static void name_lost_point(const Fault& fault, const std::string& frame, const Console& console) {
  const auto& points = fault.surface.positions;
  const auto lost = std::find_if(points.begin(), points.end(), [](const Vec3& p) { return !p.allFinite(); });
  if (lost != points.end())
    note(console, fmt::format("{}: point {} is not finite", frame, lost - points.begin() + 1));
}

// Names the first points and faces that are at fault: they are where to begin.
static void name_faults(const Fault& fault, const std::string& frame, const Console& console) {
  name_lost_point(fault, frame, console);
  const auto& pairs = fault.certified.intersecting;
  for (std::size_t i = 0; i < std::min<std::size_t>(pairs.size(), 3); ++i)
    note(console, fmt::format("{}: {} meets {}", frame, fault.triangle_name(pairs[i].first),
                              fault.triangle_name(pairs[i].second)));
  const auto& inside = fault.certified.in_colliders;
  for (std::size_t i = 0; i < std::min<std::size_t>(inside.size(), 3); ++i)
    note(console, fmt::format("{}: {} is in a collider", frame, fault.triangle_name(inside[i])));
}

static void show_worst(const Frames& frames, const std::vector<FrameCertificate>& certificates,
                       const Console& console) {
  const int worst = worst_frame(certificates);
  if (worst < 0) return;
  const Fault fault = frames.find_fault(worst);
  name_faults(fault, certificates[worst].name, console);
  const std::vector<int> faulty = faulty_triangles(fault.surface, fault.certified);
  if (faulty.empty()) return;
  if (frames.folder.empty()) return note(console, "a picture of the faces at fault: give a folder with -o");
  const fs::path picture = frames.folder / frames.picture_name(worst);
  render::write_png(picture, draw_faults(fault.surface, faulty));
  note(console, "picture of the faces at fault: " + picture.string());
}

static std::string ending(const CertificateSummary& summary, const std::vector<FactResult>& facts) {
  const auto failed = std::count_if(facts.begin(), facts.end(), [](const FactResult& f) { return !f.holds; });
  if (failed == 0) return verdict(summary);
  return fmt::format("{}, but {} of the {} facts of the scene's `test` fail", verdict(summary), failed,
                     facts.size());
}

static int report(const Frames& frames, const Options& options, const Console& console) {
  const ThreadLimit limit(options.threads);
  const std::vector<FrameCertificate> certificates = certify_all(frames, console);
  const CertificateSummary summary = summarize(certificates);
  const std::vector<FactResult> facts = frames.check_facts(certificates);
  print_result(options.as_json
                   ? to_json(summary, certificates, facts)
                   : certificate_table(certificates) + fact_table(facts) + ending(summary, facts));
  show_worst(frames, certificates, console);
  const bool facts_hold =
      std::all_of(facts.begin(), facts.end(), [](const FactResult& f) { return f.holds; });
  return static_cast<int>(summary.failed == 0 && facts_hold ? ExitStatus::done : ExitStatus::simulation);
}

static int verify_files(const Options& options, const Console& console) {
  if (!options.frames.empty() || !options.overrides.empty())
    throw InputError({{"", 0, 0, "-f and -D are for scenes: of meshes, name the files that are meant"}});
  const MeshSequence sequence = open_mesh_sequence(options.inputs, options.rest_file);
  return report(frames_of_files(sequence, options), options, console);
}

// Here -o names the folder for pictures, so the run is the input's own.
int verify_command(const Options& options, const Console& console) {
  if (names_meshes(options.inputs)) return verify_files(options, console);
  if (options.inputs.size() > 1)
    throw InputError({{options.inputs[1], 0, 0, "verify takes one scene at a time"}});
  if (!options.rest_file.empty())
    throw InputError({{"", 0, 0, "--rest is for files of meshes: a scene has rest shapes of its own"}});
  const Run run = open_run(options.inputs.front(), options.overrides, "");
  const CertifiedScene scene = prepare_certificate(run.scene);
  return report(frames_of_run(run, scene, options), options, console);
}

}  // namespace drape::app

#include "app/certify_run.h"

#include "app/certificate_report.h"
#include "app/frame_range.h"
#include "app/interrupt.h"
#include "app/program.h"
#include "app/progress.h"
#include "app/stage_timer.h"
#include "core/hash.h"
#include "core/parallel.h"

namespace drape::app {

template <typename Number>
static void add_number(Hasher& hasher, Number number) {
  hasher.add(&number, sizeof number);
}

// All that the certificate is a function of.
static std::uint64_t certificate_key(const Run& run) {
  Hasher hasher;
  add_number(hasher, program_build());
  add_number(hasher, run.manifest.fingerprint);
  for (const ClothDescription& cloth : run.scene.cloths) add_number(hasher, cloth.look.subdivide);
  for (int frame = run.scene.time.first_frame; frame <= run.scene.time.last_frame; ++frame) {
    const auto record = run.manifest.frames.find(frame);
    add_number(hasher, record == run.manifest.frames.end() ? 0 : record->second.state_hash);
  }
  return hasher.digest();
}

static std::vector<FrameCertificate> certify_frames(const Run& run, const Console& console) {
  const std::vector<int> frames = all_frames(run.scene.time.first_frame, run.scene.time.last_frame);
  const CertifiedScene scene = prepare_certificate(run.scene);
  Progress progress(console, "certify", static_cast<int>(frames.size()));
  std::vector<FrameCertificate> certificates;
  for (const int frame : frames) {
    throw_if_stopped();
    certificates.push_back(
        certify_frame(scene, read_cached_frame(run.folder.cache(), run.manifest.fingerprint, frame)));
    progress.update(static_cast<int>(certificates.size()));
  }
  return certificates;
}

void certify_run(Run& run, const Options& options, const Console& console) {
  const std::uint64_t key = certificate_key(run);
  if (run.manifest.certificate && run.manifest.certificate->key == key) return;
  const ThreadLimit limit(options.threads);
  StageTiming timing;
  {
    const StageTimer timer(timing);
    run.manifest.certificate = {key, summarize(certify_frames(run, console))};
  }
  run.manifest.stages["certify"] = timing;
  write_manifest(run.folder.manifest(), run.manifest);
  const CertificateSummary& summary = run.manifest.certificate->summary;
  if (summary.failed > 0)
    warn(console, verdict(summary) + ": 'drape verify " + run.folder.root.string() + "' shows what is wrong");
}

}  // namespace drape::app

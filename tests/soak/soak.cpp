#include "soak/soak.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/frame_certificate.h"
#include "app/start.h"
#include "core/error.h"
#include "core/file.h"
#include "scene/load.h"
#include "soak/random_scene.h"

namespace drape::soak {

static std::string fault_of(const app::FrameCertificate& certificate) {
  if (app::is_certified(certificate)) return "";
  if (!certificate.is_finite) return fmt::format("frame {}: a position is not finite", certificate.name);
  const auto words = [&](const char* surface, const app::SurfaceFigures& figures) {
    return fmt::format("frame {}: {} intersecting pairs, {} triangles in colliders, of the {} surface",
                       certificate.name, figures.intersecting_pairs, figures.collider_triangles, surface);
  };
  const app::SurfaceFigures& simulated = certificate.simulated;
  const bool is_drawn_only = simulated.intersecting_pairs == 0 && simulated.collider_triangles == 0;
  return is_drawn_only ? words("drawn", *certificate.drawn) : words("simulated", simulated);
}

static void advance(Simulation& simulation, const app::CertifiedScene& scene, Outcome& outcome) {
  const FrameStatistics statistics = simulation.advance_frame();
  const app::FrameCertificate certificate =
      certify_frame(scene, to_cached_frame(simulation.state(), simulation.input().colliders));
  ++outcome.frames;
  outcome.held_back += statistics.limited_vertices;
  outcome.largest_stretch = std::max(outcome.largest_stretch, certificate.largest_stretch);
  outcome.smallest_gap = std::min(outcome.smallest_gap, certificate.simulated.smallest_gap);
  outcome.fault = fault_of(certificate);
}

Outcome soak_scene(std::uint64_t seed, const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / fmt::format("soak_{}.yaml", seed);
  write_file(file, random_scene(seed));
  const SceneDescription scene = load_scene(file.string());
  const app::Start start = app::find_start(scene);
  Outcome outcome;
  outcome.points = static_cast<int>(start.surface.positions.size());
  outcome.smallest_gap = std::numeric_limits<double>::infinity();
  if (!app::is_clean(start.certified)) return outcome;
  Simulation simulation(app::start_input(scene, folder));
  const app::CertifiedScene certified = app::prepare_certificate(scene);
  try {
    while (outcome.fault.empty() && outcome.frames < scene.time.last_frame)
      advance(simulation, certified, outcome);
  } catch (const SimulationError& error) {
    outcome.fault = fmt::format("frame {}: {}", outcome.frames + 1, error.what());
  }
  return outcome;
}

}  // namespace drape::soak

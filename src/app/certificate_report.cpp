#include "app/certificate_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace drape::app {

// A number that is none stays one: comparisons with it are false.
static double larger(double a, double b) { return std::isnan(b) || b > a ? b : a; }
static double smaller(double a, double b) { return std::isnan(b) || b < a ? b : a; }

static void worsen(SurfaceFigures& worst, const SurfaceFigures& figures) {
  worst.intersecting_pairs = std::max(worst.intersecting_pairs, figures.intersecting_pairs);
  worst.smallest_gap = std::min(worst.smallest_gap, figures.smallest_gap);
  worst.collider_triangles = std::max(worst.collider_triangles, figures.collider_triangles);
  worst.collider_depth = std::max(worst.collider_depth, figures.collider_depth);
}

static void worsen(FrameCertificate& worst, const FrameCertificate& frame) {
  worst.is_finite = worst.is_finite && frame.is_finite;
  worst.smallest_stretch = smaller(worst.smallest_stretch, frame.smallest_stretch);
  worst.largest_stretch = larger(worst.largest_stretch, frame.largest_stretch);
  worsen(worst.simulated, frame.simulated);
  if (frame.drawn && worst.drawn) worsen(*worst.drawn, *frame.drawn);
}

CertificateSummary summarize(const std::vector<FrameCertificate>& frames) {
  CertificateSummary summary;
  summary.frames = static_cast<int>(frames.size());
  if (frames.empty()) return summary;
  summary.extremes = frames.front();
  for (const FrameCertificate& frame : frames) {
    worsen(summary.extremes, frame);
    if (!is_certified(frame)) ++summary.failed;
  }
  if (const int worst = worst_frame(frames); worst >= 0) summary.worst = frames[worst].name;
  return summary;
}

static auto badness(const FrameCertificate& frame) {
  const SurfaceFigures drawn = frame.drawn.value_or(SurfaceFigures{});
  const SurfaceFigures& simulated = frame.simulated;
  return std::make_tuple(!frame.is_finite, simulated.intersecting_pairs + simulated.collider_triangles,
                         drawn.intersecting_pairs + drawn.collider_triangles,
                         std::max(simulated.collider_depth, drawn.collider_depth));
}

int worst_frame(const std::vector<FrameCertificate>& frames) {
  int worst = -1;
  for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
    if (is_certified(frames[i])) continue;
    if (worst < 0 || badness(frames[i]) > badness(frames[worst])) worst = i;
  }
  return worst;
}

static std::string in_mm(double metres) {
  return std::isfinite(metres) ? fmt::format("{:.4g}", 1000 * metres) : "none";
}

static std::string surface_columns(const SurfaceFigures& figures) {
  const std::string depth =
      figures.collider_depth > 0 ? fmt::format(" ({} mm deep)", in_mm(figures.collider_depth)) : "";
  return fmt::format("  {:>6}  {:>8}  {:<20}", figures.intersecting_pairs, in_mm(figures.smallest_gap),
                     fmt::format("{}{}", figures.collider_triangles, depth));
}

static std::string row(const FrameCertificate& frame, std::size_t width) {
  std::string line = fmt::format("{:<{}}  {:<9}  {:<6.4f}  {:<6.4f}", frame.name, width,
                                 is_certified(frame) ? "certified" : (frame.is_finite ? "BAD" : "NOT FINITE"),
                                 frame.smallest_stretch, frame.largest_stretch);
  line += surface_columns(frame.simulated);
  if (frame.drawn) line += surface_columns(*frame.drawn);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string certificate_table(const std::vector<FrameCertificate>& frames) {
  std::size_t width = 5;
  for (const FrameCertificate& frame : frames) width = std::max(width, frame.name.size());
  std::string table =
      fmt::format("{:<{}}  {:<9}  {:<14}   pairs    gap/mm  in colliders", "frame", width, "", "stretch");
  const bool has_drawn = !frames.empty() && frames.front().drawn;
  if (has_drawn) table += "         drawn: pairs  gap/mm  in colliders";
  table += "\n";
  for (const FrameCertificate& frame : frames) table += row(frame, width);
  return table;
}

std::string verdict(const CertificateSummary& summary) {
  if (summary.failed == 0)
    return fmt::format("certified: {} frame{}", summary.frames, summary.frames == 1 ? "" : "s");
  return fmt::format("not certified: {} of {} frames, the worst is {}", summary.failed, summary.frames,
                     summary.worst);
}

}  // namespace drape::app

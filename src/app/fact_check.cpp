#include "app/fact_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include "mesh/shadow.h"
#include "scene/read_facts.h"

namespace drape::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// One frame, as far as facts are about it.
struct FactFrame {
  int number;
  const FrameStatistics& statistics;
  const FrameCertificate& certificate;
  std::vector<Vec3f> positions;
};

// In kg.
double cloth_mass(const SceneDescription& scene) {
  double mass = 0;
  for (const ClothDescription& cloth : scene.cloths)
    mass += cloth.input.material.elastic.density *
            surface_area(cloth.input.mesh.positions, cloth.input.mesh.triangles);
  return mass;
}

double smallest_gap(const FrameCertificate& certificate) {
  const double drawn = certificate.drawn ? certificate.drawn->smallest_gap : infinity;
  return std::min(certificate.simulated.smallest_gap, drawn);
}

// The points that a fact is about: where they start, and where they are.
struct Points {
  std::vector<Vec3> start;
  std::vector<Vec3> now;
};

Points points_of(const SceneDescription& scene, const std::optional<int>& cloth,
                 const std::vector<Vec3f>& positions) {
  Points points;
  std::size_t first = 0;
  for (std::size_t c = 0; c < scene.cloths.size(); ++c) {
    const std::vector<Vec3>& start = scene.cloths[c].input.start_positions;
    if (!cloth || *cloth == static_cast<int>(c)) {
      points.start.insert(points.start.end(), start.begin(), start.end());
      for (std::size_t v = first; v < first + start.size(); ++v)
        points.now.push_back(positions[v].cast<double>());
    }
    first += start.size();
  }
  return points;
}

Vec3 mean_of(const std::vector<Vec3>& points) {
  return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) /
         static_cast<double>(points.size());
}

std::pair<double, double> heights(const std::vector<Vec3>& points) {
  const auto [lowest, highest] = std::minmax_element(
      points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.y() < b.y(); });
  return {lowest->y(), highest->y()};
}

// The turn about the vertical that takes the start nearest to where the points are, each about its mean; in
// degrees from -180 to 180, from +z towards +x.
double turn_of(const Points& points) {
  const Vec3 start = mean_of(points.start), now = mean_of(points.now);
  double sine = 0, cosine = 0;
  for (std::size_t v = 0; v < points.now.size(); ++v) {
    const Vec3 a = points.start[v] - start, b = points.now[v] - now;
    sine += a.z() * b.x() - a.x() * b.z();
    cosine += a.x() * b.x() + a.z() * b.z();
  }
  return std::atan2(sine, cosine) * 180 / std::numbers::pi;
}

double value_of_place(const SceneDescription& scene, const SceneFact& fact, const FactFrame& frame) {
  const Points points = points_of(scene, fact.cloth, frame.positions);
  switch (fact.quantity) {
    case FactQuantity::lowest:
      return heights(points.now).first;
    case FactQuantity::highest:
      return heights(points.now).second;
    case FactQuantity::middle_x:
      return mean_of(points.now).x();
    case FactQuantity::middle_y:
      return mean_of(points.now).y();
    case FactQuantity::middle_z:
      return mean_of(points.now).z();
    default:
      return turn_of(points);
  }
}

double value_of(const SceneDescription& scene, const SceneFact& fact, const FactFrame& frame) {
  const FrameStatistics& statistics = frame.statistics;
  switch (fact.quantity) {
    case FactQuantity::largest_stretch:
      return frame.certificate.largest_stretch;
    case FactQuantity::p99_stretch:
      return statistics.p99_stretch;
    case FactQuantity::smallest_stretch:
      return frame.certificate.smallest_stretch;
    case FactQuantity::smallest_gap:
      return smallest_gap(frame.certificate);
    case FactQuantity::kinetic_energy:
      return statistics.kinetic_energy / cloth_mass(scene);
    case FactQuantity::largest_speed:
      return statistics.largest_speed;
    case FactQuantity::largest_lag:
      return statistics.largest_lag;
    case FactQuantity::contacts:
      return statistics.contacts;
    case FactQuantity::held_back:
      return statistics.limited_vertices;
    default:
      return value_of_place(scene, fact, frame);
  }
}

// How far within its bounds a value is; negative beyond them, and not a number for one that is none.
double room_of(const SceneFact& fact, double value) {
  return std::min(fact.most.value_or(infinity) - value, value - fact.least.value_or(-infinity));
}

std::string meaning_of(const SceneDescription& scene, const SceneFact& fact) {
  std::string text(fact_name(fact.quantity));
  if (fact.cloth) text += " of " + scene.cloths[*fact.cloth].input.name;
  text += fact.first_frame == fact.last_frame
              ? fmt::format(", frame {}", fact.first_frame)
              : fmt::format(", frames {} to {}", fact.first_frame, fact.last_frame);
  if (fact.least) text += fmt::format(", at least {:.6g}", *fact.least);
  if (fact.most) text += fmt::format(", at most {:.6g}", *fact.most);
  return text;
}

void look_at(const SceneDescription& scene, const FactFrame& frame, FactResult& result) {
  const SceneFact& fact = result.fact;
  if (frame.number < fact.first_frame || frame.number > fact.last_frame) return;
  const double value = value_of(scene, fact, frame), room = room_of(fact, value);
  result.holds = result.holds && room >= 0;
  if (result.found && room >= room_of(fact, *result.found)) return;
  result.found = value;
  result.frame = frame.number;
}

}  // namespace

std::vector<FactResult> check_facts(const Run& run, const std::vector<int>& numbers,
                                    const std::vector<FrameCertificate>& certificates) {
  std::vector<FactResult> results;
  for (const SceneFact& fact : run.scene.facts)
    results.push_back({fact, meaning_of(run.scene, fact), std::nullopt, 0, true});
  if (results.empty()) return results;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const FactFrame frame{
        numbers[i], run.manifest.frames.at(numbers[i]).statistics, certificates[i],
        read_cached_frame(run.folder.cache(), run.manifest.fingerprint, numbers[i]).positions};
    for (FactResult& result : results) look_at(run.scene, frame, result);
  }
  return results;
}

std::string fact_table(const std::vector<FactResult>& results) {
  std::string table;
  for (const FactResult& result : results) {
    const std::string found = result.found
                                  ? fmt::format("found {:.6g} in frame {}", *result.found, result.frame)
                                  : "its frames were not looked at";
    const char* word = !result.found ? "not tested" : result.holds ? "holds" : "FAILS";
    table += fmt::format("{:<10}  {}: {}\n", word, result.meaning, found);
  }
  return table;
}

}  // namespace drape::app

#include "deformation/seams.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/same_time.h"
#include "deformation/coloring.h"

namespace drape {

SeamStage build_seams(int vertex_count, const std::vector<Seam>& seams) {
  std::vector<std::array<int, 2>> vertices;
  for (const Seam& seam : seams) vertices.push_back(seam.vertices);
  Coloring coloring = color_elements(vertex_count, vertices);
  SeamStage stage{{}, std::move(coloring.color_begin)};
  for (const int i : coloring.order) stage.seams.push_back(seams[i]);
  return stage;
}

double thread_length(const Seam& seam, double start_length, double time) {
  const double share = std::min(1.0, (time - seam.from) / (seam.close - seam.from));
  return start_length + share * (seam.gap - start_length);
}

void start_seams(const SeamStage& stage, double time, const std::vector<Vec3>& x,
                 std::vector<double>& start_lengths) {
  start_lengths.resize(stage.seams.size(), 0.0);
  for (std::size_t i = 0; i < stage.seams.size(); ++i) {
    const auto& [a, b] = stage.seams[i].vertices;
    if (std::abs(time - stage.seams[i].from) < same_time) start_lengths[i] = (x[a] - x[b]).norm();
  }
}

static void pull_seam(const Seam& seam, double length, const std::vector<double>& inverse_masses,
                      std::vector<Vec3>& x) {
  const auto& [a, b] = seam.vertices;
  const double response = inverse_masses[a] + inverse_masses[b];
  const Vec3 way = x[b] - x[a];
  const double distance = way.norm();
  if (!(response > 0 && distance > length)) return;
  const Vec3 pull = (distance - length) / (distance * response) * way;
  x[a] += inverse_masses[a] * pull;
  x[b] -= inverse_masses[b] * pull;
}

void pull_seams(const SeamStage& stage, const std::vector<double>& start_lengths,
                const std::vector<double>& inverse_masses, double time, std::vector<Vec3>& x) {
  constexpr std::size_t block = 256;
  for (std::size_t color = 0; color + 1 < stage.color_begin.size(); ++color) {
    const std::size_t begin = stage.color_begin[color];
    parallel_for_each(stage.color_begin[color + 1] - begin, block, [&](std::size_t i) {
      const Seam& seam = stage.seams[begin + i];
      if (time < seam.from + same_time) return;
      pull_seam(seam, thread_length(seam, start_lengths[begin + i], time), inverse_masses, x);
    });
  }
}

}  // namespace drape

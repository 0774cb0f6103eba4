#include "simulation/sewing.h"

namespace drape {

SeamStage sew(const SimulationInput& input, const ContactGeometry& geometry) {
  std::vector<Seam> threads;
  for (const SeamInput& seam : input.seams) {
    const auto& [a, b] = seam.cloths;
    const double gap = largest_thickness(geometry, a, b);
    const int first_a = geometry.bodies[a].vertex_begin, first_b = geometry.bodies[b].vertex_begin;
    for (std::size_t i = 0; i < seam.vertices[0].size(); ++i)
      threads.push_back(
          {{first_a + seam.vertices[0][i], first_b + seam.vertices[1][i]}, gap, seam.from, seam.close});
  }
  return build_seams(static_cast<int>(geometry.vertex_body.size()), threads);
}

}  // namespace drape

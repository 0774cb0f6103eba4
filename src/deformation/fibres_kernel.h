#pragma once

#include "deformation/fibres.h"

// The arithmetic of fibres.h for one group, as eight lanes (Number = Lanes) or one of them (float).
namespace drape {

// Rows of scratch a vertex: the edge that ends there. Its unit vector, then inverse pivot, tension and coupling.
constexpr std::size_t fibre_work_rows = 6;

// The tridiagonal system, eliminated downward as it is set up.
template <typename Number>
void eliminate(const FibreStage& stage, FibreScratch& scratch, std::size_t first, std::size_t end,
               const LaneAccess<Number>& access, const Point4* offsets) {
  LanePoint<Number> a = access.gather(offsets, stage.vertices[first]);
  LaneVec3<Number> before{Number(0), Number(0), Number(0)};
  Number pivot_before(0), tension_before(0);
  for (std::size_t row = first + 1; row < end; ++row) {
    const LanePoint<Number> b = access.gather(offsets, stage.vertices[row]);
    const LaneRow* base = &scratch.base[3 * row];
    const LaneVec3<Number> edge =
        LaneVec3<Number>{access.load(base[0]), access.load(base[1]), access.load(base[2])} + (b.p - a.p);
    const Number length = square_root(dot(edge, edge));
    const Number inverse_length = where_positive(length, Number(1) / length, Number(0));
    const LaneVec3<Number> direction = inverse_length * edge;
    const Number beyond = length - access.load(stage.longest[row]);
    const Number compliance = where_positive(beyond, Number(0), access.load(stage.compliances[row]));
    const Number excess = where_positive(beyond, beyond, length - access.load(stage.rest_lengths[row]));
    const Number coupling = -(a.w * dot(before, direction));
    const Number factor = coupling * pivot_before;
    const Number diagonal = subtract_product(factor, coupling, (a.w + b.w) + compliance);
    const Number pivot = where_positive(diagonal, Number(1) / diagonal, Number(0));
    const Number tension = subtract_product(factor, tension_before, excess);
    LaneRow* work = &scratch.work[fibre_work_rows * row];
    const Number values[fibre_work_rows] = {direction.x, direction.y, direction.z, pivot, tension, coupling};
    for (std::size_t i = 0; i < fibre_work_rows; ++i) access.store(work[i], values[i]);
    a = b;
    before = direction;
    pivot_before = pivot;
    tension_before = tension;
  }
}

// Substitutes back, and moves each vertex by the tensions of its two edges.
template <typename Number>
void apply_tensions(const FibreStage& stage, FibreScratch& scratch, std::size_t first, std::size_t end,
                    const LaneAccess<Number>& access, Point4* offsets) {
  LaneVec3<Number> pull_after{Number(0), Number(0), Number(0)};
  Number tension_after(0), coupling_after(0);
  for (std::size_t row = end; row-- > first;) {
    LaneVec3<Number> pull{Number(0), Number(0), Number(0)};
    if (row > first) {
      const LaneRow* work = &scratch.work[fibre_work_rows * row];
      const Number tension =
          subtract_product(coupling_after, tension_after, access.load(work[4])) * access.load(work[3]);
      pull = tension * LaneVec3<Number>{access.load(work[0]), access.load(work[1]), access.load(work[2])};
      tension_after = tension;
      coupling_after = access.load(work[5]);
    }
    LanePoint<Number> point = access.gather(offsets, stage.vertices[row]);
    point.p = multiply_add(point.w, pull_after - pull, point.p);
    access.scatter(offsets, stage.vertices[row], point);
    pull_after = pull;
  }
}

template <typename Number>
[[gnu::flatten]] void pull_fibre_group(const FibreStage& stage, FibreScratch& scratch, std::size_t group,
                      const LaneAccess<Number>& access, Point4* offsets) {
  const std::size_t first = stage.row_begin[group], end = stage.row_begin[group + 1];
  eliminate(stage, scratch, first, end, access, offsets);
  apply_tensions(stage, scratch, first, end, access, offsets);
}

}  // namespace drape

#pragma once

#include "deformation/fibres.h"
#include "deformation/membrane_kernel.h"

// The arithmetic of fibres.h for one group, as eight lanes (Number = Lanes) or one of them (float).
namespace drape {

template <typename Number>
[[gnu::flatten]] void load_fibre_group(const FibreStage& stage, const SplitPoints& start, std::size_t group,
                                       const LaneAccess<Number>& access, std::vector<LaneRow>& base) {
  const std::size_t first = stage.row_begin[group];
  SplitPoint<Number> a = gather(access, start, stage.vertices[first]);
  for (std::size_t row = first; row < stage.row_begin[group + 1]; ++row) {
    const SplitPoint<Number> b = gather(access, start, stage.vertices[row]);
    store_vector(access, b - a, &base[3 * row]);
    a = b;
  }
}

// Rows of scratch a vertex: the point; of the edge that ends there its unit vector, inverse pivot, tension
// and coupling.
struct FibreWork {
  static constexpr std::size_t point = 0, inverse_mass = 3, direction = 4, pivot = 7, tension = 8,
                               coupling = 9;
};
constexpr std::size_t fibre_work_rows = 10;

template <typename Number>
struct FibreEdge {
  LaneVec3<Number> direction;
  Number compliance, excess;
};

template <typename Number>
FibreEdge<Number> fibre_edge(const FibreStage& stage, std::size_t row, const LaneAccess<Number>& access,
                             const LaneVec3<Number>& edge) {
  const Number length = square_root(dot(edge, edge));
  const Number inverse_length = where_positive(length, Number(1) / length, Number(0));
  const Number beyond = length - access.load(stage.longest[row]);
  return {inverse_length * edge, where_positive(beyond, Number(0), access.load(stage.compliances[row])),
          where_positive(beyond, beyond, length - access.load(stage.rest_lengths[row]))};
}

template <typename Number>
void store_point(const LaneAccess<Number>& access, const LanePoint<Number>& point, LaneRow* work) {
  store_vector(access, point.p, work + FibreWork::point);
  access.store(work[FibreWork::inverse_mass], point.w);
}

// The tridiagonal system, eliminated downward as it is set up.
template <typename Number>
void eliminate(const FibreStage& stage, const std::vector<LaneRow>& base, std::size_t first, std::size_t end,
               const LaneAccess<Number>& access, LaneRow* work, const Point4* offsets) {
  LanePoint<Number> a = access.gather(offsets, stage.vertices[first]);
  store_point(access, a, work);
  LaneVec3<Number> before{Number(0), Number(0), Number(0)};
  Number pivot_before(0), tension_before(0);
  for (std::size_t row = first + 1; row < end; ++row) {
    work += fibre_work_rows;
    const LanePoint<Number> b = access.gather(offsets, stage.vertices[row]);
    store_point(access, b, work);
    const FibreEdge<Number> edge =
        fibre_edge(stage, row, access, load_vector(access, &base[3 * row]) + (b.p - a.p));
    const Number coupling = -(a.w * dot(before, edge.direction));
    const Number factor = coupling * pivot_before;
    const Number diagonal = subtract_product(factor, coupling, (a.w + b.w) + edge.compliance);
    pivot_before = where_positive(diagonal, Number(1) / diagonal, Number(0));
    tension_before = subtract_product(factor, tension_before, edge.excess);
    store_vector(access, edge.direction, work + FibreWork::direction);
    access.store(work[FibreWork::pivot], pivot_before);
    access.store(work[FibreWork::tension], tension_before);
    access.store(work[FibreWork::coupling], coupling);
    a = b;
    before = edge.direction;
  }
}

// Substitutes back, and moves each vertex by the tensions of its two edges.
template <typename Number>
void apply_tensions(const FibreStage& stage, std::size_t first, std::size_t end,
                    const LaneAccess<Number>& access, const LaneRow* work, Point4* offsets) {
  LaneVec3<Number> pull_after{Number(0), Number(0), Number(0)};
  Number tension_after(0), coupling_after(0);
  const auto move = [&](std::size_t row, const LaneRow* of, const LaneVec3<Number>& pull) {
    const LaneVec3<Number> p = load_vector(access, of + FibreWork::point);
    const Number w = access.load(of[FibreWork::inverse_mass]);
    access.scatter(offsets, stage.vertices[row], LanePoint<Number>{multiply_add(w, pull_after - pull, p), w});
  };
  for (std::size_t row = end - 1; row > first; --row) {
    const LaneRow* of = work + fibre_work_rows * (row - first);
    const Number tension =
        subtract_product(coupling_after, tension_after, access.load(of[FibreWork::tension])) *
        access.load(of[FibreWork::pivot]);
    const LaneVec3<Number> pull = tension * load_vector(access, of + FibreWork::direction);
    move(row, of, pull);
    pull_after = pull;
    tension_after = tension;
    coupling_after = access.load(of[FibreWork::coupling]);
  }
  move(first, work, {Number(0), Number(0), Number(0)});
}

template <typename Number>
[[gnu::flatten]] void pull_fibre_group(const FibreStage& stage, const std::vector<LaneRow>& base,
                                       std::size_t group, const LaneAccess<Number>& access, LaneRow* work,
                                       Point4* offsets) {
  const std::size_t first = stage.row_begin[group], end = stage.row_begin[group + 1];
  eliminate(stage, base, first, end, access, work, offsets);
  apply_tensions(stage, first, end, access, work, offsets);
}

}  // namespace drape

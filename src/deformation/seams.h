#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/vector.h"

namespace drape {

// A thread between two vertices that is drawn in from a time on until they are as near as the gap. It pulls
// and never pushes: how near they may come is for contact to say.
struct Seam {
  std::array<int, 2> vertices;
  double gap;    // m
  double from;   // seconds: its length then is the one that it has
  double close;  // seconds, after `from`: its length is the gap from then on
};

struct SeamStage {
  std::vector<Seam> seams;  // colour by colour
  std::vector<std::size_t> color_begin;
};

SeamStage build_seams(int vertex_count, const std::vector<Seam>& seams);

// The length in m that a thread has at `time` (s), linear between its two times. Needs a time not before
// `from`.
double thread_length(const Seam& seam, double start_length, double time);

// Records the lengths of the seams of which the time `from` has come. To be called at the start of each
// frame.
void start_seams(const SeamStage& stage, double time, const std::vector<Vec3>& x,
                 std::vector<double>& start_lengths);

// One Gauss-Seidel sweep of threads that do not give (the implicit step of a spring whose stiffness has no
// bound). Keeps linear and angular momentum; vertices of inverse mass 0 stay. `start_lengths` are those that
// start_seams recorded.
void pull_seams(const SeamStage& stage, const std::vector<double>& start_lengths,
                const std::vector<double>& inverse_masses, double time, std::vector<Vec3>& x);

}  // namespace drape

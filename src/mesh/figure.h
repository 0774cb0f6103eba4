#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/vector.h"

namespace drape {

// A body as files of animation hold it: surfaces that hang on a tree of nodes, or are drawn along by several
// of them (skinned). All matrices act on columns.

// Values at times, in seconds that never fall: linear in between (turns on the shortest great circle),
// constant outside. At least one.
template <typename Value>
struct TimedValues {
  std::vector<double> times;
  std::vector<Value> values;
};

// How a node moves against its parent.
struct NodeMotion {
  TimedValues<Vec3> place;
  TimedValues<Quaternion> turn;
  TimedValues<Vec3> scale;
};

struct FigureNode {
  int parent;             // an earlier one; -1: none
  int motion;             // an index; -1: none
  Mat4 rest;              // to its parent, where no motion says so
  std::string name = {};  // for messages
};

struct Bone {
  Mat4 from_surface;  // where the surface's points are to the node, as modelled
  int node;
  std::vector<std::pair<int, double>> shares;  // of the surface's points: which, and how much of it
};

struct FigureSurface {
  int node;  // that it hangs on, and all its points that no bone has a share in
  std::vector<Vec3> points;
  std::vector<Bone> bones;
};

struct Figure {
  std::vector<FigureNode> nodes;
  std::vector<NodeMotion> motions;
  std::vector<FigureSurface> surfaces;
};

// Where the points of all surfaces are at a time: linear blend skinning, each point drawn along by its bones
// by their shares.
std::vector<Vec3> pose_figure(const Figure& figure, double time);

}  // namespace drape

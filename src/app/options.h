#pragma once

#include <string>
#include <vector>

namespace drape::app {

enum class Command {
  run,
  simulate,
  render,
  encode,
  still,
  validate,
  info,
  export_geometry,
  measure,
  verify,
  diff
};
enum class ProgressStyle { automatic, bar, lines, json, none };
enum class UseColor { automatic, always, never };
enum class GeometryFormat { obj, ply };

// One of `count` equal parts of a job, counted from 1.
struct Chunk {
  int index = 1;
  int count = 1;
};

struct DiffOptions {
  int tolerance = 1;     // in steps of 1/255
  double share = 0.002;  // of the pixels that may differ by more
  std::string heat;      // where to write the heat map, or the folder of heat maps; empty: nowhere
};

// What was typed, as plain values.
struct Options {
  Command command = Command::run;
  std::vector<std::string> inputs;     // scene files, run folders; pictures for diff, meshes for verify
  std::string output;                  // empty: the default of the command
  std::vector<std::string> overrides;  // key.path=value
  std::string frames;                  // as typed ("1-100x5"); empty: all of the scene
  Chunk chunk;
  int threads = 0;         // 0: one a core
  bool resume = false;     // take over what another build of the program made
  bool overwrite = false;  // make everything anew
  int verbosity = 0;       // -1 quiet, 0 normal, 1 with details
  ProgressStyle progress = ProgressStyle::automatic;
  UseColor color = UseColor::automatic;
  std::string statistics_file;  // empty: none
  GeometryFormat format = GeometryFormat::obj;
  bool with_colliders = false;
  bool as_json = false;   // results for programs
  std::string rest_file;  // for verify: the mesh whose edges are unstretched; empty: found by itself
  DiffOptions diff;
};

}  // namespace drape::app

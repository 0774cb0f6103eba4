// The kernels as eight lanes against the same kernels as floats, one lane after the other: equal to the last
// bit.

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "core/parallel.h"
#include "deformation/bending_kernel.h"
#include "deformation/elastic_model.h"
#include "deformation/fibres_kernel.h"
#include "mesh/primitives.h"

namespace drape {
namespace {

// Numbers that are the same in every run.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
  }
  Vec3 vector(double size) {
    const double x = between(-size, size), y = between(-size, size);
    return {x, y, between(-size, size)};
  }

 private:
  std::mt19937 engine_;
};

// An irregular sheet with edges of about one tenth of a metre.
TriangleMesh jittered_grid(int points) {
  Random random(1);
  TriangleMesh mesh = make_grid({0.1 * (points - 1), 0.1 * (points - 1)}, {points, points});
  for (Vec3& x : mesh.positions) x += Vec3(random.between(-0.03, 0.03), 0, random.between(-0.03, 0.03));
  return mesh;
}

Sheet sheet_of(const TriangleMesh& mesh) {
  Sheet sheet{mesh.positions, mesh.triangles,  std::vector<int>(mesh.triangles.size(), 0),
              {{}},           {Vec3(1, 0, 0)}, {}};
  sheet.topology = build_topology(static_cast<int>(mesh.positions.size()), mesh.triangles);
  return sheet;
}

struct Case {
  Sheet sheet;
  ElasticModel model;
  ElasticScratch scratch;
};

Case loaded(TriangleMesh mesh, double height, void (*disturb)(std::vector<Vec3>&)) {
  Random random(7);
  for (Vec3& x : mesh.positions) x.y() += random.between(-height, height);
  Case made{sheet_of(mesh), {}, {}};
  made.sheet.materials[0].strain_limit = 0.02;
  const std::vector<double> masses = lumped_masses(made.sheet);
  std::vector<char> pinned(masses.size(), 0);
  pinned[0] = pinned[5] = 1;
  made.model = build_elastic_model(made.sheet, masses, pinned, 9.81, 0.0025);
  std::vector<Vec3> start = mesh.positions;
  for (Vec3& x : start) x += random.vector(0.01);
  disturb(start);
  load_elastic(made.model, start, made.scratch);
  made.scratch.offsets = made.scratch.velocities = made.model.inverse_masses;
  for (std::size_t v = 0; v < start.size(); ++v) {
    const auto small = [&] { return static_cast<float>(random.between(-1e-4, 1e-4)); };
    made.scratch.offsets[v] = {small(), small(), small(), made.scratch.offsets[v].w};
    made.scratch.velocities[v] = {small(), small(), small(), made.scratch.velocities[v].w};
  }
  return made;
}

bool same_bits(const std::vector<Point4>& a, const std::vector<Point4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point4)) == 0;
}

bool moved(const std::vector<Point4>& before, const std::vector<Point4>& after) {
  return !same_bits(before, after);
}

// body(rows, access) for every tile of a sweep, and every lane of it.
template <typename Body>
void sweep_floats(const SweepOrder& order, const Body& body) {
  for (std::size_t tile = 0; tile + 1 < order.tile_begin.size(); ++tile)
    for (int lane = 0; lane < Lanes::count; ++lane)
      body(RowRange{order.tile_begin[tile], order.tile_begin[tile + 1]}, LaneAccess<float>{lane});
}

void expect_twins(const Case& made) {
  const ElasticModel& model = made.model;
  ElasticScratch lanes = made.scratch, floats = made.scratch;

  damp_bending(model.bending, lanes.velocities);
  sweep_floats(model.bending.order, [&](const RowRange& rows, const LaneAccess<float>& access) {
    damp_bending_tile<float>(model.bending, rows, access, floats.velocities.data());
  });
  EXPECT_TRUE(same_bits(lanes.velocities, floats.velocities)) << "damping of bending";
  damp_membrane(model.membrane, lanes.membrane_base, lanes.velocities);
  sweep_floats(model.membrane.order, [&](const RowRange& rows, const LaneAccess<float>& access) {
    damp_membrane_tile<float>(model.membrane, floats.membrane_base, rows, access, floats.velocities.data());
  });
  EXPECT_TRUE(same_bits(lanes.velocities, floats.velocities)) << "damping of the membrane";
  EXPECT_TRUE(moved(made.scratch.velocities, lanes.velocities));

  std::vector<Point4> before = lanes.offsets;
  pull_bending(model.bending, lanes.bending_base, lanes.offsets);
  sweep_floats(model.bending.order, [&](const RowRange& rows, const LaneAccess<float>& access) {
    pull_bending_tile<float>(model.bending, floats.bending_base, rows, access, floats.offsets.data());
  });
  EXPECT_TRUE(same_bits(lanes.offsets, floats.offsets)) << "bending";
  EXPECT_TRUE(moved(before, lanes.offsets)) << "bending";

  before = lanes.offsets;
  pull_fibres(model.fibres, lanes.fibres, lanes.offsets);
  for (std::size_t group = 0; group + 1 < model.fibres.row_begin.size(); ++group)
    for (int lane = 0; lane < Lanes::count; ++lane)
      pull_fibre_group<float>(model.fibres, floats.fibres.base, group, {lane}, floats.fibres.work.data(),
                              floats.offsets.data());
  EXPECT_TRUE(same_bits(lanes.offsets, floats.offsets)) << "fibres";
  EXPECT_TRUE(moved(before, lanes.offsets)) << "fibres";

  before = lanes.offsets;
  pull_membrane(model.membrane, lanes.membrane_base, lanes.offsets);
  sweep_floats(model.membrane.order, [&](const RowRange& rows, const LaneAccess<float>& access) {
    pull_membrane_tile<float>(model.membrane, floats.membrane_base, rows, access, floats.offsets.data());
  });
  EXPECT_TRUE(same_bits(lanes.offsets, floats.offsets)) << "membrane";
  EXPECT_TRUE(moved(before, lanes.offsets)) << "membrane";
  for (const Point4& x : lanes.offsets) ASSERT_TRUE(std::isfinite(x.x + x.y + x.z));
}

void leave(std::vector<Vec3>&) {}

TEST(LanesTwin, FlatSheet) {
  const Case made = loaded(jittered_grid(23), 0, leave);
  EXPECT_FALSE(made.model.bending.curved);
  expect_twins(made);
}

TEST(LanesTwin, CurvedSheet) {
  const Case made = loaded(jittered_grid(23), 0.02, leave);
  EXPECT_TRUE(made.model.bending.curved);
  expect_twins(made);
}

TEST(LanesTwin, ManyPatches) { expect_twins(loaded(jittered_grid(60), 0.01, leave)); }

TEST(LanesTwin, CollinearTriangles) {
  Case made = loaded(jittered_grid(23), 0, [](std::vector<Vec3>& start) {
    for (Vec3& x : start) x.z() = x.x();
    for (Vec3& x : start) x.y() = 0;
  });
  for (Point4& x : made.scratch.offsets) x = {0, 0, 0, x.w};
  expect_twins(made);
}

TEST(LanesTwin, CollapsedTriangles) {
  Case made = loaded(jittered_grid(23), 0, [](std::vector<Vec3>& start) {
    for (std::size_t v = 100; v < 300; ++v) start[v] = start[100];
  });
  for (Point4& x : made.scratch.offsets) x = {0, 0, 0, x.w};
  expect_twins(made);
}

TEST(LanesTwin, AnyNumberOfThreads) {
  std::vector<std::vector<Point4>> ends;
  for (const int threads : {1, 2, 3}) {
    const ThreadLimit limit(threads);
    Case made = loaded(jittered_grid(60), 0.01, leave);
    for (int pass = 0; pass < 3; ++pass) pull_to_goals(made.model, made.scratch);
    ends.push_back(made.scratch.offsets);
  }
  EXPECT_TRUE(same_bits(ends[0], ends[1]) && same_bits(ends[0], ends[2]));
}

}  // namespace
}  // namespace drape

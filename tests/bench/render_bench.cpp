#include <benchmark/benchmark.h>

#include <cmath>

#include "mesh/loop_subdivision.h"
#include "mesh/primitives.h"
#include "render/png_file.h"
#include "render/rasterizer.h"

// What a frame of 1280 x 720 costs: a waved cloth of 12 thousand triangles over a ball, on the ground.
namespace drape::render {
namespace {

Surface make_surface(const TriangleMesh& mesh) {
  Surface surface;
  for (const Vec3& position : mesh.positions) surface.positions.push_back(position.cast<float>());
  surface.normals = vertex_normals(surface.positions, mesh.triangles);
  surface.triangles = mesh.triangles;
  return surface;
}

Surface make_cloth() {
  TriangleMesh grid = make_grid({2, 1.6}, {78, 78});
  for (Vec3& p : grid.positions) {
    p.y() = 0.75 + 0.09 * std::sin(5 * p.x() + 1.5 * std::sin(2 * p.z())) + 0.05 * std::sin(9 * p.z());
  }
  Surface cloth = make_surface(grid);
  cloth.two_sided = true;
  return cloth;
}

Surface make_ball() {
  TriangleMesh mesh = make_sphere(0.3, 48, 24);
  for (Vec3& position : mesh.positions) position.y() += 0.3;
  Surface ball = make_surface(mesh);
  ball.material.translucency = 0;
  return ball;
}

View make_view() {
  View view;
  view.camera.eye = {1.6f, 1.5f, 2.2f};
  view.camera.target = {0, 0.5f, 0};
  view.ground.visible = true;
  return view;
}

void draw_frame(benchmark::State& state) {
  const std::vector<Surface> surfaces = {make_cloth(), make_ball()};
  const Settings settings{1280, 720, static_cast<int>(state.range(0))};
  Rasterizer rasterizer;
  rasterizer.draw(surfaces, make_view(), {64, 36, 1});  // compiles the shaders
  for (auto _ : state) benchmark::DoNotOptimize(rasterizer.draw(surfaces, make_view(), settings));
}
BENCHMARK(draw_frame)->ArgName("passes")->Arg(2)->Arg(6)->Arg(32)->Unit(benchmark::kMillisecond);

void start(benchmark::State& state) {
  const std::vector<Surface> surfaces = {make_cloth(), make_ball()};
  for (auto _ : state) {
    Rasterizer rasterizer;
    benchmark::DoNotOptimize(rasterizer.draw(surfaces, make_view(), {64, 36, 1}));
  }
}
BENCHMARK(start)->Unit(benchmark::kMillisecond);

void write_frame(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / "drape_render_bench.png";
  const Image image = Rasterizer().draw({make_cloth(), make_ball()}, make_view(), {1280, 720, 4});
  for (auto _ : state) write_png(path, image);
  std::filesystem::remove(path);
}
BENCHMARK(write_frame)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace drape::render

int main(int argc, char** argv) {
  drape::render::configure_software_rendering(1);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

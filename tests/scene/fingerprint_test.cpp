#include <gtest/gtest.h>

#include <set>

#include "scene/scene_text.h"

namespace drape {

static const std::string scene_text =
    "version: 1\n"
    "cloths: {a: {grid: {size: [1, 1], points: [3, 3]}, pins: [{corner: [-x, -z]}]}}\n"
    "colliders: {c: {sphere: {radius: 1}}}\n";

TEST(Fingerprint, ChangesWithAllThatTheMotionDependsOn) {
  const std::vector<std::string> changes = {"time.fps=31",
                                            "time.step=1 ms",
                                            "simulation.gravity=[0, -9.8, 0]",
                                            "simulation.model=averaged",
                                            "simulation.alpha=0.5",
                                            "simulation.wind.velocity=[0, 0, 1]",
                                            "simulation.wind.drag=2",
                                            "simulation.wind.gust=0.1",
                                            "simulation.wind.gust_size=3",
                                            "simulation.wind.seed=3",
                                            "simulation.wind.tangential_drag=0.1",
                                            "simulation.wind.lift=0.1",
                                            "simulation.self_collision=false",
                                            "simulation.sleep=false",
                                            "cloths.a.grid.size=[1, 2]",
                                            "cloths.a.grid.points=[3, 4]",
                                            "cloths.a.place.at=[0, 1, 0]",
                                            "cloths.a.material.density=0.3",
                                            "cloths.a.material.thickness=0.006",
                                            "cloths.a.material.stretch=6000",
                                            "cloths.a.material.bend=0.001",
                                            "cloths.a.material.damping=3 ms",
                                            "cloths.a.material.shear=60",
                                            "cloths.a.material.poisson=0.3",
                                            "cloths.a.material.strain_limit=0.1",
                                            "cloths.a.material.warp=[0,0,1]",
                                            "cloths.a.material.bend=[1e-5,2e-5]",
                                            "cloths.a.material.friction=0.4",
                                            "cloths.a.pins=[]",
                                            "cloths.a.pins.0.corner=[+x, -z]",
                                            "cloths.a.pins.0.until=5",
                                            "cloths.a.pins.0.from=5",
                                            "cloths.a.pins.0.follow=c",
                                            "cloths.a.pins.0.animate={rotate_y: [[0, 0], [1, 1]]}",
                                            "colliders={}",
                                            "colliders.c.sphere.radius=2",
                                            "colliders.c={box: {size: [1, 1, 1]}}",
                                            "colliders.c={cylinder: {radius: 1, height: 1}}",
                                            "colliders.c={cylinder: {radius: 1, height: 2}}",
                                            "colliders.c={cylinder: {radius: 2, height: 1}}",
                                            "colliders.c.friction=0.5",
                                            "colliders.c.place.rotate=[0, 0, 1]",
                                            "colliders.c.animate.translate=[[0, [0, 0, 0]], [1, [0, 1, 0]]]"};
  std::set<std::uint64_t> fingerprints = {simulation_fingerprint(load_text(scene_text))};
  for (const std::string& change : changes)
    EXPECT_TRUE(fingerprints.insert(simulation_fingerprint(load_text(scene_text, {change}))).second)
        << change;
}

TEST(Fingerprint, ChangesWithTheSeams) {
  const std::string seams =
      "seams: [{between: [{cloth: a, edge: -x}, {cloth: a, edge: +x, reverse: false}], from: 0, close: 9}]\n";
  std::set<std::uint64_t> fingerprints = {simulation_fingerprint(load_text(scene_text))};
  for (const std::string change :
       {"name=same", "seams.0.from=2", "seams.0.close=10", "seams.0.between.1.reverse=true",
        "seams.0.between.0={cloth: a, edge: -z}"})
    EXPECT_TRUE(fingerprints.insert(simulation_fingerprint(load_text(scene_text + seams, {change}))).second)
        << change;
}

TEST(Fingerprint, ChangesWithThePressureOfAClosedCloth) {
  const auto scene = std::filesystem::path(DRAPE_SOURCE_DIR) / "tests/scene/bad/pressure.yaml";
  const auto with_pressure = [&](const std::string& pressure) {
    return simulation_fingerprint(
        load_scene(scene, {"cloths.napkin.pressure=0", "cloths.cushion.pressure=" + pressure}));
  };
  EXPECT_NE(with_pressure("1 hPa"), with_pressure("2 hPa"));
}

TEST(Fingerprint, IsTheSameForWhatIsOnlyDrawn) {
  const auto fingerprint = simulation_fingerprint(load_text(scene_text));
  for (const std::string change :
       {"name=other", "time.frames=1-5", "cloths.a.look={color: '#fff', subdivide: 2}",
        "colliders.c.visible=false", "camera.fov=20", "render.resolution=[64, 64]", "lights=[]"})
    EXPECT_EQ(simulation_fingerprint(load_text(scene_text, {change})), fingerprint) << change;
}

}  // namespace drape

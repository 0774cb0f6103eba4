#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/rigid_motion.h"
#include "render/view.h"
#include "scene/node.h"
#include "simulation/input.h"

namespace drape {

// A scene file as plain values: every key of the file, read, ranged and defaulted. Nothing is built yet.

struct TimeSettings {
  double fps = 30;
  int first_frame = 1;
  int last_frame = 90;
  double step = 0.002;  // seconds
};

struct Look {
  render::Material material;
  int subdivide = 0;  // levels of Loop subdivision, 0 to 3
};

struct ClothDescription {
  Place place;  // where it stands in the text
  ClothInput input;
  Look look;
};

// What is solid lets no light through and has no fibres that scatter it.
inline Look solid_look() {
  const render::Color gray{0.72f, 0.71f, 0.70f};
  Look look;
  look.material.color = gray;
  look.material.back = gray;
  look.material.sheen = 0;
  look.material.translucency = 0;
  return look;
}

struct ColliderDescription {
  ColliderInput input;
  Look look = solid_look();
  bool visible = true;
};

struct CameraDescription {
  Vec3 at{2.5, 1.5, 2.5};
  Vec3 look_at{0, 0, 0};
  double field_of_view = 35;  // degrees, vertical
  // Where it is present, `at` is not used: a circle about the vertical through look_at.
  struct Orbit {
    double radius = 3;
    double height = 1.5;  // over look_at
    double start = 30;    // degrees from +z towards +x
    double turns = 0;     // over all frames of the scene
  };
  std::optional<Orbit> orbit;
};

enum class Quality { draft, preview, final };

struct RenderDescription {
  int width = 1280;
  int height = 720;
  Quality quality = Quality::preview;
  int crf = 18;  // of the video
  double exposure = 1;
  render::Color backdrop{0.86f, 0.87f, 0.89f};
};

// Cusick's drape test: a piece of cloth hangs over the edge of a round table.
struct DrapeTest {
  int cloth = 0;    // of the scene's cloths; its area is larger than that of the support's end
  int support = 0;  // of the scene's colliders; its shape is a CylinderShape
};

// What the frames of a scene can be held to; scenes/reference.yaml says what each is, and in what unit.
enum class FactQuantity {
  largest_stretch,
  p99_stretch,
  smallest_stretch,
  smallest_gap,
  kinetic_energy,
  largest_speed,
  largest_lag,
  contacts,
  held_back,
  lowest,
  highest,
  middle_x,
  middle_y,
  middle_z,
  turn
};

// What a scene must show in each of the frames: a quantity between two bounds.
struct SceneFact {
  FactQuantity quantity{};
  int first_frame = 1, last_frame = 1;
  std::optional<int> cloth;  // of the scene's cloths, for what is said of places; nothing: of all together
  std::optional<double> least, most;  // at least one of them
};

struct SceneDescription {
  std::string file;  // as the user named it
  std::string name;  // one line without /, at most 100 bytes
  TimeSettings time;
  DeformationModel model = DeformationModel::shape_matching;
  double alpha = 1;  // of the averaged model
  Vec3 gravity{0, -9.81, 0};
  WindInput wind;
  bool self_collision = true;
  bool sleep = true;
  bool fail_safe = true;  // no key sets it: see SimulationInput
  std::vector<ClothDescription> cloths;
  std::vector<ColliderDescription> colliders;
  std::vector<SeamInput> seams;
  CameraDescription camera;
  std::optional<DrapeTest> drape_test;
  std::vector<SceneFact> facts;
  render::Sun sun;
  render::Sky sky;
  RenderDescription render;
};

}  // namespace drape

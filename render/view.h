#pragma once

#include <cstdint>
#include <vector>

#include "core/vector.h"
#include "mesh/triangle_mesh.h"

namespace drape::render {

// Colours are sRGB in [0, 1], as people write them; the shaders make them linear.
using Color = Vec3f;

enum class Pattern { plain, checker, stripe, tartan };

struct Material {
  Color color{0.70f, 0.20f, 0.18f};
  Color back{0.70f, 0.20f, 0.18f};    // the colour of the other side
  Color accent{0.93f, 0.90f, 0.84f};  // the pattern's second colour
  Pattern pattern = Pattern::plain;
  float pattern_scale = 8;     // repeats over a texture coordinate of 1
  float sheen = 0.5f;          // 0 to 1: light scattered at grazing angles by fibres
  float translucency = 0.12f;  // 0 to 1: light that comes through (cloth); 0 for what is solid
};

// One surface to draw; indices of triangles go into positions, normals and uvs alike (split at seams).
struct Surface {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec2f> uvs;  // empty, or one for each position
  std::vector<Triangle> triangles;
  Material material;
  bool two_sided = false;  // cloth: the back is seen, and lit with its own colour
};

struct Camera {
  Vec3f eye{2.5f, 1.5f, 2.5f};
  Vec3f target{0, 0, 0};
  float vertical_field_of_view = 35;  // degrees
};

// A light from far away: the direction in which it shines, and the angle that it fills (softness of shadows).
struct Sun {
  Vec3f direction{0.6f, -0.9f, -0.35f};
  Color color{1.0f, 0.98f, 0.95f};
  float intensity = 5.0f;
  float size = 5;  // degrees
};

// Light from everywhere: a gradient above, and below it what the ground throws back (`ground` where none is
// drawn; a ground that is drawn throws back its own light).
struct Sky {
  Color top{0.87f, 0.92f, 1.0f};
  Color horizon{0.95f, 0.95f, 0.96f};
  Color ground{0.42f, 0.40f, 0.38f};
  float intensity = 1.0f;
};

// The horizontal ground that is drawn; it dissolves into the backdrop with distance.
struct Ground {
  bool visible = false;
  float height = 0;
  Color color{0.72f, 0.71f, 0.70f};
};

struct View {
  Camera camera;
  Sun sun;
  Sky sky;
  Ground ground;
  Color backdrop{0.86f, 0.87f, 0.89f};
  float exposure = 1;
};

struct Settings {
  int width = 1280;
  int height = 720;
  int passes = 6;  // accumulated; 2 show the shapes, 32 have smooth shadows
};

}  // namespace drape::render

#include "core/hash.h"
#include "scene/load.h"

namespace drape {

SimulationInput simulation_input(const SceneDescription& scene) {
  SimulationInput input;
  for (const ClothDescription& cloth : scene.cloths) input.cloths.push_back(cloth.input);
  for (const ColliderDescription& collider : scene.colliders) input.colliders.push_back(collider.input);
  input.seams = scene.seams;
  input.model = scene.model;
  input.alpha = scene.alpha;
  input.gravity = scene.gravity;
  input.wind = scene.wind;
  input.self_collision = scene.self_collision;
  input.sleep = scene.sleep;
  input.fail_safe = scene.fail_safe;
  input.frame_duration = 1 / scene.time.fps;
  input.largest_step = scene.time.step;
  return input;
}

namespace {

// Part of every fingerprint. To be counted up with each change that makes the same scene move in another way,
// or that adds a value to the fingerprint: what is in a cache from before is then not taken for the scene's.
constexpr std::uint64_t fingerprint_version = 6;

// Numbers go in as their bytes, lists after their length, so that no two scenes run together.
class Fingerprint {
 public:
  Fingerprint() { add(fingerprint_version); }
  std::uint64_t digest() const { return hasher_.digest(); }

  void add(std::uint64_t value) { hasher_.add(&value, sizeof(value)); }
  void add(double value) { hasher_.add(&value, sizeof(value)); }
  void add(bool value) { add(std::uint64_t{value}); }
  void add(const Vec3& value) {
    for (const double part : value) add(part);
  }
  void add(const std::vector<Vec3>& values) {
    add(std::uint64_t{values.size()});
    for (const Vec3& value : values) add(value);
  }
  void add(const std::vector<int>& values) {
    add(std::uint64_t{values.size()});
    for (const int value : values) add(static_cast<std::uint64_t>(value));
  }
  // Texture coordinates are for drawing only.
  void add(const TriangleMesh& mesh) {
    add(mesh.positions);
    add(std::uint64_t{mesh.triangles.size()});
    for (const Triangle& triangle : mesh.triangles)
      for (const int vertex : triangle) add(static_cast<std::uint64_t>(vertex));
  }
  void add(const Track& track) {
    add(std::uint64_t{track.size()});
    for (const auto& [time, value] : track) add(time), add(value);
  }
  void add(const RigidMotion& motion) {
    add(motion.at);
    add(motion.rotate);
    for (const Track& track : motion.translate) add(track);
    for (const Track& track : motion.turn) add(track);
  }
  void add(const ClothMaterial& material) {
    const ElasticMaterial& elastic = material.elastic;
    for (const double value : {elastic.density, elastic.stretch_stiffness[0], elastic.stretch_stiffness[1],
                               elastic.shear_stiffness, elastic.poisson_ratio, elastic.bend_stiffness[0],
                               elastic.bend_stiffness[1], elastic.damping, elastic.strain_limit,
                               material.thickness, material.friction})
      add(value);
    add(material.warp);
  }
  void add(const WindInput& wind) {
    add(wind.velocity);
    add(static_cast<std::uint64_t>(wind.seed));
    for (const double value : {wind.gust, wind.gust_size, wind.drag, wind.tangential_drag, wind.lift})
      add(value);
  }
  void add(const PinInput& pin) {
    add(pin.vertices);
    add(pin.motion.has_value());
    if (pin.motion) add(*pin.motion);
    add(pin.from);
    add(pin.collider.has_value());
    if (pin.collider) add(static_cast<std::uint64_t>(*pin.collider));
    add(pin.until.has_value());
    if (pin.until) add(*pin.until);
  }
  void add(const ClothInput& cloth) {
    add(cloth.mesh);
    add(cloth.start_positions);
    add(cloth.start_velocity);
    add(cloth.material);
    add(cloth.pressure);
    add(std::uint64_t{cloth.pins.size()});
    for (const PinInput& pin : cloth.pins) add(pin);
  }
  void add(const SeamInput& seam) {
    for (const int cloth : seam.cloths) add(static_cast<std::uint64_t>(cloth));
    for (const std::vector<int>& side : seam.vertices) add(side);
    add(seam.from);
    add(seam.close);
  }
  void add(const PlaneShape&) {}
  void add(const SphereShape& sphere) { add(sphere.radius); }
  void add(const BoxShape& box) { add(box.size); }
  void add(const CapsuleShape& capsule) { add(capsule.radius), add(capsule.length); }
  void add(const CylinderShape& cylinder) { add(cylinder.radius), add(cylinder.height); }
  void add(const MeshShape& shape) {
    add(shape.mesh);
    add(std::uint64_t{shape.shapes.size()});
    for (const std::vector<Vec3>& points : shape.shapes) add(points);
    add(shape.first_time), add(shape.interval);
  }
  void add(const ColliderInput& collider) {
    add(std::uint64_t{collider.shape.index()});
    std::visit([&](const auto& shape) { add(shape); }, collider.shape);
    add(collider.motion);
    add(collider.friction);
  }

 private:
  Hasher hasher_;
};

}  // namespace

std::uint64_t simulation_fingerprint(const SceneDescription& scene) {
  Fingerprint fingerprint;
  fingerprint.add(scene.time.fps);
  fingerprint.add(scene.time.step);
  fingerprint.add(static_cast<std::uint64_t>(scene.model));
  fingerprint.add(scene.alpha);
  fingerprint.add(scene.gravity);
  fingerprint.add(scene.wind);
  fingerprint.add(scene.self_collision);
  fingerprint.add(scene.sleep);
  fingerprint.add(scene.fail_safe);
  fingerprint.add(std::uint64_t{scene.cloths.size()});
  for (const ClothDescription& cloth : scene.cloths) fingerprint.add(cloth.input);
  fingerprint.add(std::uint64_t{scene.seams.size()});
  for (const SeamInput& seam : scene.seams) fingerprint.add(seam);
  fingerprint.add(std::uint64_t{scene.colliders.size()});
  for (const ColliderDescription& collider : scene.colliders) fingerprint.add(collider.input);
  return fingerprint.digest();
}

}  // namespace drape

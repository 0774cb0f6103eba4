#include "soak/random_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace drape::soak {

namespace {

constexpr int frames = 20;

// The library's distributions may differ from one to another; these do not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  double between(double least, double most) {
    return least + (most - least) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  // As often between 1 and 10 as between 10 and 100.
  double by_magnitude(double least, double most) {
    return std::exp(between(std::log(least), std::log(most)));
  }
  int number(int least, int most) { return least + static_cast<int>(engine_() % (most - least + 1)); }
  bool one_in(int count) { return number(1, count) == 1; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace

static std::string vector_text(double x, double y, double z) {
  return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", x, y, z);
}

static std::string random_vector(Dice& dice, double most) {
  const double x = dice.between(-most, most), y = dice.between(-most, most), z = dice.between(-most, most);
  return vector_text(x, y, z);
}

static std::string material(Dice& dice) {
  return fmt::format(
      "{{density: {:.3g}, thickness: {:.3g}, stretch: {:.3g}, shear: {:.3g}, bend: {:.3g}, damping: {:.3g}, "
      "friction: {:.3g}, strain_limit: {}}}",
      dice.by_magnitude(0.05, 1), dice.by_magnitude(5e-4, 8e-3), dice.by_magnitude(500, 20000),
      dice.by_magnitude(200, 10000), dice.by_magnitude(1e-7, 1e-3), dice.by_magnitude(1e-4, 0.02),
      dice.between(0, 1), dice.one_in(4) ? "0.1" : "0");
}

// There and back, or on, at up to `fastest` metres a second.
static std::string keyframes(Dice& dice, double fastest) {
  const double fps = 30;
  const int turn = dice.number(2, frames / 2), end = dice.number(turn + 1, frames);
  const double reach = std::min(dice.by_magnitude(0.1, fastest) * turn / fps, 1.5);
  const std::string out = random_vector(dice, reach), back = random_vector(dice, 0.3);
  std::string text = fmt::format("translate: [[0, [0, 0, 0]], [{}, {}], [{}, {}]]", turn, out, end, back);
  if (dice.one_in(2)) text += fmt::format(", rotate_y: [[0, 0], [{}, {:.4g}]]", end, dice.between(-720, 720));
  if (dice.one_in(3)) text += fmt::format(", rotate_x: [[0, 0], [{}, {:.4g}]]", end, dice.between(-180, 180));
  return "{" + text + "}";
}

static std::string pins(Dice& dice) {
  const char* corners[] = {"[-x, -z]", "[-x, +z]", "[+x, -z]", "[+x, +z]"};
  std::string text = "    pins:\n";
  const int first = dice.number(0, 3);
  for (int i = dice.number(1, 2); i > 0; --i) {
    text += fmt::format("      - {{corner: {}", corners[(first + i) % 4]);
    if (dice.one_in(2)) text += ", animate: " + keyframes(dice, 5);
    text += dice.one_in(3) ? fmt::format(", until: {}}}\n", dice.number(5, frames)) : "}\n";
  }
  return text;
}

static std::string cloth(Dice& dice, int layer) {
  const double size = dice.between(0.3, 0.8);
  const int points = dice.number(8, 26);
  std::string text = fmt::format("  cloth_{}:\n", layer);
  if (dice.one_in(3))
    text += fmt::format("    disc: {{diameter: {:.3g}, edge: {:.3g}}}\n", size, size / points);
  else
    text += fmt::format("    grid: {{size: [{:.3g}, {:.3g}], points: [{}, {}]}}\n", size,
                        size * dice.between(0.5, 1), points, dice.number(8, points + 2));
  text += fmt::format("    place: {{at: {}, rotate: {}}}\n",
                      vector_text(dice.between(-0.2, 0.2), 1 + 0.35 * layer, dice.between(-0.2, 0.2)),
                      random_vector(dice, 20));
  text += "    material: " + material(dice) + "\n";
  if (dice.one_in(2)) text += "    velocity: " + random_vector(dice, dice.by_magnitude(0.5, 28)) + "\n";
  if (dice.one_in(2)) text += pins(dice);
  if (dice.one_in(3)) text += "    look: {subdivide: 1}\n";
  return text;
}

static std::string shape(Dice& dice) {
  switch (dice.number(0, 3)) {
    case 0:
      return fmt::format("sphere: {{radius: {:.3g}}}", dice.between(0.03, 0.25));
    case 1:
      return fmt::format("box: {{size: {}}}", vector_text(dice.between(0.02, 0.5), dice.between(0.02, 0.3),
                                                          dice.between(0.02, 0.5)));
    case 2:
      return fmt::format("capsule: {{radius: {:.3g}, length: {:.3g}}}", dice.between(0.01, 0.1),
                         dice.between(0.05, 0.6));
    default:
      return fmt::format("cylinder: {{radius: {:.3g}, height: {:.3g}}}", dice.between(0.03, 0.2),
                         dice.between(0.02, 0.4));
  }
}

// Under the cloths at first; some come up through where these are.
static std::string collider(Dice& dice, int index) {
  std::string text = fmt::format("  collider_{}:\n    {}\n", index, shape(dice));
  text += fmt::format("    place: {{at: {}, rotate: {}}}\n",
                      vector_text(dice.between(-0.4, 0.4), dice.between(0, 0.3), dice.between(-0.4, 0.4)),
                      random_vector(dice, 180));
  text += fmt::format("    friction: {:.3g}\n", dice.between(0, 1));
  if (dice.one_in(2)) text += "    animate: " + keyframes(dice, 50) + "\n";
  return text;
}

static std::string wind(Dice& dice) {
  return fmt::format("  wind: {{velocity: {}, gust: {:.3g}, seed: {}}}\n",
                     random_vector(dice, dice.by_magnitude(1, 30)), dice.between(0, 1), dice.number(0, 1000));
}

std::string random_scene(std::uint64_t seed) {
  Dice dice(seed);
  std::string text = fmt::format("version: 1\nname: soak_{}\ntime: {{fps: 30, frames: {}, step: {}}}\n", seed,
                                 frames, dice.one_in(2) ? "2 ms" : "5 ms");
  text += "simulation:\n" + (dice.one_in(2) ? wind(dice) : std::string("  self_collision: true\n"));
  text += "cloths:\n";
  for (int i = 0, count = dice.number(1, 3); i < count; ++i) text += cloth(dice, i);
  text += "colliders:\n";
  if (!dice.one_in(4)) text += "  floor: {plane: {y: -0.3}}\n";
  for (int i = 0, count = dice.number(1, 3); i < count; ++i) text += collider(dice, i);
  return text;
}

}  // namespace drape::soak

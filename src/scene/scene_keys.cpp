#include "scene/scene_keys.h"

#include <array>

namespace drape {
namespace {

using enum Quantity;

constexpr Key section(std::string_view path, std::string_view help, std::string_view keys_under = {}) {
  return {path, KeyKind::section, help, {}, 0, {}, keys_under};
}
constexpr Key named(std::string_view path, std::string_view help, std::string_view keys_under) {
  return {path, KeyKind::named, help, {}, 0, {}, keys_under};
}
constexpr Key of_kind(KeyKind kind, std::string_view path, std::string_view help) {
  return {path, kind, help};
}
constexpr Key number(std::string_view path, Quantity quantity, double least, double greatest,
                     std::string_view help) {
  return {path, KeyKind::number, help, {quantity, least, greatest, false}};
}
constexpr Key whole(std::string_view path, double least, double greatest, std::string_view help) {
  return {path, KeyKind::number, help, {plain, least, greatest, true}};
}
constexpr Key numbers(std::string_view path, int count, NumberRule rule, std::string_view help) {
  return {path, KeyKind::numbers, help, rule, count};
}
constexpr Key pair(std::string_view path, Quantity quantity, double least, double greatest,
                   std::string_view help) {
  return {path, KeyKind::pair, help, {quantity, least, greatest, false}, 2};
}
constexpr Key choice(std::string_view path, std::span<const std::string_view> choices,
                     std::string_view help) {
  return {path, KeyKind::choice, help, {}, 0, choices};
}
constexpr Key keyframes(KeyKind kind, std::string_view path, NumberRule rule, std::string_view help) {
  return {path, kind, help, rule};
}
constexpr Key required(Key key) {
  key.required = true;
  return key;
}

constexpr NumberRule position = {length, -1000, 1000};
constexpr NumberRule size = {length, 0.001, 1000};
constexpr NumberRule turn = {angle, -36'000, 36'000};

constexpr std::array<std::string_view, 4> pattern_names = {"plain", "checker", "stripe", "tartan"};
constexpr std::array<std::string_view, 4> edge_names = {"-x", "+x", "-z", "+z"};
constexpr std::array<std::string_view, 3> model_names = {"shape_matching", "averaged", "mass_spring"};
constexpr std::array<std::string_view, 3> quality_names = {"draft", "preview", "final"};

constexpr std::array<std::string_view, 15> fact_names = {
    "largest_stretch", "p99_stretch", "smallest_stretch", "smallest_gap", "kinetic_energy",
    "largest_speed",   "largest_lag", "contacts",         "held_back",    "lowest",
    "highest",         "middle_x",    "middle_y",         "middle_z",     "turn"};

constexpr Key general_keys[] = {
    required(whole("version", 1, 1, "of this format")),
    of_kind(KeyKind::text, "name", "default: the name of the file without its ending"),
    of_kind(KeyKind::variables, "vars", "${name} stands for the value anywhere below"),
    of_kind(KeyKind::files, "include", "merged deeply; the including file wins"),

    section("time", "frames and steps"),
    number("time.fps", plain, 1, 1000, "frames a second"),
    of_kind(KeyKind::frame_range, "time.frames", "first-last, or how many from 1; frame 0 is the start"),
    number("time.step", time, 1e-5, 0.1, "longest step; a frame is cut into equal steps"),

    section("simulation", "the world"),
    choice("simulation.model", model_names, "how cloth resists deformation"),
    number("simulation.alpha", plain, 1e-6, 1, "of averaged: the share of the way to the goals in each step"),
    numbers("simulation.gravity", 3, {acceleration, -1000, 1000}, "[x, y, z]; +y is up"),
    section("simulation.wind", "moving air"),
    numbers("simulation.wind.velocity", 3, {speed, -100, 100}, "[x, y, z]"),
    number("simulation.wind.gust", plain, 0, 2,
           "how far gusts depart from the mean, as a share of its speed"),
    number("simulation.wind.gust_size", length, 0.01, 1000, "of the largest whirls"),
    whole("simulation.wind.seed", 0, 1e9, "other gusts for each"),
    number("simulation.wind.drag", plain, 0, 100,
           "coefficient of pressure, across the cloth; also in still air"),
    number("simulation.wind.tangential_drag", plain, 0, 100, "coefficient of friction, along the cloth"),
    number("simulation.wind.lift", plain, 0, 100, "coefficient of lift, at right angles to the stream"),
    of_kind(KeyKind::boolean, "simulation.self_collision", "cloth against cloth"),
    of_kind(KeyKind::boolean, "simulation.sleep",
            "cloth that lies still is left alone until something stirs it"),
};

constexpr Key material_keys[] = {
    named("materials", "by name, for cloths to name", "cloths.*.material"),
};

constexpr Key cloth_keys[] = {
    required(of_kind(KeyKind::named, "cloths", "by name")),
    section("cloths.*.grid", "a rectangle, flat, front upward, centred on its origin"),
    required(numbers("cloths.*.grid.size", 2, size, "[along x, along z]")),
    required(numbers("cloths.*.grid.points", 2, {plain, 2, 2000, true}, "[along x, along z]")),
    section("cloths.*.disc", "in place of a grid: a round piece, flat, front upward, centred on its origin"),
    required(number("cloths.*.disc.diameter", length, 0.001, 1000, "")),
    required(number("cloths.*.disc.edge", length, 1e-4, 250,
                    "of its triangles, about; at most a quarter of the diameter")),
    of_kind(KeyKind::file, "cloths.*.mesh", "in place of a grid: a surface in metres"),
    of_kind(KeyKind::file, "cloths.*.rest", "of a mesh: the same surface in the shape it has at rest"),
    section("cloths.*.place", "where it starts", "place"),

    section("cloths.*.material", "what it is made of; or the name of one of the materials"),
    number("cloths.*.material.density", area_density, 0.001, 100, "mass per area"),
    number("cloths.*.material.thickness", length, 1e-4, 0.1, "the distance that contact keeps"),
    pair("cloths.*.material.stretch", tension, 1, 1e6, "[warp, weft]: tension per width at a strain of 1"),
    number("cloths.*.material.shear", tension, 0.1, 1e6, "shear force per width at an angle of 1 rad"),
    number("cloths.*.material.poisson", plain, -0.9, 0.9, "contraction across, over the strain along"),
    pair("cloths.*.material.bend", flexural_rigidity, 0, 1, "[warp, weft]: flexural rigidity"),
    numbers("cloths.*.material.warp", 3, {plain, -1000, 1000},
            "[x, y, z]: its direction in the unplaced shape"),
    number("cloths.*.material.damping", time, 0, 10, "stress at a rate of strain, over that at the strain"),
    number("cloths.*.material.strain_limit", plain, 0, 10,
           "edges stretch by hardly more; 0: 2 %, or what 400 N/m do"),
    number("cloths.*.material.friction", plain, 0, 10, "Coulomb's coefficient"),

    numbers("cloths.*.velocity", 3, {speed, -100, 100}, "[x, y, z] at the start"),
    number("cloths.*.pressure", pressure, -100'000, 100'000, "of a closed cloth, inside over outside"),

    of_kind(KeyKind::list, "cloths.*.pins", "vertices that are held; each by corner, box or vertices"),
    of_kind(KeyKind::axis_signs, "cloths.*.pins.*.corner",
            "the vertex nearest to that corner of the unplaced shape; an axis that is not named: its middle"),
    section("cloths.*.pins.*.box", "the vertices in a box of the world, at the start"),
    required(numbers("cloths.*.pins.*.box.from", 3, position, "[x, y, z], one corner")),
    required(numbers("cloths.*.pins.*.box.to", 3, position, "[x, y, z], the opposite corner")),
    of_kind(KeyKind::indices, "cloths.*.pins.*.vertices", "numbers of vertices, from 0"),
    section("cloths.*.pins.*.animate", "moves them on; turns about the centre of the vertices", "animate"),
    of_kind(KeyKind::text, "cloths.*.pins.*.follow", "the name of a collider that they move with"),
    whole("cloths.*.pins.*.from", 0, 100'000,
          "the frame from which the vertices are held, where they are then"),
    whole("cloths.*.pins.*.until", 1, 100'000, "the frame from which the vertices are free"),
    section("cloths.*.look", "how it is drawn", "look"),
};

constexpr Key seam_keys[] = {
    of_kind(KeyKind::list, "seams", "threads that draw pieces of cloth together"),
    required(
        of_kind(KeyKind::list, "seams.*.between", "the two sides, with as many vertices, paired in order")),
    required(of_kind(KeyKind::text, "seams.*.between.*.cloth", "the name of a cloth")),
    choice("seams.*.between.*.edge", edge_names,
           "the vertices farthest along that axis of the unplaced shape, from - to + of the other axis"),
    of_kind(KeyKind::indices, "seams.*.between.*.vertices",
            "in place of an edge: numbers of vertices, from 0"),
    of_kind(KeyKind::boolean, "seams.*.between.*.reverse", "true: in the opposite order"),
    whole("seams.*.from", 0, 100'000, "the frame from which the threads are drawn in"),
    whole("seams.*.close", 1, 100'000, "the frame from which the seam is closed"),
};

constexpr Key collider_keys[] = {
    of_kind(KeyKind::named, "colliders", "by name; each a plane, sphere, box, cylinder, capsule or mesh"),
    section("colliders.*.plane", "the ground: all below it is solid"),
    number("colliders.*.plane.y", length, -1000, 1000, "its height"),
    section("colliders.*.sphere", "centred on its origin"),
    required(number("colliders.*.sphere.radius", length, 0.001, 1000, "")),
    section("colliders.*.box", "centred on its origin"),
    required(numbers("colliders.*.box.size", 3, size, "[along x, along y, along z]")),
    section("colliders.*.cylinder", "along y, centred on its origin"),
    required(number("colliders.*.cylinder.radius", length, 0.001, 1000, "")),
    required(number("colliders.*.cylinder.height", length, 0.001, 1000, "")),
    section("colliders.*.capsule", "along y, centred on its origin"),
    required(number("colliders.*.capsule.radius", length, 0.001, 1000, "")),
    required(number("colliders.*.capsule.length", length, 0.001, 1000, "between the centres of its ends")),
    of_kind(KeyKind::file, "colliders.*.mesh",
            "a surface in metres; with #### for a number: its shape at each frame"),
    of_kind(KeyKind::text, "colliders.*.clip",
            "the animation in the mesh's file that it plays, by name or number"),
    number("colliders.*.scale", plain, 1e-6, 1e6, "metres to one unit of the mesh's file"),
    section("colliders.*.place", "where it stands", "place"),
    section("colliders.*.animate", "what is added to its place", "animate"),
    number("colliders.*.friction", plain, 0, 10, "a contact uses the geometric mean of the two"),
    of_kind(KeyKind::boolean, "colliders.*.visible", "false: it acts, but is not drawn"),
    section("colliders.*.look", "how it is drawn", "look"),
};

constexpr Key shared_keys[] = {
    numbers("place.at", 3, position, "[x, y, z] of its origin"),
    numbers("place.rotate", 3, turn, "about x, then y, then z"),

    keyframes(KeyKind::point_keyframes, "animate.translate", position, "[[frame, [x, y, z]], ...]"),
    keyframes(KeyKind::keyframes, "animate.rotate_x", turn, "[[frame, angle], ...]"),
    keyframes(KeyKind::keyframes, "animate.rotate_y", turn, "[[frame, angle], ...]"),
    keyframes(KeyKind::keyframes, "animate.rotate_z", turn, "[[frame, angle], ...]"),

    of_kind(KeyKind::color, "look.color", "\"#rrggbb\", \"#rgb\", or [r, g, b] from 0 to 1"),
    of_kind(KeyKind::color, "look.back", "of the other side; default: color"),
    of_kind(KeyKind::color, "look.accent", "the pattern's second colour"),
    choice("look.pattern", pattern_names, ""),
    number("look.scale", plain, 0.01, 1000, "repeats of the pattern along a side"),
    number("look.sheen", plain, 0, 1, "light scattered at grazing angles by fibres"),
    number("look.translucency", plain, 0, 1, "light that comes through"),
    whole("look.subdivide", 0, 3, "levels of Loop subdivision, for drawing only"),
};

constexpr Key measure_keys[] = {
    section("measure", "what `drape measure` finds out"),
    section("measure.drape", "Cusick's drape test"),
    required(of_kind(KeyKind::text, "measure.drape.cloth", "the piece that is tested")),
    required(of_kind(KeyKind::text, "measure.drape.support", "the cylinder that it lies on")),
};

constexpr Key fact_keys[] = {
    of_kind(KeyKind::list, "test", "what `drape verify` holds the frames to"),
    required(choice("test.*.what", fact_names, "the quantity")),
    of_kind(KeyKind::frame_range, "test.*.frames", "default: all that are drawn"),
    of_kind(KeyKind::text, "test.*.cloth", "whose place is meant; default: all cloths together"),
    number("test.*.least", plain, -1e9, 1e9, "in SI units, turns in degrees"),
    number("test.*.most", plain, -1e9, 1e9, "in SI units, turns in degrees"),
};

constexpr Key picture_keys[] = {
    section("camera", "looks at a point, from a place or from a circle round it"),
    numbers("camera.at", 3, position, "[x, y, z] of the eye; not used with orbit"),
    numbers("camera.look_at", 3, position, "[x, y, z]"),
    number("camera.fov", angle, 1, 150, "field of view, vertical"),
    section("camera.orbit", "a circle about the vertical through look_at"),
    number("camera.orbit.radius", length, 0.01, 1000, ""),
    number("camera.orbit.height", length, -1000, 1000, "over look_at"),
    number("camera.orbit.start", angle, -36'000, 36'000, "from +z towards +x"),
    number("camera.orbit.turns", plain, -100, 100, "over all frames"),

    of_kind(KeyKind::list, "lights", "one sun, one sky; what is not in the list is dark"),
    section("lights.*.sun", "light from far away"),
    numbers("lights.*.sun.direction", 3, {plain, -1000, 1000}, "[x, y, z] in which it shines"),
    of_kind(KeyKind::color, "lights.*.sun.color", ""),
    number("lights.*.sun.intensity", plain, 0, 1000, ""),
    number("lights.*.sun.size", angle, 0, 90, "the angle that it fills: softness of shadows"),
    section("lights.*.sky", "light from everywhere"),
    of_kind(KeyKind::color, "lights.*.sky.top", ""),
    of_kind(KeyKind::color, "lights.*.sky.horizon", ""),
    of_kind(KeyKind::color, "lights.*.sky.ground", "what the ground throws back"),
    number("lights.*.sky.intensity", plain, 0, 1000, ""),

    section("render", "pictures and video"),
    numbers("render.resolution", 2, {plain, 16, 8192, true}, "[width, height] in pixels"),
    choice("render.quality", quality_names, ""),
    number("render.exposure", plain, 0.001, 1000, "factor on all light"),
    of_kind(KeyKind::color, "render.backdrop", "what is behind everything"),
    section("render.video", "of the encoder"),
    whole("render.video.crf", 0, 51, "constant rate factor: 0 is lossless, 51 the worst"),
};

// The parts one after another.
constexpr auto all_keys = [] {
  std::array<Key, std::size(general_keys) + std::size(material_keys) + std::size(cloth_keys) +
                      std::size(seam_keys) + std::size(collider_keys) + std::size(shared_keys) +
                      std::size(measure_keys) + std::size(fact_keys) + std::size(picture_keys)>
      keys;
  std::size_t count = 0;
  const auto append = [&](const auto& part) {
    for (const Key& key : part) keys[count++] = key;
  };
  append(general_keys);
  append(material_keys);
  append(cloth_keys);
  append(seam_keys);
  append(collider_keys);
  append(shared_keys);
  append(measure_keys);
  append(fact_keys);
  append(picture_keys);
  return keys;
}();

// The name of a key that is listed under `section`; empty where the key is listed elsewhere.
std::string_view name_under(std::string_view section, const Key& key) {
  std::string_view name = key.path;
  if (!section.empty()) {
    if (!name.starts_with(section) || name.substr(section.size(), 1) != ".") return {};
    name.remove_prefix(section.size() + 1);
  }
  return name.find('.') == std::string_view::npos ? name : std::string_view();
}

}  // namespace

std::span<const Key> scene_keys() { return all_keys; }

const Key* find_key(std::string_view section, std::string_view name) {
  for (const Key& key : all_keys)
    if (!name.empty() && name_under(section, key) == name) return &key;
  return nullptr;
}

std::string keys_listed_under(const Key& key) {
  if (!key.keys_under.empty()) return std::string(key.keys_under);
  const bool has_items = key.kind == KeyKind::named || key.kind == KeyKind::list;
  return std::string(key.path) + (has_items ? ".*" : "");
}

std::vector<std::string_view> key_names(std::string_view section) {
  std::vector<std::string_view> names;
  for (const Key& key : all_keys)
    if (const std::string_view name = name_under(section, key); !name.empty()) names.push_back(name);
  return names;
}

}  // namespace drape

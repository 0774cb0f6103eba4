#include "mesh/assimp_import.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "core/file.h"
#include "mesh/figure.h"
#include "mesh/figure_check.h"
#include "mesh/gltf_keys.h"
#include "mesh/limits.h"
#include "mesh/mesh_text.h"

namespace drape {
namespace {
namespace fs = std::filesystem;

bool is_inside(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

// What assimp sees of the disk: regular files in one folder and below, whole, and read only. Links are
// followed before the question is asked.
class OneFolder : public Assimp::IOSystem {
 public:
  explicit OneFolder(const fs::path& file) : folder_(fs::canonical(file).parent_path()) {}

  bool Exists(const char* name) const override { return is_allowed(name); }
  char getOsSeparator() const override { return '/'; }
  void Close(Assimp::IOStream* stream) override { delete stream; }

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    if (mode[0] != 'r' || !is_allowed(name)) {
      if (refused_.empty()) refused_ = name;
      return nullptr;
    }
    const std::string content = read_file(name);
    auto bytes = std::make_unique<std::uint8_t[]>(content.size());
    std::copy(content.begin(), content.end(), bytes.get());
    return new Assimp::MemoryIOStream(bytes.release(), content.size(), true);
  }

  // The first name that was asked for in vain.
  const std::string& refused() const { return refused_; }

 private:
  bool is_allowed(const fs::path& name) const {
    std::error_code error;
    const fs::path file = fs::canonical(name, error);
    return !error && is_inside(file, folder_) && fs::is_regular_file(file, error);
  }

  fs::path folder_;
  std::string refused_;
};

Vec3 to_point(const aiVector3D& v) {
  const Vec3 point(v.x, v.y, v.z);
  for (const double x : point)
    if (!is_usable_coordinate(x)) throw std::runtime_error("a point has a coordinate that is not usable");
  return point;
}

void append_face(const aiMesh& mesh, const aiFace& face, int first_point, PolygonSoup& soup) {
  if (face.mNumIndices < 3) return;  // points and lines
  if (soup.corner_points.size() + face.mNumIndices > most_corners)
    throw std::runtime_error("it has too many faces");
  for (unsigned i = 0; i < face.mNumIndices; ++i) {
    if (face.mIndices[i] >= mesh.mNumVertices)
      throw std::runtime_error("a face names a point that the file does not have");
    soup.corner_points.push_back(first_point + static_cast<int>(face.mIndices[i]));
  }
  soup.polygon_ends.push_back(static_cast<int>(soup.corner_points.size()));
}

void append_mesh(const aiMesh& mesh, const aiMatrix4x4& placement, PolygonSoup& soup) {
  if (soup.points.size() + mesh.mNumVertices > most_points)
    throw std::runtime_error("it has too many points");
  const int first_point = static_cast<int>(soup.points.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    soup.points.push_back(to_point(placement * mesh.mVertices[i]));
    if (!mesh.HasTextureCoords(0)) continue;
    const Vec3 uv = to_point(mesh.mTextureCoords[0][i]);
    soup.uvs.emplace_back(uv.x(), uv.y());
  }
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) append_face(mesh, mesh.mFaces[i], first_point, soup);
}

void append_node(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent, PolygonSoup& soup) {
  const aiMatrix4x4 placement = parent * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i)
    append_mesh(*scene.mMeshes[node.mMeshes[i]], placement, soup);
  for (unsigned i = 0; i < node.mNumChildren; ++i) append_node(scene, *node.mChildren[i], placement, soup);
}

[[noreturn]] void fail(const Assimp::Importer& importer, const OneFolder& folder) {
  std::string words = importer.GetErrorString();
  if (!folder.refused().empty())
    words += " (it refers to " + folder.refused() + ", which is not a regular file in its own folder)";
  throw std::runtime_error(words);
}

}  // namespace

static const aiScene& read_scene(Assimp::Importer& importer, const fs::path& path) {
  auto* const folder = new OneFolder(path);
  importer.SetIOHandler(folder);  // which owns it from here on
  if (!importer.IsExtensionSupported(path.extension().string()))
    throw std::runtime_error(
        in_quotes(path.extension().string()) +
        " is the ending of no format of meshes that can be read; use .obj, .ply, .stl or .glb");
  const aiScene* const scene = importer.ReadFile(path.string(), 0);
  if (!scene || !scene->mRootNode) fail(importer, *folder);
  return *scene;
}

static PolygonSoup soup_of(const aiScene& scene) {
  PolygonSoup soup;
  append_node(scene, *scene.mRootNode, aiMatrix4x4(), soup);
  if (soup.polygon_ends.empty()) throw std::runtime_error("it holds no faces");
  if (soup.uvs.size() == soup.points.size()) soup.corner_uvs = soup.corner_points;
  return soup;
}

namespace {

Mat4 to_matrix(const aiMatrix4x4& m) {
  Mat4 matrix;
  for (unsigned row = 0; row < 4; ++row)
    for (unsigned column = 0; column < 4; ++column) matrix(row, column) = m[row][column];
  return matrix;
}

Vec3 to_value(const aiVector3D& v) { return {v.x, v.y, v.z}; }
Quaternion to_value(const aiQuaternion& q) { return {q.w, q.x, q.y, q.z}; }

template <typename Value, typename Key, typename Rest>
TimedValues<Value> to_timed(const Key* keys, unsigned count, double ticks_per_second, const Rest& rest) {
  if (count == 0) return {{0}, {to_value(rest)}};
  TimedValues<Value> timed;
  for (unsigned i = 0; i < count; ++i) {
    timed.times.push_back(keys[i].mTime / ticks_per_second);
    timed.values.push_back(to_value(keys[i].mValue));
  }
  return timed;
}

NodeMotion to_motion(const aiNodeAnim& channel, const aiNode& node, double ticks_per_second) {
  aiVector3D scale, place;
  aiQuaternion turn;
  node.mTransformation.Decompose(scale, turn, place);
  turn.Normalize();  // of a node whose scale is 0 it is none
  return {to_timed<Vec3>(channel.mPositionKeys, channel.mNumPositionKeys, ticks_per_second, place),
          to_timed<Quaternion>(channel.mRotationKeys, channel.mNumRotationKeys, ticks_per_second, turn),
          to_timed<Vec3>(channel.mScalingKeys, channel.mNumScalingKeys, ticks_per_second, scale)};
}

// A figure while its parts are gathered from assimp's. Nodes and surfaces come in the order of append_node.
struct Gathering {
  const aiScene& scene;
  Figure figure;
  std::vector<const aiNode*> nodes;                      // the figure's, as assimp has them
  std::map<std::string, std::vector<int>> node_numbers;  // of each name
  std::set<const aiMesh*> skinned;                       // those that a node has been found for
};

// assimp's animations and bones know nodes by name alone. -1: none.
int find_node(const Gathering& gathering, const std::string& name) {
  const auto found = gathering.node_numbers.find(name);
  if (found == gathering.node_numbers.end()) return -1;
  if (found->second.size() > 1)
    throw std::runtime_error(
        fmt::format("{} of its nodes are named {}, which an animation or a skin refers to: "
                    "give each a name of its own",
                    found->second.size(), in_quotes(name)));
  return found->second.front();
}

void gather_nodes(const aiNode& node, int parent, Gathering& gathering) {
  Figure& figure = gathering.figure;
  const int number = static_cast<int>(figure.nodes.size());
  figure.nodes.push_back({parent, -1, to_matrix(node.mTransformation), node.mName.C_Str()});
  gathering.nodes.push_back(&node);
  gathering.node_numbers[node.mName.C_Str()].push_back(number);
  for (unsigned i = 0; i < node.mNumMeshes; ++i) figure.surfaces.push_back({number, {}, {}});
  for (unsigned i = 0; i < node.mNumChildren; ++i) gather_nodes(*node.mChildren[i], number, gathering);
}

double ticks_per_second(const aiAnimation& animation) {
  constexpr double usual = 25;  // assimp's, where a file does not say
  const double ticks = animation.mTicksPerSecond;
  if (ticks == 0) return usual;
  if (!(ticks > 0 && std::isfinite(ticks)))
    throw std::runtime_error(
        fmt::format("its animation runs at {:g} frames a second: write its frame rate into the file", ticks));
  return ticks;
}

// Channels of nodes that the file's scene leaves out move nothing.
void gather_motions(const aiAnimation& animation, Gathering& gathering) {
  Figure& figure = gathering.figure;
  const double ticks = ticks_per_second(animation);
  for (unsigned c = 0; c < animation.mNumChannels; ++c) {
    const aiNodeAnim& channel = *animation.mChannels[c];
    const int number = find_node(gathering, channel.mNodeName.C_Str());
    if (number < 0) continue;
    figure.nodes[number].motion = static_cast<int>(figure.motions.size());
    figure.motions.push_back(to_motion(channel, *gathering.nodes[number], ticks));
  }
}

Bone to_bone(const aiBone& bone, std::size_t points, const Gathering& gathering) {
  const int node = find_node(gathering, bone.mName.C_Str());
  if (node < 0)
    throw std::runtime_error(fmt::format("its bone {} is no node of the file's scene: put it there",
                                         in_quotes(bone.mName.C_Str())));
  Bone result{to_matrix(bone.mOffsetMatrix), node, {}};
  for (unsigned i = 0; i < bone.mNumWeights; ++i) {
    const aiVertexWeight& weight = bone.mWeights[i];
    if (weight.mVertexId >= points)
      throw std::runtime_error("a bone names a point that the file does not have");
    if (weight.mWeight != 0) result.shares.emplace_back(static_cast<int>(weight.mVertexId), weight.mWeight);
  }
  return result;
}

void gather_surface(const aiMesh& mesh, FigureSurface& surface, Gathering& gathering) {
  if (mesh.HasBones() && !gathering.skinned.insert(&mesh).second)
    throw std::runtime_error(
        fmt::format("its skinned mesh {} hangs on several nodes: give each one a mesh of its own",
                    in_quotes(mesh.mName.C_Str())));
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) surface.points.push_back(to_point(mesh.mVertices[v]));
  for (unsigned b = 0; b < mesh.mNumBones; ++b)
    surface.bones.push_back(to_bone(*mesh.mBones[b], surface.points.size(), gathering));
}

void gather_surfaces(Gathering& gathering) {
  auto surface = gathering.figure.surfaces.begin();
  for (const aiNode* node : gathering.nodes)
    for (unsigned i = 0; i < node->mNumMeshes; ++i)
      gather_surface(*gathering.scene.mMeshes[node->mMeshes[i]], *surface++, gathering);
}

// Without an animation it is at rest.
Figure gather_figure(const aiScene& scene, const aiAnimation* animation) {
  Gathering gathering{scene, {}, {}, {}, {}};
  gather_nodes(*scene.mRootNode, -1, gathering);
  if (animation) gather_motions(*animation, gathering);
  gather_surfaces(gathering);
  check_figure(gathering.figure);
  return std::move(gathering.figure);
}

// "'walk' (0), 'run' (1)"
std::string list_animations(const aiScene& scene) {
  constexpr unsigned most_listed = 16;
  std::string names;
  for (unsigned a = 0; a < std::min(scene.mNumAnimations, most_listed); ++a)
    names += fmt::format("{}{} ({})", a == 0 ? "" : ", ", in_quotes(scene.mAnimations[a]->mName.C_Str()), a);
  if (scene.mNumAnimations > most_listed)
    names += fmt::format(" and {} more", scene.mNumAnimations - most_listed);
  return names;
}

const aiAnimation& find_animation(const aiScene& scene, const std::string& name) {
  for (unsigned a = 0; a < scene.mNumAnimations; ++a)
    if (scene.mAnimations[a]->mName.C_Str() == name) return *scene.mAnimations[a];
  for (unsigned a = 0; a < scene.mNumAnimations; ++a)
    if (std::to_string(a) == name) return *scene.mAnimations[a];
  if (scene.mNumAnimations == 0) throw UnknownClip("has no animation");
  throw UnknownClip(fmt::format("has no animation {}; it has {}", in_quotes(name), list_animations(scene)));
}

// At one shape each interval, from 0 to the end of the last one.
std::size_t count_shapes(double duration, double interval, std::size_t points) {
  constexpr double most_shape_points = 30e6;  // a third of the memory that this process may have
  const double count = std::ceil(duration / interval - 1e-6) + 1;
  if (!(count >= 1)) throw std::runtime_error("its animation ends before it begins");
  if (count * static_cast<double>(points) > most_shape_points)
    throw std::runtime_error(fmt::format(
        "its animation would be {:.10g} shapes of {} points, over the most of {:.0f} points in all: "
        "take fewer frames a second, a shorter clip or a simpler mesh",
        count, points, most_shape_points));
  return static_cast<std::size_t>(count);
}

std::vector<Vec3> check_usable(std::vector<Vec3> points) {
  for (const Vec3& point : points)
    for (const double x : point)
      if (!is_usable_coordinate(x)) throw std::runtime_error("its nodes lead to points that are not usable");
  return points;
}

bool has_bones(const aiScene& scene) {
  return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                     [](const aiMesh* mesh) { return mesh->HasBones(); });
}

// What the importer would leave out without a word.
void refuse_what_is_lost(const fs::path& path, const aiAnimation& animation) {
  const bool is_gltf = path.extension() == ".gltf" || path.extension() == ".glb";
  if (is_gltf && has_spline_keys(read_file(path)))
    throw std::runtime_error(
        "the keys of its animations, or of some of them, are joined by cubic splines, which cannot be read: "
        "export them sampled at each frame, and linear");
  if (animation.mNumMorphMeshChannels > 0)
    throw std::runtime_error(
        "its animation moves morph targets, which cannot be read; bake it into a sequence of .obj");
}

}  // namespace

PolygonSoup import_with_assimp(const fs::path& path) {
  Assimp::Importer importer;
  const aiScene& scene = read_scene(importer, path);
  PolygonSoup soup = soup_of(scene);
  if (has_bones(scene)) soup.points = check_usable(pose_figure(gather_figure(scene, nullptr), 0));
  return soup;
}

SoupInShapes import_clip_with_assimp(const fs::path& path, const ClipRequest& clip) {
  Assimp::Importer importer;
  const aiScene& scene = read_scene(importer, path);
  const aiAnimation& animation = find_animation(scene, clip.name);
  refuse_what_is_lost(path, animation);
  const double duration = animation.mDuration / ticks_per_second(animation);
  SoupInShapes result{soup_of(scene), {}};
  const std::size_t count = count_shapes(duration, clip.interval, result.soup.points.size());
  const Figure figure = gather_figure(scene, &animation);
  importer.FreeScene();  // which may be as large as the shapes

  result.shapes.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    result.shapes.push_back(check_usable(pose_figure(figure, static_cast<double>(i) * clip.interval)));
  result.soup.points = result.shapes.front();
  return result;
}

}  // namespace drape

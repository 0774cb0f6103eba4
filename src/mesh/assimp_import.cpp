#include "mesh/assimp_import.h"

#include <assimp/MemoryIOWrapper.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <memory>
#include <stdexcept>

#include "core/file.h"
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

PolygonSoup import_with_assimp(const fs::path& path) {
  auto* const folder = new OneFolder(path);
  Assimp::Importer importer;
  importer.SetIOHandler(folder);  // which owns it from here on
  if (!importer.IsExtensionSupported(path.extension().string()))
    throw std::runtime_error(
        in_quotes(path.extension().string()) +
        " is the ending of no format of meshes that can be read; use .obj, .ply, .stl or .glb");
  const aiScene* const scene = importer.ReadFile(path.string(), 0);
  if (!scene || !scene->mRootNode) fail(importer, *folder);

  PolygonSoup soup;
  append_node(*scene, *scene->mRootNode, aiMatrix4x4(), soup);
  if (soup.polygon_ends.empty()) throw std::runtime_error("it holds no faces");
  if (soup.uvs.size() == soup.points.size()) soup.corner_uvs = soup.corner_points;
  return soup;
}

}  // namespace drape

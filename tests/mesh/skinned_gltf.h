#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace drape::test {

// A glTF file, to be altered and written: a triangle whose bottom is held by the joint "low" in the origin,
// and whose tip (0, 2, 0) by its child "high" at (0, 1, 0). In the one second of "bend", "high" turns by 90
// degrees about z: the tip goes to (-1, 1, 0).
struct SkinnedGltf {
  std::vector<std::array<float, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  std::vector<std::array<float, 2>> uvs = {{0, 0}, {1, 0}, {0, 1}};
  std::vector<std::array<std::uint8_t, 4>> joints = {{0, 1, 0, 0}, {0, 1, 0, 0}, {0, 1, 0, 0}};
  std::vector<std::array<float, 4>> weights = {{1, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}};
  std::vector<std::uint16_t> corners = {0, 1, 2};
  std::vector<float> times = {0, 1};
  std::vector<std::array<float, 4>> turns = {{0, 0, 0, 1}, {0, 0, std::sqrt(0.5f), std::sqrt(0.5f)}};
  std::string low = R"({"name":"low","children":[1]})";
  std::string high = R"({"name":"high","translation":[0,1,0]})";
  std::string body = R"({"name":"body","mesh":0,"skin":0})";
  std::string more_nodes;  // with a comma before each
  std::string roots = "0,2";
  std::string interpolation = "LINEAR";
  std::vector<std::string> animations = {"bend"};  // all the same
  bool has_byte_weights = false;                   // normalised, as exporters write them to save space
};

class GltfNumbers {
 public:
  // An accessor to be numbered by the order of calls.
  template <typename Item>
  void add(const std::vector<Item>& items, const std::string& component, const std::string& type) {
    const std::string comma = accessors_.empty() ? "" : ",";
    const std::size_t size = items.size() * sizeof(Item);
    views_ += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(bytes_.size()) + R"(,"byteLength":)" +
              std::to_string(size) + "}";
    accessors_ += comma + R"({"bufferView":)" + std::to_string(count_++) + R"(,"componentType":)" +
                  component + R"(,"count":)" + std::to_string(items.size()) + R"(,"type":")" + type + R"("})";
    bytes_.append(reinterpret_cast<const char*>(items.data()), size);
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
  }

  const std::string& bytes() const { return bytes_; }
  std::string json(const std::string& uri) const {
    return R"("buffers":[{"uri":")" + uri + R"(","byteLength":)" + std::to_string(bytes_.size()) +
           R"(}],"bufferViews":[)" + views_ + R"(],"accessors":[)" + accessors_ + "]";
  }

 private:
  std::string bytes_, views_, accessors_;
  int count_ = 0;
};

inline std::vector<std::array<std::uint8_t, 4>> as_bytes(const std::vector<std::array<float, 4>>& weights) {
  std::vector<std::array<std::uint8_t, 4>> bytes(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (int k = 0; k < 4; ++k) bytes[i][k] = static_cast<std::uint8_t>(std::lround(255 * weights[i][k]));
  return bytes;
}

inline GltfNumbers numbers_of(const SkinnedGltf& gltf) {
  const std::string byte = "5121", number_of_16_bits = "5123", real = "5126";
  const std::vector<std::array<float, 16>> from_surface = {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
                                                           {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}};
  GltfNumbers numbers;
  numbers.add(gltf.points, real, "VEC3");
  numbers.add(gltf.uvs, real, "VEC2");
  numbers.add(gltf.joints, byte, "VEC4");
  if (gltf.has_byte_weights)
    numbers.add(as_bytes(gltf.weights), byte, "VEC4");
  else
    numbers.add(gltf.weights, real, "VEC4");
  numbers.add(gltf.corners, number_of_16_bits, "SCALAR");
  numbers.add(from_surface, real, "MAT4");
  numbers.add(gltf.times, real, "SCALAR");
  numbers.add(gltf.turns, real, "VEC4");
  return numbers;
}

inline std::string animations_of(const SkinnedGltf& gltf) {
  std::string text;
  for (const std::string& name : gltf.animations)
    text += (text.empty() ? "" : ",") + (R"({"name":")" + name) +
            R"(","samplers":[{"input":6,"output":7,"interpolation":")" + gltf.interpolation +
            R"("}],"channels":[{"sampler":0,"target":{"node":1,"path":"rotation"}}]})";
  return text;
}

inline std::filesystem::path write(const TemporaryFolder& folder, const SkinnedGltf& gltf) {
  const GltfNumbers numbers = numbers_of(gltf);
  folder.write("numbers.bin", numbers.bytes());
  return folder.write(
      "body.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + gltf.roots +
                       R"(]}],"nodes":[)" + gltf.low + "," + gltf.high + "," + gltf.body + gltf.more_nodes +
                       R"(],"meshes":[{"name":"skin","primitives":[{)" +
                       R"("attributes":{"POSITION":0,"TEXCOORD_0":1,"JOINTS_0":2,"WEIGHTS_0":3},)" +
                       R"("indices":4}]}],"skins":[{"joints":[0,1],"inverseBindMatrices":5}],)" +
                       R"("animations":[)" + animations_of(gltf) + "]," + numbers.json("numbers.bin") + "}");
}

}  // namespace drape::test

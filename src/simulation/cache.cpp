#include "simulation/cache.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/error.h"
#include "core/file.h"
#include "core/hash.h"
#include "simulation/colliders.h"

namespace drape {
namespace {
namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "the files hold numbers as this machine does");

enum class Kind : std::uint32_t { frame = 1, checkpoint = 2 };
constexpr std::string_view magic("DRAPE\0\0\0", 8);
constexpr std::uint32_t format_version = 6;
constexpr int compression_level = 1;  // positions hardly compress further, and each frame waits for it

// What stands before the compressed content. `hash` covers the fields after it and the compressed content, so
// that nothing of a damaged file is believed.
struct Header {
  char magic[8];
  std::uint64_t hash;
  std::uint32_t version;
  Kind kind;
  std::uint64_t fingerprint;
  std::uint64_t content_size;
};
constexpr std::size_t hashed_from = offsetof(Header, version);

class ContentWriter {
 public:
  template <typename Item>
  void add(const Item& item) {
    static_assert(std::is_trivially_copyable_v<Item>);
    bytes_.append(reinterpret_cast<const char*>(&item), sizeof item);
  }

  // Items are numbers, Eigen's matrices (arrays of their coefficients, by columns), or made of these without
  // gaps.
  template <typename Item>
  void add_all(const std::vector<Item>& items) {
    add<std::uint64_t>(items.size());
    bytes_.append(reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item));
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Each take is false where the content is too short.
class ContentReader {
 public:
  explicit ContentReader(std::string_view bytes) : bytes_(bytes) {}

  template <typename Item>
  bool take(Item& item) {
    static_assert(std::is_trivially_copyable_v<Item>);
    return take_bytes(&item, sizeof item);
  }

  template <typename Item>
  bool take_all(std::vector<Item>& items) {
    std::uint64_t count = 0;
    if (!take(count) || count > bytes_.size() / sizeof(Item)) return false;
    items.resize(count);
    return take_bytes(items.data(), count * sizeof(Item));
  }

  bool at_end() const { return bytes_.empty(); }

 private:
  bool take_bytes(void* target, std::size_t size) {
    if (bytes_.size() < size) return false;
    if (size > 0) std::memcpy(target, bytes_.data(), size);
    bytes_.remove_prefix(size);
    return true;
  }

  std::string_view bytes_;
};

static_assert(sizeof(RigidPose) == 12 * sizeof(double), "poses are written as they lie in memory");

std::string compress(const std::string& content) {
  std::string compressed(ZSTD_compressBound(content.size()), '\0');
  const std::size_t size =
      ZSTD_compress(compressed.data(), compressed.size(), content.data(), content.size(), compression_level);
  if (ZSTD_isError(size)) throw std::bad_alloc();  // the only error there is with a buffer of that size
  compressed.resize(size);
  return compressed;
}

// Nothing where the bytes are not one whole content of `size` bytes. Memory grows with what comes out, never
// by what the header claims.
std::optional<std::string> decompress(std::string_view compressed, std::uint64_t size) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                          &ZSTD_freeDStream);
  std::string content, piece(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer input{compressed.data(), compressed.size(), 0};
  std::size_t left = 1;
  while (left != 0) {
    ZSTD_outBuffer output{piece.data(), piece.size(), 0};
    left = ZSTD_decompressStream(stream.get(), &output, &input);
    const bool stuck = output.pos == 0 && input.pos == input.size && left != 0;
    if (ZSTD_isError(left) || stuck || output.pos > size - content.size()) return std::nullopt;
    content.append(piece.data(), output.pos);
  }
  if (content.size() != size || input.pos != input.size) return std::nullopt;
  return content;
}

std::uint64_t hash_of(const Header& header, std::string_view compressed) {
  Hasher hasher;
  hasher.add(reinterpret_cast<const char*>(&header) + hashed_from, sizeof header - hashed_from);
  hasher.add(compressed.data(), compressed.size());
  return hasher.digest();
}

void write(const fs::path& path, Kind kind, std::uint64_t fingerprint, const std::string& content) {
  const std::string compressed = compress(content);
  Header header{{}, 0, format_version, kind, fingerprint, content.size()};
  magic.copy(header.magic, magic.size());
  header.hash = hash_of(header, compressed);
  write_file(path, std::string(reinterpret_cast<const char*>(&header), sizeof header) + compressed);
}

[[noreturn]] void fail_damaged(const fs::path& path, const std::string& how) {
  throw FileError(path.string(), "is damaged (" + how + "); delete it and run 'drape simulate' again");
}

struct Stored {
  Header header;
  std::string compressed;
};

bool is_there(const fs::path& path) {
  std::error_code error;
  const bool found = fs::exists(path, error);
  if (error) throw FileError(path.string(), "cannot be read: " + error.message());
  return found;
}

Stored read(const fs::path& path, Kind kind) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) throw FileError(path.string(), "is not a regular file");
  std::string bytes = read_file(path);
  Stored stored;
  if (bytes.size() < sizeof(Header)) fail_damaged(path, "it is too short");
  std::memcpy(&stored.header, bytes.data(), sizeof(Header));
  if (std::string_view(stored.header.magic, magic.size()) != magic)
    fail_damaged(path, "it is no file of Drape's cache");
  stored.compressed = bytes.substr(sizeof(Header));
  if (hash_of(stored.header, stored.compressed) != stored.header.hash)
    fail_damaged(path, "its hash does not fit its content");
  if (stored.header.kind != kind) fail_damaged(path, "it holds something else than its name says");
  return stored;
}

std::string content_of(const fs::path& path, const Stored& stored) {
  auto content = decompress(stored.compressed, stored.header.content_size);
  if (!content) fail_damaged(path, "its content cannot be unpacked");
  return std::move(*content);
}

void check_origin(const fs::path& path, const Header& header, std::uint64_t fingerprint) {
  if (header.version != format_version)
    throw FileError(path.string(),
                    fmt::format("has version {} of the cache's format, and this program reads {}; run "
                                "'drape simulate' again",
                                header.version, format_version));
  if (header.fingerprint != fingerprint)
    throw FileError(path.string(),
                    fmt::format("was made from other settings (fingerprint {}, the scene has {}); run "
                                "'drape simulate' again",
                                to_hex(header.fingerprint), to_hex(fingerprint)));
}

fs::path checkpoint_path(const fs::path& folder) { return folder / "checkpoint.drape"; }

}  // namespace

// Where rigid colliders are, their poses say.
static std::vector<Vec3f> deformed_points(const State& state, const std::vector<ColliderInput>& colliders) {
  std::vector<Vec3f> points;
  auto next = state.collider_points.begin();
  for (const ColliderInput& collider : colliders) {
    const auto end = next + static_cast<std::ptrdiff_t>(collider_primitives(collider.shape).points.size());
    if (deforms(collider))
      std::for_each(next, end, [&](const Vec3& p) { points.push_back(p.cast<float>()); });
    next = end;
  }
  return points;
}

CachedFrame to_cached_frame(const State& state, const std::vector<ColliderInput>& colliders) {
  CachedFrame frame;
  frame.frame = state.frame;
  frame.state_hash = state_hash(state);
  frame.collider_poses = state.collider_poses;
  frame.collider_points = deformed_points(state, colliders);
  frame.positions.reserve(state.positions.size());
  for (const Vec3& position : state.positions) frame.positions.push_back(position.cast<float>());
  return frame;
}

fs::path cached_frame_path(const fs::path& folder, int frame) {
  return folder / fmt::format("frame_{:04}.drape", frame);
}

void write_cached_frame(const fs::path& folder, std::uint64_t fingerprint, const CachedFrame& frame) {
  ContentWriter content;
  content.add<std::int64_t>(frame.frame);
  content.add(frame.state_hash);
  content.add_all(frame.positions);
  content.add_all(frame.collider_poses);
  content.add_all(frame.collider_points);
  write(cached_frame_path(folder, frame.frame), Kind::frame, fingerprint, content.bytes());
}

CachedFrame read_cached_frame(const fs::path& folder, std::uint64_t fingerprint, int frame) {
  const fs::path path = cached_frame_path(folder, frame);
  if (!is_there(path)) throw FileError(path.string(), "is missing; run 'drape simulate' first");
  const Stored stored = read(path, Kind::frame);
  check_origin(path, stored.header, fingerprint);

  const std::string bytes = content_of(path, stored);
  ContentReader content(bytes);
  CachedFrame cached;
  std::int64_t number = 0;
  if (!content.take(number) || !content.take(cached.state_hash) || !content.take_all(cached.positions) ||
      !content.take_all(cached.collider_poses) || !content.take_all(cached.collider_points) ||
      !content.at_end())
    fail_damaged(path, "its sizes disagree");
  if (number != frame) fail_damaged(path, fmt::format("it holds frame {}", number));
  cached.frame = frame;
  return cached;
}

void write_checkpoint(const fs::path& folder, std::uint64_t fingerprint, const State& state) {
  ContentWriter content;
  content.add<std::int64_t>(state.frame);
  content.add_all(state.positions);
  content.add_all(state.velocities);
  content.add_all(state.collider_points);
  content.add_all(state.collider_times);
  content.add_all(state.collider_poses);
  content.add_all(state.grabs);
  content.add_all(state.seam_lengths);
  content.add_all(state.remembered_contacts);
  content.add(state.contacts);
  content.add_all(state.still_positions);
  content.add_all(state.later_positions);
  content.add(state.still_since);
  write(checkpoint_path(folder), Kind::checkpoint, fingerprint, content.bytes());
}

static bool each_point_has_all(const State& state) {
  const std::size_t count = state.positions.size();
  return state.velocities.size() == count && state.still_positions.size() == count &&
         state.later_positions.size() == count;
}

std::optional<State> read_checkpoint(const fs::path& folder, std::uint64_t fingerprint) {
  const fs::path path = checkpoint_path(folder);
  if (!is_there(path)) return std::nullopt;
  const Stored stored = read(path, Kind::checkpoint);
  if (stored.header.version != format_version || stored.header.fingerprint != fingerprint)
    return std::nullopt;

  const std::string bytes = content_of(path, stored);
  ContentReader content(bytes);
  State state;
  std::int64_t frame = 0;
  const bool whole = content.take(frame) && content.take_all(state.positions) &&
                     content.take_all(state.velocities) && content.take_all(state.collider_points) &&
                     content.take_all(state.collider_times) && content.take_all(state.collider_poses) &&
                     content.take_all(state.grabs) && content.take_all(state.seam_lengths) &&
                     content.take_all(state.remembered_contacts) && content.take(state.contacts) &&
                     content.take_all(state.still_positions) && content.take_all(state.later_positions) &&
                     content.take(state.still_since) && content.at_end();
  const bool makes_sense = whole && frame >= 0 && frame <= std::numeric_limits<int>::max() &&
                           each_point_has_all(state) && state.contacts >= 0;
  if (!makes_sense) fail_damaged(path, "its sizes disagree");
  if (state.still_since < 0 || state.still_since > frame) fail_damaged(path, "its frames disagree");
  state.frame = static_cast<int>(frame);
  return state;
}

}  // namespace drape

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "core/error.h"
#include "core/hash.h"
#include "simulation/cache.h"
#include "temporary_folder.h"

namespace drape {
namespace {

using test::TemporaryFolder;

constexpr std::uint64_t fingerprint = 0x1234;

RigidPose a_pose() { return {rotation_from_degrees({10, 20, 30}), Vec3(1, 2, 3)}; }

CachedFrame a_frame(int number = 7) {
  CachedFrame frame{number, 0xabcdef, {}, {a_pose(), RigidPose{}}, {{1, 2, 3}, {4, 5, 6}}};
  for (int i = 0; i < 1000; ++i) frame.positions.emplace_back(float(i) / 3, -float(i), 1e-30f * float(i));
  return frame;
}

State a_state() {
  State state;
  state.frame = 12;
  state.collider_points = {{1, 2, 3}, {4, 5, 6}};
  state.collider_times = {0.1};
  state.collider_poses = {a_pose()};
  state.grabs = {{7, 8, 9}};
  state.seam_lengths = {0.5, 0.25};
  state.contacts = 17;
  state.still_since = 5;
  state.remembered_contacts = {{{1, 2}, {3, 4, 5, 6}, 1, {1e-9, {1, 2, 1e-300}, 7}}};
  for (int i = 0; i < 500; ++i) {
    state.positions.emplace_back(i / 3.0, -i, 1e-300 * i);
    state.velocities.emplace_back(i, 0.1 * i, -0.0);
    state.still_positions.emplace_back(-i, 0.3 * i, 1e-300);
    state.later_positions.emplace_back(i, -0.7 * i, 0.5);
  }
  return state;
}

std::string failure(const TemporaryFolder& folder, int frame = 7, std::uint64_t origin = fingerprint) {
  try {
    read_cached_frame(folder.path(), origin, frame);
    return "read";
  } catch (const FileError& error) {
    return error.what();
  }
}

void expect_same(const RigidPose& a, const RigidPose& b) {
  EXPECT_EQ(a.rotation, b.rotation);
  EXPECT_EQ(a.translation, b.translation);
}

TEST(CachedFrames, AreNamedByTheirNumber) {
  EXPECT_EQ(cached_frame_path("folder", 1), "folder/frame_0001.drape");
  EXPECT_EQ(cached_frame_path("folder", 12345), "folder/frame_12345.drape");
}

TEST(CachedFrames, ComeBackBitForBit) {
  const TemporaryFolder folder;
  const CachedFrame frame = a_frame();
  write_cached_frame(folder / "new/cache", fingerprint, frame);
  const CachedFrame same = read_cached_frame(folder / "new/cache", fingerprint, 7);
  EXPECT_EQ(same.frame, 7);
  EXPECT_EQ(same.state_hash, frame.state_hash);
  EXPECT_EQ(same.positions, frame.positions);
  ASSERT_EQ(same.collider_poses.size(), 2u);
  expect_same(same.collider_poses[0], frame.collider_poses[0]);
  expect_same(same.collider_poses[1], frame.collider_poses[1]);
  EXPECT_EQ(same.collider_points, frame.collider_points);
}

TEST(CachedFrames, MayBeEmpty) {
  const TemporaryFolder folder;
  write_cached_frame(folder.path(), fingerprint, CachedFrame{});
  EXPECT_TRUE(read_cached_frame(folder.path(), fingerprint, 0).positions.empty());
}

TEST(CachedFrames, EqualFramesGiveEqualFiles) {
  const TemporaryFolder folder;
  write_cached_frame(folder / "a", fingerprint, a_frame());
  write_cached_frame(folder / "b", fingerprint, a_frame());
  EXPECT_EQ(read_file(cached_frame_path(folder / "a", 7)), read_file(cached_frame_path(folder / "b", 7)));
}

TEST(CachedFrames, Missing) {
  const TemporaryFolder folder;
  EXPECT_EQ(failure(folder),
            (folder / "frame_0007.drape").string() + ": is missing; run 'drape simulate' first");
}

TEST(CachedFrames, MadeFromOtherSettings) {
  const TemporaryFolder folder;
  write_cached_frame(folder.path(), fingerprint, a_frame());
  EXPECT_EQ(failure(folder, 7, 0x99), (folder / "frame_0007.drape").string() +
                                          ": was made from other settings (fingerprint 0000000000001234, the "
                                          "scene has 0000000000000099); run "
                                          "'drape simulate' again");
}

TEST(CachedFrames, Renamed) {
  const TemporaryFolder folder;
  write_cached_frame(folder.path(), fingerprint, a_frame(3));
  std::filesystem::rename(folder / "frame_0003.drape", folder / "frame_0007.drape");
  EXPECT_EQ(failure(folder), (folder / "frame_0007.drape").string() +
                                 ": is damaged (it holds frame 3); delete it and run 'drape simulate' again");
}

TEST(CachedFrames, NotAFileOfTheCache) {
  const TemporaryFolder folder;
  folder.write("frame_0007.drape", std::string(100, 'x'));
  EXPECT_EQ(failure(folder),
            (folder / "frame_0007.drape").string() +
                ": is damaged (it is no file of Drape's cache); delete it and run 'drape simulate' "
                "again");
  std::filesystem::remove(folder / "frame_0007.drape");
  std::filesystem::create_directory(folder / "frame_0007.drape");
  EXPECT_EQ(failure(folder), (folder / "frame_0007.drape").string() + ": is not a regular file");
}

TEST(CachedFrames, InAFolderThatCannotBeFollowed) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_THROW(read_cached_frame(folder / "loop", fingerprint, 7), FileError);
  EXPECT_THROW(read_checkpoint(folder / "loop", fingerprint), FileError);
}

TEST(CachedFrames, ACheckpointIsNoFrame) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path(), fingerprint, a_state());
  std::filesystem::rename(folder / "checkpoint.drape", folder / "frame_0007.drape");
  EXPECT_NE(failure(folder).find("it holds something else than its name says"), std::string::npos);
}

TEST(CachedFrames, EveryTruncationIsSeen) {
  const TemporaryFolder folder;
  write_cached_frame(folder.path(), fingerprint, a_frame());
  const std::string bytes = read_file(folder / "frame_0007.drape");
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 16) {
    folder.write("frame_0007.drape", bytes.substr(0, size));
    EXPECT_NE(failure(folder).find("is damaged"), std::string::npos) << size;
  }
}

TEST(CachedFrames, EveryFlippedBitIsSeen) {
  const TemporaryFolder folder;
  write_cached_frame(folder.path(), fingerprint, a_frame());
  std::string bytes = read_file(folder / "frame_0007.drape");
  for (std::size_t at = 0; at < bytes.size(); at += at < 64 ? 1 : 97) {
    const char before = bytes[at];
    bytes[at] = static_cast<char>(before ^ 4);
    folder.write("frame_0007.drape", bytes);
    EXPECT_NE(failure(folder).find("is damaged"), std::string::npos) << at;
    bytes[at] = before;
  }
}

// The header: magic (8 bytes), hash (8), version (4), kind (4), fingerprint (8), size (8).
std::string forged(std::string bytes, std::size_t at, std::uint64_t value, std::size_t size) {
  std::memcpy(bytes.data() + at, &value, size);
  const std::uint64_t hash = hash_bytes(bytes.data() + 16, bytes.size() - 16);
  std::memcpy(bytes.data() + 8, &hash, sizeof hash);
  return bytes;
}

TEST(CachedFrames, SizesAreNotBelieved) {
  const TemporaryFolder folder;
  write_cached_frame(folder.path(), fingerprint, a_frame());
  const std::string bytes = read_file(folder / "frame_0007.drape");
  for (const std::uint64_t size :
       {std::uint64_t{0}, std::uint64_t{100}, std::numeric_limits<std::uint64_t>::max()}) {
    folder.write("frame_0007.drape", forged(bytes, 32, size, 8));
    EXPECT_NE(failure(folder).find("its content cannot be unpacked"), std::string::npos);
  }
}

TEST(CachedFrames, OfAnotherVersion) {
  const TemporaryFolder folder;
  write_cached_frame(folder.path(), fingerprint, a_frame());
  folder.write("frame_0007.drape", forged(read_file(folder / "frame_0007.drape"), 16, 1, 4));
  EXPECT_EQ(failure(folder),
            (folder / "frame_0007.drape").string() +
                ": has version 1 of the cache's format, and this program reads 6; run 'drape "
                "simulate' again");
}

TEST(Checkpoints, ComeBackBitForBit) {
  const TemporaryFolder folder;
  const State state = a_state();
  write_checkpoint(folder.path(), fingerprint, state);
  const auto same = read_checkpoint(folder.path(), fingerprint);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->frame, 12);
  EXPECT_EQ(same->positions, state.positions);
  EXPECT_EQ(same->collider_points, state.collider_points);
  EXPECT_EQ(same->collider_times, state.collider_times);
  EXPECT_EQ(same->grabs, state.grabs);
  EXPECT_EQ(same->seam_lengths, state.seam_lengths);
  EXPECT_EQ(same->contacts, state.contacts);
  EXPECT_EQ(same->still_positions, state.still_positions);
  EXPECT_EQ(same->later_positions, state.later_positions);
  EXPECT_EQ(same->still_since, state.still_since);
  ASSERT_EQ(same->remembered_contacts.size(), 1u);
  EXPECT_EQ(std::memcmp(same->remembered_contacts.data(), state.remembered_contacts.data(),
                        sizeof(RememberedContact)),
            0);
  ASSERT_EQ(same->velocities.size(), state.velocities.size());
  EXPECT_EQ(
      std::memcmp(same->velocities.data(), state.velocities.data(), state.velocities.size() * sizeof(Vec3)),
      0);
  expect_same(same->collider_poses.at(0), a_pose());
}

TEST(Checkpoints, TheLastOneWins) {
  const TemporaryFolder folder;
  State state = a_state();
  write_checkpoint(folder.path(), fingerprint, state);
  state.frame = 13;
  write_checkpoint(folder.path(), fingerprint, state);
  EXPECT_EQ(read_checkpoint(folder.path(), fingerprint)->frame, 13);
}

TEST(Checkpoints, NoneThereOrOfSomethingElse) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_checkpoint(folder.path(), fingerprint));
  write_checkpoint(folder.path(), fingerprint, a_state());
  EXPECT_FALSE(read_checkpoint(folder.path(), fingerprint + 1));
  folder.write("checkpoint.drape", forged(read_file(folder / "checkpoint.drape"), 16, 1, 4));
  EXPECT_FALSE(read_checkpoint(folder.path(), fingerprint));
}

TEST(Checkpoints, Damaged) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path(), fingerprint, a_state());
  const std::string bytes = read_file(folder / "checkpoint.drape");
  folder.write("checkpoint.drape", bytes.substr(0, bytes.size() / 2));
  EXPECT_THROW(read_checkpoint(folder.path(), fingerprint), FileError);
}

void expect_refused(const State& state) {
  const TemporaryFolder folder;
  write_checkpoint(folder.path(), fingerprint, state);
  EXPECT_THROW(read_checkpoint(folder.path(), fingerprint), FileError);
}

TEST(Checkpoints, EachPointNeedsItsVelocityAndItsEarlierPlaces) {
  for (auto State::*points : {&State::velocities, &State::still_positions, &State::later_positions}) {
    State state = a_state();
    (state.*points).pop_back();
    expect_refused(state);
  }
}

TEST(Checkpoints, NothingLiesStillSinceAFrameToCome) {
  for (const int frame : {-1, 13}) {
    State state = a_state();
    state.still_since = frame;
    expect_refused(state);
  }
}

}  // namespace
}  // namespace drape

#include <gtest/gtest.h>

#include <algorithm>

#include "app/manifest.h"
#include "app/run_program.h"
#include "core/file.h"
#include "render/png_file.h"
#include "simulation/cache.h"

namespace drape::app {
namespace {
namespace fs = std::filesystem;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool has_red(const render::Image& image) {
  for (std::size_t i = 0; i + 2 < image.rgb.size(); i += 3)
    if (image.rgb[i] > 120 && image.rgb[i + 1] < 60 && image.rgb[i + 2] < 60) return true;
  return false;
}

// Three frames of a napkin of 6 x 6 points, simulated.
class Verify : public testing::Test {
 protected:
  Finished verify(std::vector<std::string> flags = {}) {
    flags.insert(flags.begin(), {"verify", run});
    return run_drape(flags);
  }
  // Puts another frame in place of the simulated one.
  template <typename Change>
  void change_frame(int frame, const Change& change) {
    const std::uint64_t fingerprint = read_manifest(run + "/run.json")->fingerprint;
    CachedFrame cached = read_cached_frame(run + "/cache", fingerprint, frame);
    change(cached.positions);
    write_cached_frame(run + "/cache", fingerprint, cached);
  }
  // Pulls the first corner of the napkin through its middle.
  void force_intersection(int frame) {
    change_frame(frame, [](std::vector<Vec3f>& x) {
      x[0] = (x[14] + x[15] + x[20]) / 3 + Vec3f(0, 0.03f, 0);
      x[1] = x[0] + Vec3f(0.01f, -0.2f, 0);
    });
  }

  TemporaryFolder folder;
  std::string scene = write_scene(folder, "scene", 3);
  std::string run = (folder / "out").string();
  Finished simulated = run_drape({"simulate", scene, "-o", run});
};

TEST_F(Verify, CertifiesWhatWasSimulatedWithALineForEachFrame) {
  const Finished finished = verify();
  EXPECT_EQ(finished.exit_status, 0) << finished.err;
  EXPECT_EQ(std::count(finished.out.begin(), finished.out.end(), '\n'), 5) << finished.out;
  EXPECT_EQ(finished.out.substr(0, 6), "frame ");
  EXPECT_TRUE(contains(finished.out, "\n3      certified ")) << finished.out;
  EXPECT_TRUE(contains(finished.out, "drawn: pairs")) << finished.out;
  EXPECT_TRUE(contains(finished.out, "\ncertified: 3 frames\n")) << finished.out;
  EXPECT_FALSE(fs::exists(run + "/verify"));
  EXPECT_TRUE(contains(verify({"-f", "2"}).out, "\ncertified: 1 frame\n"));
}

TEST_F(Verify, FindsAForcedIntersectionAndDrawsIt) {
  force_intersection(2);
  const Finished finished = verify();
  EXPECT_EQ(finished.exit_status, 4);
  EXPECT_TRUE(contains(finished.out, "\n2      BAD ")) << finished.out;
  EXPECT_TRUE(contains(finished.out, "not certified: 1 of 3 frames, the worst is 2\n")) << finished.out;
  EXPECT_TRUE(contains(finished.err, "2: triangle 2 of napkin meets triangle 14 of napkin\n"))
      << finished.err;
  const std::string picture = run + "/verify/frame_0002.png";
  EXPECT_TRUE(contains(finished.err, "picture of the faces at fault: " + picture)) << finished.err;
  EXPECT_TRUE(has_red(render::read_png(picture)));
}

TEST_F(Verify, PutsThePictureWhereToldTo) {
  force_intersection(1);
  EXPECT_EQ(verify({"-o", (folder / "pictures").string()}).exit_status, 4);
  EXPECT_TRUE(fs::exists(folder / "pictures/frame_0001.png"));
  EXPECT_FALSE(fs::exists(run + "/verify"));
}

TEST_F(Verify, FindsClothInTheBallAndSaysHowDeep) {
  change_frame(3, [](std::vector<Vec3f>& x) {
    for (Vec3f& p : x) p.y() -= 0.05f;
  });
  const Finished finished = verify({"-f", "3"});
  EXPECT_EQ(finished.exit_status, 4);
  EXPECT_TRUE(contains(finished.out, " mm deep)")) << finished.out;
  EXPECT_TRUE(contains(finished.err, " of napkin is in a collider")) << finished.err;
}

TEST_F(Verify, FindsValuesThatAreNotFinite) {
  change_frame(2, [](std::vector<Vec3f>& x) { x[7].z() = std::nanf(""); });
  const Finished finished = verify();
  EXPECT_EQ(finished.exit_status, 4);
  EXPECT_TRUE(contains(finished.out, "\n2      NOT FINITE ")) << finished.out;
  EXPECT_TRUE(contains(finished.err, "2: point 8 is not finite\n")) << finished.err;
}

TEST_F(Verify, SaysAllInOneJsonObject) {
  force_intersection(2);
  const std::string out = verify({"--json"}).out;
  EXPECT_EQ(out.substr(0, 2), "{\n");
  EXPECT_EQ(out.substr(out.size() - 2), "}\n");
  for (const char* part : {"\"frames\": 3", "\"failed\": 1", "\"worst\": 2", "\"finite\": true",
                           "\"smallest_stretch\": ", "\"largest_stretch\": ", "\"simulated\": {",
                           "\"drawn\": {", "\"intersecting_pairs\": ", "\"smallest_gap_m\": 0.0",
                           "\"collider_triangles\": ", "\"collider_depth_m\": ", "\"each\": [",
                           "\"frame\": 3,\n   \"certified\": true", "\"frame\": 2,\n   \"certified\": false"})
    EXPECT_TRUE(contains(out, part)) << part << " is not in " << out;
}

// The napkin falls from 0.45 m: in a frame of a 24th of a second by 9 mm at most.
TEST_F(Verify, HoldsFramesToWhatTheSceneSaysOfThem) {
  const std::string facts = R"(test=[
      {what: highest, cloth: napkin, most: 0.4501, least: 0.44}, {what: lowest, least: 0.448},
      {what: middle_x, frames: 2-3, least: -1e-3, most: 1e-3}, {what: turn, frames: 30-31, most: 1},
      {what: largest_stretch, frames: 1-1, most: 0.5}])";
  const Finished finished = verify({"-D", facts, "-D", "time.frames=1-3", "-f", "1"});
  EXPECT_EQ(finished.exit_status, 4);
  for (const char* line :
       {"\nholds       highest of napkin, frames 1 to 3, at least 0.44, at most 0.4501: found 0.4",
        "\nFAILS       lowest, frames 1 to 3, at least 0.448: found 0.44",
        "\nnot tested  middle_x, frames 2 to 3, at least -0.001, at most 0.001: its frames "
        "were not looked at\n",
        "\nnot tested  turn, frames 30 to 31, at most 1: ",
        "\nFAILS       largest_stretch, frame 1, at most 0.5: found 1"})
    EXPECT_TRUE(contains(finished.out, line)) << line << " is not in " << finished.out;
  EXPECT_TRUE(
      contains(finished.out, "\ncertified: 1 frame, but 2 of the 5 facts of the scene's `test` fail\n"))
      << finished.out;
  const std::string json = verify({"-D", facts, "-D", "time.frames=1-3", "--json"}).out;
  for (const char* part : {"\"test\": [", "\"fact\": \"lowest, frames 1 to 3, at least 0.448\"",
                           "\"holds\": false", "\"frame\": 3"})
    EXPECT_TRUE(contains(json, part)) << part << " is not in " << json;
}

TEST_F(Verify, FactsThatHoldLeaveTheExitStatusAlone) {
  const Finished finished =
      verify({"-D", "test=[{what: kinetic_energy, most: 10}, {what: smallest_gap, least: 1e-6}]"});
  EXPECT_EQ(finished.exit_status, 0) << finished.out;
}

// A quarter turn about the vertical, and the middle carried along.
TEST_F(Verify, TurnsAndPlacesAreThoseOfTheCloth) {
  change_frame(3, [](std::vector<Vec3f>& x) {
    for (Vec3f& p : x) p = Vec3f(p.z() + 2, p.y() + 1, -p.x());
  });
  const Finished finished = verify({"-D", R"(test=[{what: turn, frames: 3-3, least: 89.9, most: 90.1},
      {what: middle_x, frames: 3-3, least: 1.99, most: 2.01}, {what: middle_z, frames: 3-3, least: -0.01, most: 0.01}])"});
  EXPECT_EQ(finished.exit_status, 0) << finished.out;
}

TEST_F(Verify, SaysWhichFramesAreMissingAndWhatToDo) {
  const Finished none = run_drape({"verify", write_scene(folder, "new", 2)});
  EXPECT_EQ(none.exit_status, 3);
  EXPECT_TRUE(contains(none.err, "there is no frame 1 yet: run 'drape simulate ")) << none.err;
  fs::remove(run + "/cache/frame_0003.drape");
  const Finished part = verify();
  EXPECT_EQ(part.exit_status, 3);
  EXPECT_TRUE(contains(part.err, "or verify those that are there: -f 1-2")) << part.err;
}

TEST_F(Verify, RefusesWhatDoesNotGoTogether) {
  EXPECT_EQ(verify({scene}).exit_status, 2);
  EXPECT_EQ(verify({"--rest", "flat.obj"}).exit_status, 2);
  const std::string obj = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").string();
  const Finished finished = run_drape({"verify", obj, "-f", "1"});
  EXPECT_EQ(finished.exit_status, 2);
  EXPECT_TRUE(contains(finished.err, "-f and -D are for scenes")) << finished.err;
}

TEST_F(Verify, CertifiesWhatWasExported) {
  for (const char* format : {"obj", "ply"}) {
    ASSERT_EQ(run_drape({"export", run, "--format", format}).exit_status, 0);
    const Finished finished = run_drape({"verify", run + "/" + format});
    EXPECT_EQ(finished.exit_status, 0) << finished.err;
    EXPECT_TRUE(contains(finished.out, "frame_0003." + std::string(format))) << finished.out;
    EXPECT_TRUE(contains(finished.out, "\ncertified: 3 frames\n")) << finished.out;
  }
}

// The ball stands on the floor: colliders may meet each other.
TEST_F(Verify, CertifiesWhatWasExportedWithColliders) {
  for (const char* format : {"obj", "ply"}) {
    ASSERT_EQ(run_drape({"export", run, "--colliders", "--format", format}).exit_status, 0);
    const Finished finished = run_drape({"verify", run + "/" + format});
    EXPECT_EQ(finished.exit_status, 0) << finished.err;
    EXPECT_TRUE(contains(finished.out, "\ncertified: 3 frames\n")) << finished.out;
    const std::string frame = run + "/" + format + "/frame_";
    EXPECT_EQ(run_drape({"verify", frame + "####." + format}).exit_status, 0);
    const Finished named = run_drape({"verify", frame + "0001." + format, frame + "0002." + format});
    EXPECT_EQ(named.exit_status, 0) << named.err;
    EXPECT_TRUE(contains(named.out, "\ncertified: 2 frames\n")) << named.out;
  }
}

TEST_F(Verify, FindsClothInAnExportedCollider) {
  change_frame(2, [](std::vector<Vec3f>& x) {
    for (Vec3f& p : x) p.y() -= 0.1f;
  });
  ASSERT_EQ(run_drape({"export", run, "--colliders"}).exit_status, 0);
  const Finished finished = run_drape({"verify", run + "/obj"});
  EXPECT_EQ(finished.exit_status, 4);
  EXPECT_TRUE(contains(finished.out, "1 of 3 frames, the worst is " + run + "/obj/frame_0002.obj"))
      << finished.out;
  EXPECT_TRUE(contains(finished.err, " is in a collider\n")) << finished.err;
}

TEST_F(Verify, FindsAnIntersectionInFilesOfOthers) {
  force_intersection(2);
  ASSERT_EQ(run_drape({"export", run}).exit_status, 0);
  const std::string pattern = run + "/obj/frame_####.obj";
  const Finished finished = run_drape({"verify", pattern, "--rest", run + "/obj/rest.obj"});
  EXPECT_EQ(finished.exit_status, 4);
  EXPECT_TRUE(contains(finished.out, "1 of 3 frames, the worst is " + run + "/obj/frame_0002.obj"));
  EXPECT_TRUE(contains(finished.err, "give a folder with -o")) << finished.err;
  const std::string pictures = (folder / "pictures").string();
  EXPECT_EQ(run_drape({"verify", pattern, "-o", pictures}).exit_status, 4);
  EXPECT_TRUE(has_red(render::read_png(pictures + "/frame_0002.png")));
}

class VerifiedRun : public testing::Test {
 protected:
  Manifest record() const { return *read_manifest(run + "/run.json"); }

  TemporaryFolder folder;
  std::string scene = write_scene(folder, "scene", 2);
  std::string run = (folder / "out").string();
};

TEST_F(VerifiedRun, HasItsCertificateInTheRecord) {
  ASSERT_EQ(run_drape({"run", scene, "-o", run}).exit_status, 0);
  ASSERT_TRUE(record().certificate);
  const CertificateSummary summary = record().certificate->summary;
  EXPECT_EQ(summary.frames, 2);
  EXPECT_EQ(summary.failed, 0);
  EXPECT_EQ(summary.worst, "");
  EXPECT_GT(summary.extremes.simulated.smallest_gap, 1e-5);
  EXPECT_TRUE(summary.extremes.drawn);
  EXPECT_GT(record().stages.at("certify").wall_seconds, 0);
}

TEST_F(VerifiedRun, IsCertifiedAnewOnlyWhereFramesOrTheirDrawingChanged) {
  ASSERT_EQ(run_drape({"run", scene, "-o", run}).exit_status, 0);
  const double seconds = record().stages.at("certify").wall_seconds;
  ASSERT_EQ(run_drape({"run", scene, "-o", run}).exit_status, 0);
  EXPECT_EQ(record().stages.at("certify").wall_seconds, seconds);
  ASSERT_EQ(run_drape({"run", scene, "-o", run, "-D", "cloths.napkin.look.subdivide=0"}).exit_status, 0);
  EXPECT_FALSE(record().certificate->summary.extremes.drawn);
  ASSERT_EQ(run_drape({"simulate", scene, "-o", run, "-D", "time.frames=1-3"}).exit_status, 0);
  EXPECT_FALSE(record().certificate);
}

// One of the frames that are in the cache already is another one than was simulated.
TEST_F(Verify, RunWarnsWhereAFrameFails) {
  force_intersection(2);
  const Finished finished = run_drape({"run", scene, "-o", run});
  EXPECT_EQ(finished.exit_status, 0) << finished.err;
  EXPECT_TRUE(
      contains(finished.err, "warning: not certified: 1 of 3 frames, the worst is 2: 'drape verify " + run))
      << finished.err;
  const auto record = read_manifest(run + "/run.json");
  ASSERT_TRUE(record && record->certificate);
  EXPECT_EQ(record->certificate->summary.failed, 1);
}

}  // namespace
}  // namespace drape::app

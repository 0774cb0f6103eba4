#include "app/manifest.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/run.h"
#include "app/run_program.h"
#include "core/error.h"
#include "core/file.h"

namespace drape::app {
namespace {

Manifest sample_manifest() {
  Manifest manifest;
  manifest.program_version = "1.2.3";
  manifest.build = 0xfedcba9876543210;
  manifest.scene = "../../scenes/\"quoted\".yaml";
  manifest.overrides = {"time.step=1 ms", "name=a\\b"};
  manifest.fingerprint = 0x0123456789abcdef;
  manifest.threads = 2;
  FrameRecord& record = manifest.frames[7];
  record.state_hash = 0xffffffffffffffff;
  record.statistics.largest_stretch = 1.0 / 3;
  record.statistics.contacts = 42;
  record.statistics.largest_lag = 0.25;
  record.statistics.largest_pin_lag = 0.125;
  record.statistics.largest_shape_lag = 0.25;
  record.statistics.profile[Phase::narrow] = 0.125;
  record.picture_hash = 5;
  manifest.stages["render"] = {1.5, 2.5};
  CertificateRecord& certificate = manifest.certificate.emplace();
  certificate.key = 0xabc;
  certificate.summary = {
      90, 2, "12", {"", true, 0.9, 1.1, {3, 0.25, 1, 0.5}, SurfaceFigures{4, 0.125, 0, 0}}};
  return manifest;
}

TEST(Manifest, ComesBackFromJsonAsItWas) {
  const Manifest manifest = manifest_from_json(to_json(sample_manifest()));
  EXPECT_EQ(to_json(manifest), to_json(sample_manifest()));
  EXPECT_EQ(manifest.build, 0xfedcba9876543210);
  EXPECT_EQ(manifest.scene, "../../scenes/\"quoted\".yaml");
  EXPECT_EQ(manifest.frames.at(7).statistics.largest_stretch, 1.0 / 3);
  EXPECT_EQ(manifest.frames.at(7).statistics.largest_lag, 0.25);
  EXPECT_EQ(manifest.frames.at(7).statistics.largest_pin_lag, 0.125);
  EXPECT_EQ(manifest.frames.at(7).statistics.largest_shape_lag, 0.25);
  EXPECT_EQ(manifest.frames.at(7).statistics.profile.cpu_seconds[2], 0.125);
  EXPECT_EQ(manifest.stages.at("render").cpu_seconds, 2.5);
  EXPECT_EQ(manifest.certificate->key, 0xabc);
  EXPECT_EQ(manifest.certificate->summary.worst, "12");
  EXPECT_EQ(manifest.certificate->summary.extremes.drawn->smallest_gap, 0.125);
}

TEST(Manifest, IsNothingWhereThereIsNoFileAndAnErrorWhereItIsDamaged) {
  const TemporaryFolder folder;
  EXPECT_FALSE(read_manifest(folder / "run.json"));
  write_manifest(folder / "run.json", sample_manifest());
  EXPECT_EQ(read_manifest(folder / "run.json")->threads, 2);
  const std::string whole = read_file(folder / "run.json");
  write_file(folder / "run.json", whole.substr(0, whole.size() / 2));
  EXPECT_THROW(read_manifest(folder / "run.json"), FileError);
}

TEST(Overrides, LaterOnesReplaceThoseOfTheSameKey) {
  const std::vector<std::string> merged = merge_overrides({"a.b=1", "c=2"}, {"a.b=3", "d=4"});
  EXPECT_EQ(merged, std::vector<std::string>({"c=2", "a.b=3", "d=4"}));
}

TEST(Manifest, KnowsFiguresThatAreNotFinite) {
  Manifest manifest = sample_manifest();
  manifest.frames[7].statistics.kinetic_energy = std::numeric_limits<double>::quiet_NaN();
  manifest.frames[7].statistics.profile[Phase::narrow] = std::numeric_limits<double>::infinity();
  FrameStatistics read = manifest_from_json(to_json(manifest)).frames.at(7).statistics;
  EXPECT_TRUE(std::isnan(read.kinetic_energy));
  EXPECT_FALSE(std::isfinite(read.profile[Phase::narrow]));
  EXPECT_EQ(read.contacts, 42);
  SurfaceFigures& figures = manifest.certificate->summary.extremes.simulated;
  figures.smallest_gap = std::numeric_limits<double>::infinity();
  const Manifest again = manifest_from_json(to_json(manifest));
  EXPECT_TRUE(std::isinf(again.certificate->summary.extremes.simulated.smallest_gap));
}

}  // namespace
}  // namespace drape::app

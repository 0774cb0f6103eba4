#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/certificate_report.h"
#include "app/fact_result.h"
#include "simulation/simulation.h"

namespace drape::app {

struct FrameRecord {
  std::uint64_t state_hash = 0;
  FrameStatistics statistics;
  std::uint64_t picture_hash = 0;  // of the PNG file; 0 while there is none
};

struct CertificateRecord {
  std::uint64_t key = 0;  // of what was certified, and by which program
  CertificateSummary summary;
};

struct StageTiming {
  double wall_seconds = 0;
  double cpu_seconds = 0;
};

// The record of a run, kept as run.json in its folder: what was made, from what, and at what cost. Other
// commands take the folder in place of the scene, because the scene and the overrides stand in here.
struct Manifest {
  std::string program_version;
  std::uint64_t build = 0;  // the program that simulated (program_build)
  std::string scene;        // the scene file, seen from the folder
  std::vector<std::string> overrides;
  std::uint64_t fingerprint = 0;  // simulation_fingerprint of the scene
  int threads = 0;
  std::map<int, FrameRecord> frames;
  std::map<std::string, StageTiming> stages;
  std::optional<CertificateRecord> certificate;  // nothing while it is not made, or was made of other frames
};

// The only file pair that includes nlohmann-json.
std::string to_json(const Manifest& manifest);
std::string to_json(const CertificateSummary& summary, const std::vector<FrameCertificate>& frames,
                    const std::vector<FactResult>& facts);
Manifest manifest_from_json(const std::string& text);  // throws std::runtime_error where it is no manifest

// Nothing where there is no such file. Throws FileError where it is damaged.
std::optional<Manifest> read_manifest(const std::filesystem::path& path);
void write_manifest(const std::filesystem::path& path, const Manifest& manifest);

}  // namespace drape::app

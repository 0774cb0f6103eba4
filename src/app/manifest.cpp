#include "app/manifest.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/error.h"
#include "core/file.h"
#include "core/hash.h"

namespace drape::app {

using Json = nlohmann::ordered_json;

static std::uint64_t hash_from_hex(const std::string& text) { return std::stoull(text, nullptr, 16); }

static Json cpu_json(const Profile& profile) {
  Json json = Json::object();
  for (std::size_t phase = 0; phase < phase_names.size(); ++phase) {
    json[std::string(phase_names[phase])] = 1000 * profile.cpu_seconds[phase];
  }
  return json;
}

// A figure that an older program did not know keeps its default. JSON has no word for a figure that is not
// finite: null stands for it.
template <typename Number>
static Number figure_from(const Json& json, std::string_view name, Number otherwise) {
  const auto found = json.find(name);
  if (found == json.end()) return otherwise;
  return found->is_null() ? std::numeric_limits<Number>::quiet_NaN() : found->template get<Number>();
}

static Profile profile_from(const Json& json) {
  Profile profile;
  for (std::size_t phase = 0; phase < phase_names.size(); ++phase) {
    profile.cpu_seconds[phase] = figure_from(json, phase_names[phase], 0.0) / 1000;
  }
  return profile;
}

// The binding names every member: one that is added later stops this from compiling until it is written too.
static Json statistics_json(const FrameStatistics& statistics) {
  const auto& [largest_stretch, p99_stretch, smallest_stretch, contacts, limited_vertices, kinetic_energy,
               largest_speed, largest_lag, largest_pin_lag, largest_shape_lag, profile] = statistics;
  return {{"largest_stretch", largest_stretch},   {"p99_stretch", p99_stretch},
          {"smallest_stretch", smallest_stretch}, {"contacts", contacts},
          {"limited_vertices", limited_vertices}, {"kinetic_energy", kinetic_energy},
          {"largest_speed", largest_speed},       {"largest_lag", largest_lag},
          {"largest_pin_lag", largest_pin_lag},   {"largest_shape_lag", largest_shape_lag},
          {"cpu_ms", cpu_json(profile)}};
}

static FrameStatistics statistics_from(const Json& json) {
  FrameStatistics statistics;
  const auto read = [&](const char* name, auto& value) { value = figure_from(json, name, value); };
  read("largest_stretch", statistics.largest_stretch);
  read("p99_stretch", statistics.p99_stretch);
  read("smallest_stretch", statistics.smallest_stretch);
  read("contacts", statistics.contacts);
  read("limited_vertices", statistics.limited_vertices);
  read("kinetic_energy", statistics.kinetic_energy);
  read("largest_speed", statistics.largest_speed);
  read("largest_lag", statistics.largest_lag);
  if (json.contains("largest_pin_lag")) read("largest_pin_lag", statistics.largest_pin_lag);
  if (json.contains("largest_shape_lag")) read("largest_shape_lag", statistics.largest_shape_lag);
  statistics.profile = profile_from(json.at("cpu_ms"));
  return statistics;
}

static Json frame_json(int frame, const FrameRecord& record) {
  Json json = {{"frame", frame},
               {"state_hash", to_hex(record.state_hash)},
               {"statistics", statistics_json(record.statistics)}};
  if (record.picture_hash != 0) json["picture_hash"] = to_hex(record.picture_hash);
  return json;
}

static FrameRecord frame_from(const Json& json) {
  FrameRecord record;
  record.state_hash = hash_from_hex(json.at("state_hash"));
  record.statistics = statistics_from(json.at("statistics"));
  record.picture_hash = hash_from_hex(json.value("picture_hash", "0"));
  return record;
}

static Json surface_json(const SurfaceFigures& figures) {
  const auto& [intersecting_pairs, smallest_gap, collider_triangles, collider_depth] = figures;
  return {{"intersecting_pairs", intersecting_pairs},
          {"smallest_gap_m", smallest_gap},
          {"collider_triangles", collider_triangles},
          {"collider_depth_m", collider_depth}};
}

// A gap that is infinite, since no two triangles are apart, is null.
static SurfaceFigures surface_from(const Json& json) {
  SurfaceFigures figures{json.at("intersecting_pairs"), std::numeric_limits<double>::infinity(),
                         json.at("collider_triangles"), json.at("collider_depth_m")};
  if (!json.at("smallest_gap_m").is_null()) figures.smallest_gap = json.at("smallest_gap_m");
  return figures;
}

static void add_figures(Json& json, const FrameCertificate& certificate) {
  json["finite"] = certificate.is_finite;
  json["smallest_stretch"] = certificate.smallest_stretch;
  json["largest_stretch"] = certificate.largest_stretch;
  json["simulated"] = surface_json(certificate.simulated);
  if (certificate.drawn) json["drawn"] = surface_json(*certificate.drawn);
}

static FrameCertificate figures_from(const Json& json) {
  FrameCertificate certificate{"",
                               json.at("finite"),
                               figure_from(json, "smallest_stretch", 1.0),
                               figure_from(json, "largest_stretch", 1.0),
                               surface_from(json.at("simulated")),
                               std::nullopt};
  if (json.contains("drawn")) certificate.drawn = surface_from(json.at("drawn"));
  return certificate;
}

// A frame's number as one, a file's name as text.
static Json name_json(const std::string& name) {
  const bool is_number = !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? Json(std::stoi(name)) : Json(name);
}

static Json summary_json(const CertificateSummary& summary) {
  Json json = {{"frames", summary.frames}, {"failed", summary.failed}, {"worst", nullptr}};
  if (!summary.worst.empty()) json["worst"] = name_json(summary.worst);
  add_figures(json, summary.extremes);
  return json;
}

static CertificateRecord record_from(const Json& json) {
  CertificateRecord record;
  record.key = hash_from_hex(json.at("key"));
  record.summary = {json.at("frames"), json.at("failed"), "", figures_from(json)};
  if (!json.at("worst").is_null()) record.summary.worst = std::to_string(json.at("worst").get<int>());
  return record;
}

static Json fact_json(const FactResult& result) {
  Json json = {{"fact", result.meaning}, {"holds", result.holds}, {"found", nullptr}};
  if (!result.found) return json;
  json["found"] = *result.found;
  json["frame"] = result.frame;
  return json;
}

std::string to_json(const CertificateSummary& summary, const std::vector<FrameCertificate>& frames,
                    const std::vector<FactResult>& facts) {
  Json json = summary_json(summary);
  json["test"] = Json::array();
  for (const FactResult& result : facts) json["test"].push_back(fact_json(result));
  json["each"] = Json::array();
  for (const FrameCertificate& frame : frames) {
    Json entry = {{"frame", name_json(frame.name)}, {"certified", is_certified(frame)}};
    add_figures(entry, frame);
    json["each"].push_back(entry);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace);  // names of files may be no UTF-8
}

std::string to_json(const Manifest& manifest) {
  Json json = {{"program_version", manifest.program_version},
               {"build", to_hex(manifest.build)},
               {"scene", manifest.scene},
               {"overrides", manifest.overrides},
               {"fingerprint", to_hex(manifest.fingerprint)},
               {"threads", manifest.threads},
               {"stages", Json::object()},
               {"frames", Json::array()}};
  for (const auto& [name, timing] : manifest.stages) {
    json["stages"][name] = {{"wall_seconds", timing.wall_seconds}, {"cpu_seconds", timing.cpu_seconds}};
  }
  if (manifest.certificate) {
    json["certificate"] = summary_json(manifest.certificate->summary);
    json["certificate"]["key"] = to_hex(manifest.certificate->key);
  }
  for (const auto& [frame, record] : manifest.frames) json["frames"].push_back(frame_json(frame, record));
  return json.dump(1) + "\n";
}

Manifest manifest_from_json(const std::string& text) {
  const Json json = Json::parse(text);
  Manifest manifest;
  manifest.program_version = json.at("program_version");
  manifest.build = hash_from_hex(json.at("build"));
  manifest.scene = json.at("scene");
  manifest.overrides = json.at("overrides").get<std::vector<std::string>>();
  manifest.fingerprint = hash_from_hex(json.at("fingerprint"));
  manifest.threads = json.at("threads");
  for (const auto& [name, timing] : json.at("stages").items()) {
    manifest.stages[name] = {timing.at("wall_seconds"), timing.at("cpu_seconds")};
  }
  if (json.contains("certificate")) manifest.certificate = record_from(json.at("certificate"));
  for (const auto& frame : json.at("frames")) manifest.frames[frame.at("frame")] = frame_from(frame);
  return manifest;
}

std::optional<Manifest> read_manifest(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return std::nullopt;
  try {
    return manifest_from_json(read_file(path));
  } catch (const FileError&) {
    throw;
  } catch (const std::exception& fault) {
    throw FileError(path.string(), std::string("is damaged; delete it to start anew: ") + fault.what());
  }
}

void write_manifest(const std::filesystem::path& path, const Manifest& manifest) {
  write_file(path, to_json(manifest));
}

}  // namespace drape::app

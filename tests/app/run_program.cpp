#include "app/run_program.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include "app/subprocess.h"
#include "core/file.h"

namespace drape::app {
namespace fs = std::filesystem;

std::string write_scene(const TemporaryFolder& folder, const std::string& name, int frames, int points) {
  const fs::path path = folder / (name + ".yaml");
  write_file(path, fmt::format(R"(version: 1
time: {{fps: 24, frames: {0}, step: 4 ms}}
cloths:
  napkin:
    grid: {{size: [0.5, 0.5], points: [{1}, {1}]}}
    place: {{at: [0, 0.45, 0]}}
    look: {{subdivide: 1, pattern: checker}}
colliders:
  ball: {{sphere: {{radius: 0.2}}, place: {{at: [0, 0.2, 0]}}}}
  floor: {{plane: {{y: 0}}}}
camera: {{look_at: [0, 0.2, 0], orbit: {{radius: 1.5, height: 0.6, turns: 0.25}}}}
render: {{resolution: [64, 36], quality: draft}}
)",
                               frames, points));
  return path.string();
}

Finished run_drape(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {DRAPE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Finished finished;
  const ProcessResult result =
      run_process(words, [&](std::string_view line) { finished.out += std::string(line) + "\n"; });
  finished.exit_status = result.exit_status;
  finished.err = result.errors;
  return finished;
}

static pid_t start(const std::vector<std::string>& arguments) {
  std::vector<char*> words = {const_cast<char*>(DRAPE_PROGRAM)};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const pid_t process = fork();
  if (process != 0) return process;
  execv(words[0], words.data());
  _exit(127);
}

int stop_drape(const std::vector<std::string>& arguments, const fs::path& file, int signal) {
  using namespace std::chrono_literals;
  const pid_t process = start(arguments);
  int status = 0;
  bool was_stopped = false;
  while (waitpid(process, &status, WNOHANG) == 0) {
    if (!was_stopped && fs::exists(file)) was_stopped = kill(process, signal) == 0;
    std::this_thread::sleep_for(1ms);
  }
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

std::string content_of_folder(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) contents[entry.path().filename().string()] = read_file(entry.path());
  }
  std::string all;
  for (const auto& [name, content] : contents) all += name + "\n" + content + "\n";
  return all;
}

std::vector<std::string> unfinished_files(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().string().find(".part") != std::string::npos) names.push_back(entry.path().string());
  }
  return names;
}

}  // namespace drape::app

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace drape::app {

// A folder for one test; it goes when the test ends.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Writes a scene of one small cloth over a ball, `frames` long, with tiny pictures; its path.
std::string write_scene(const TemporaryFolder& folder, const std::string& name, int frames, int points = 6);

struct Finished {
  int exit_status = 0;
  std::string out;
  std::string err;
};

// Runs the program to its end.
Finished run_drape(const std::vector<std::string>& arguments);

// Starts the program, waits until `file` is there, sends the signal, and waits for the end; the exit status.
int stop_drape(const std::vector<std::string>& arguments, const std::filesystem::path& file, int signal);

// The names and contents of the files in a folder, one after another: equal texts mean equal files.
std::string content_of_folder(const std::filesystem::path& folder);

// The files in a folder and below that were left half-written.
std::vector<std::string> unfinished_files(const std::filesystem::path& folder);

}  // namespace drape::app

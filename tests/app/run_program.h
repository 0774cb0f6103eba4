#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.h"

namespace drape::app {

using test::TemporaryFolder;

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

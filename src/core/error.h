#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace drape {

// One mistake of the user's: where it stands, what is wrong, and a way out. `line` and `column` count from 1;
// 0 means that the mistake has no place in a text (a flag, a mesh file as a whole).
struct Problem {
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;
};

// "file:line:column: error: message", without the parts that are not known.
std::string to_string(const Problem& problem);

// The user's mistakes, all at once. Exit status 2, or 3 where `exit_status` says that a file was at fault.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems, int exit_status = 2);
  const std::vector<Problem>& problems() const { return problems_; }
  int exit_status() const { return exit_status_; }

 private:
  std::vector<Problem> problems_;
  int exit_status_;
};

// The outside world refused: a file cannot be read or written. The message names the path. Exit status 3.
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& reason);
};

// A program that Drape starts (the encoder) is missing or failed. Exit status 6.
class EncoderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The simulation cannot go on: values that are not finite. Exit status 4.
class SimulationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace drape

#include "app/subprocess.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "app/interrupt.h"

namespace drape::app {

namespace {

// Both ends of a pipe; closed at the latest when it goes.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  }
  ~Pipe() {
    close_writer();
    close(ends_[0]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void close_writer() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

// What a child starts with: an empty stdin, pipes for the rest.
class FileActions {
 public:
  FileActions(const Pipe& output, const Pipe& errors) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output.writer(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, errors.writer(), STDERR_FILENO);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

}  // namespace

// The process, or 0 where there is no such program.
static pid_t spawn(const std::vector<std::string>& arguments, const FileActions& actions) {
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  pid_t process = 0;
  const int error = posix_spawnp(&process, words[0], actions.get(), nullptr, words.data(), environ);
  if (error == 0) return process;
  if (error == ENOENT || error == EACCES || error == ENOTDIR) return 0;
  throw std::system_error(error, std::generic_category(), "cannot start " + arguments[0]);
}

// Appends what can be read now; false at the end.
static bool read_some(int file, std::string& text) {
  std::array<char, 4096> buffer{};
  const ssize_t size = read(file, buffer.data(), buffer.size());
  if (size > 0) text.append(buffer.data(), static_cast<std::size_t>(size));
  return size > 0 || (size < 0 && errno == EINTR);
}

static void take_lines(std::string& text, const std::function<void(std::string_view)>& on_line) {
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
    on_line(std::string_view(text).substr(0, end));
    text.erase(0, end + 1);
  }
}

static void keep_end(std::string& text) {
  constexpr std::size_t enough = 4000;
  if (text.size() > enough) text.erase(0, text.size() - enough);
}

// Reads both pipes until the child closes them. It wakes up often, for a signal may come while it waits.
static std::string listen(pid_t process, const Pipe& output, const Pipe& errors,
                          const std::function<void(std::string_view)>& on_line) {
  std::string output_text;
  std::string error_text;
  std::array<pollfd, 2> files{pollfd{output.reader(), POLLIN, 0}, pollfd{errors.reader(), POLLIN, 0}};
  while (files[0].fd >= 0 || files[1].fd >= 0) {
    if (stop_signal() != 0) kill(process, SIGTERM);
    if (poll(files.data(), files.size(), 200) <= 0) continue;
    if (files[0].revents != 0 && !read_some(files[0].fd, output_text)) files[0].fd = -1;
    if (files[1].revents != 0 && !read_some(files[1].fd, error_text)) files[1].fd = -1;
    take_lines(output_text, on_line);
    keep_end(error_text);
  }
  return error_text;
}

static double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

static void wait_for(pid_t process, ProcessResult& result) {
  int status = 0;
  rusage usage{};
  while (wait4(process, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  result.exit_status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

ProcessResult run_process(const std::vector<std::string>& arguments,
                          const std::function<void(std::string_view)>& on_line) {
  Pipe output;
  Pipe errors;
  const FileActions actions(output, errors);
  const pid_t process = spawn(arguments, actions);
  if (process == 0) return {false, 127, "", 0};
  output.close_writer();
  errors.close_writer();
  ProcessResult result;
  result.errors = listen(process, output, errors, on_line);
  wait_for(process, result);
  return result;
}

}  // namespace drape::app

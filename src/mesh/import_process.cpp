#include "mesh/import_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>

#include "core/error.h"
#include "core/printable.h"
#include "mesh/assimp_import.h"
#include "mesh/mesh_text.h"
#include "mesh/polygon_soup_stream.h"

namespace drape {
namespace {
namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr std::string_view subcommand = "import-mesh";
constexpr const char* child_mark = "DRAPE_IMPORT_CHILD";  // environment of the child
constexpr rlim_t child_memory = rlim_t{2} << 30;
constexpr rlim_t child_cpu_seconds = 30;
constexpr auto child_time = 60s;
constexpr std::size_t most_words = 1000;  // bytes of an error
constexpr std::size_t most_result_bytes = std::size_t{3} << 30;

// The first byte of the child's answer.
constexpr char answer_soup = 'S';
constexpr char answer_error = 'E';
constexpr char answer_unknown_clip = 'C';

// The sanitizers of test builds reserve terabytes of address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool limits_memory = false;
#else
constexpr bool limits_memory = true;
#endif

bool set_limit(decltype(RLIMIT_AS) resource, rlim_t limit) {
  const rlimit both{limit, limit};
  return ::setrlimit(resource, &both) == 0;
}

bool limit_child() {
  return set_limit(RLIMIT_CPU, child_cpu_seconds) && set_limit(RLIMIT_FSIZE, 0) &&
         set_limit(RLIMIT_CORE, 0) && (!limits_memory || set_limit(RLIMIT_AS, child_memory)) &&
         ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

// The child's arguments after its subcommand: the file, and a clip's name and interval where one is wanted.
std::vector<std::string> to_arguments(const fs::path& path, const std::optional<ClipRequest>& clip) {
  if (!clip) return {path.string()};
  return {path.string(), clip->name, fmt::format("{}", clip->interval)};
}

SoupInShapes import_as_asked(const std::vector<std::string>& arguments) {
  if (arguments.size() == 1) return {import_with_assimp(arguments[0]), {}};
  return import_clip_with_assimp(arguments[0], {arguments[1], to_number(arguments[2]).value()});
}

bool write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool write_soup(int file, const SoupInShapes& soup) {
  bool is_written = write_all(file, {&answer_soup, 1});
  write_bytes(soup, [&](std::string_view piece) { is_written = is_written && write_all(file, piece); });
  return is_written;
}

bool answer(int file, const std::vector<std::string>& arguments) {
  try {
    if (!limit_child()) throw std::runtime_error("the importer's limits cannot be set");
    return write_soup(file, import_as_asked(arguments));
  } catch (const std::bad_alloc&) {
    return write_all(
        file, answer_error + fmt::format("it takes more than {} MiB of memory to import: make it simpler",
                                         child_memory >> 20));
  } catch (const UnknownClip& error) {
    return write_all(file, answer_unknown_clip + std::string(error.what()));
  } catch (const std::exception& error) {
    return write_all(file, answer_error + std::string(error.what()));
  }
}

struct Child {
  pid_t process = -1;
  int output = -1;  // the reading end of its pipe
};

// Standard output is the pipe, standard error nowhere (libraries chat), and no other file stays open.
int spawn(const std::vector<std::string>& own_arguments, int pipe_end, pid_t& process) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, pipe_end, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);

  std::vector<std::string> words = {"drape", std::string(subcommand)};
  words.insert(words.end(), own_arguments.begin(), own_arguments.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::string mark = fmt::format("{}=1", child_mark);
  std::vector<char*> environment = {mark.data()};
  for (char** variable = environ; *variable; ++variable) environment.push_back(*variable);
  environment.push_back(nullptr);

  const int error =
      ::posix_spawn(&process, "/proc/self/exe", &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

Child start_child(const fs::path& path, const std::vector<std::string>& arguments) {
  std::array<int, 2> ends;
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw FileError(path.string(), std::string("no pipe to the importer: ") + std::strerror(errno));
  Child child{-1, ends[0]};
  const int error = spawn(arguments, ends[1], child.process);
  ::close(ends[1]);
  if (error == 0) return child;
  ::close(ends[0]);
  throw FileError(path.string(), std::string("the importer cannot be started: ") + std::strerror(error));
}

enum class End { whole, too_long, too_late, broken };

// One piece of the child's output; false at its end or after an error.
bool read_piece(int output, std::string& bytes, End& end) {
  std::array<char, 65536> buffer;
  const ssize_t size = ::read(output, buffer.data(), buffer.size());
  if (size < 0 && errno == EINTR) return true;
  if (size < 0) end = End::broken;
  if (size <= 0) return false;
  bytes.append(buffer.data(), static_cast<std::size_t>(size));
  if (bytes.size() > most_result_bytes) end = End::too_long;
  return end == End::whole;
}

End read_output(int output, std::string& bytes) {
  const auto deadline = std::chrono::steady_clock::now() + child_time;
  End end = End::whole;
  do {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    if (left <= 0ms) return End::too_late;
    pollfd waiting{output, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(left.count())) <= 0) continue;
    if (!read_piece(output, bytes, end)) return end;
  } while (true);
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string words_for_end(End end, int status) {
  if (end == End::too_late) return fmt::format("importing it took longer than {} s", child_time.count());
  if (end == End::too_long) return "the importer makes too much of it";
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
    return fmt::format("importing it took more than {} s of CPU time", child_cpu_seconds);
  if (WIFSIGNALED(status))
    return fmt::format(
        "the importer crashed on it (signal {}); the file is damaged, or convert it to .obj or .ply",
        WTERMSIG(status));
  return fmt::format("the importer ended with status {}", WEXITSTATUS(status));
}

}  // namespace

std::optional<int> run_import_child(int argc, const char* const* argv) {
  const bool is_child = (argc == 3 || argc == 5) && argv[1] == subcommand && std::getenv(child_mark);
  if (!is_child) return std::nullopt;
  return answer(STDOUT_FILENO, {argv + 2, argv + argc}) ? EXIT_SUCCESS : EXIT_FAILURE;
}

SoupInShapes import_in_child(const fs::path& path, const std::optional<ClipRequest>& clip) {
  // A program whose main does not call run_import_child would start itself without end.
  if (std::getenv(child_mark))
    throw FileError(path.string(), "this program cannot import meshes of its format");
  const Child child = start_child(path, to_arguments(path, clip));
  std::string bytes;
  const End end = read_output(child.output, bytes);
  ::close(child.output);
  if (end != End::whole) ::kill(child.process, SIGKILL);
  const int status = wait_for(child.process);
  if (end != End::whole || status != 0 || bytes.empty()) refuse(path, words_for_end(end, status));
  const std::string words = printable(std::string_view(bytes).substr(1), most_words);
  if (bytes[0] == answer_error) refuse(path, "cannot be imported: " + words);
  if (bytes[0] == answer_unknown_clip) throw UnknownClip(words);
  auto soup = soup_from_bytes(std::string_view(bytes).substr(1));
  if (bytes[0] != answer_soup || !soup) refuse(path, "the importer's answer makes no sense");
  return std::move(*soup);
}

}  // namespace drape

#include "core/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.h"

namespace drape {
namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) throw FileError(path.string(), "is a folder, not a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw FileError(path.string(), std::string("cannot be read: ") + std::strerror(errno));
  std::ostringstream content;
  content << stream.rdbuf();
  if (stream.bad()) throw FileError(path.string(), "cannot be read to its end");
  return std::move(content).str();
}

static bool write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// The path, or the innermost folder that it would lie in, of which there is anything by that name.
static fs::path innermost_name(fs::path path) {
  std::error_code ignored;
  while (!path.empty() && path != path.root_path() && !fs::exists(fs::symlink_status(path, ignored)))
    path = path.parent_path();
  return path;
}

void refuse_file_as_folder(const fs::path& folder) {
  std::error_code ignored;
  const fs::path path = innermost_name(folder);
  const fs::file_status status = fs::status(path, ignored);
  if (fs::exists(status) && !fs::is_directory(status))
    throw FileError(path.string(), "is a file, not a folder, and nothing can be put into it: name a folder");
  if (status.type() == fs::file_type::not_found && fs::is_symlink(fs::symlink_status(path, ignored)))
    throw FileError(path.string(),
                    "is a link to " + fs::read_symlink(path, ignored).string() +
                        ", which is not there: make that folder, remove the link, or name another folder");
}

static void make_folder(const fs::path& folder) {
  refuse_file_as_folder(folder);
  std::error_code error;
  if (!folder.empty()) fs::create_directories(folder, error);
  if (error) throw FileError(folder.string(), "the folder cannot be made: " + error.message());
}

[[noreturn]] static void give_up(const fs::path& path, const fs::path& aside) {
  const int reason = errno;
  ::unlink(aside.c_str());
  throw FileError(path.string(), std::string("cannot be written: ") + std::strerror(reason));
}

// Renaming over a device or a pipe would put a file in its place.
static void refuse_special_file(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw FileError(path.string(), "is a folder, not a file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw FileError(path.string(), "is a device or a pipe, and would be replaced: name a file");
}

void write_file(const fs::path& path, std::string_view content) {
  refuse_special_file(path);
  make_folder(path.parent_path());
  const fs::path aside = path.string() + ".part" + std::to_string(::getpid());
  const int file = ::open(aside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) give_up(path, aside);
  if (!write_all(file, content)) {
    const int reason = errno;
    ::close(file);
    errno = reason;
    give_up(path, aside);
  }
  if (::close(file) != 0) give_up(path, aside);
  if (std::rename(aside.c_str(), path.c_str()) != 0) give_up(path, aside);
}

}  // namespace drape

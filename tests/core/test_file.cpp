#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "core/error.h"
#include "core/file.h"
#include "temporary_folder.h"

namespace drape {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::size_t entries(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

template <typename Action>
std::string failure(const Action& action) {
  try {
    action();
    return "no failure";
  } catch (const FileError& error) {
    return error.what();
  }
}

TEST(File, ComesBackByteForByte) {
  const TemporaryFolder folder;
  const std::string content("a\0b\r\n\xff", 6);
  write_file(folder / "a", content);
  EXPECT_EQ(read_file(folder / "a"), content);
  write_file(folder / "a", "");
  EXPECT_EQ(read_file(folder / "a"), "");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(File, MissingFoldersAreMade) {
  const TemporaryFolder folder;
  write_file(folder / "x/y/z", "content");
  EXPECT_EQ(read_file(folder / "x/y/z"), "content");
}

TEST(File, CannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(failure([&] { read_file(folder / "a"); }),
            (folder / "a").string() + ": cannot be read: No such file or directory");
  EXPECT_EQ(failure([&] { read_file(folder.path()); }), folder.path().string() + ": is a folder, not a file");
}

TEST(File, AFileIsNoFolder) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  EXPECT_NE(failure([&] { write_file(folder / "a/b", "new"); }), "no failure");
  EXPECT_EQ(read_file(folder / "a"), "old");
}

TEST(File, AFolderIsNotReplaced) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "a/b");
  EXPECT_EQ(failure([&] { write_file(folder / "a", "new"); }),
            (folder / "a").string() + ": is a folder, not a file");
  EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(File, IsNoFolderToPutAnotherInto) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  const std::string words =
      (folder / "a").string() + ": is a file, not a folder, and nothing can be put into it";
  EXPECT_EQ(failure([&] { write_file(folder / "a/b", "new"); }).find(words), 0u);
  EXPECT_EQ(failure([&] { refuse_file_as_folder(folder / "a"); }).find(words), 0u);
  EXPECT_EQ(failure([&] { refuse_file_as_folder(folder / "a/b/c"); }).find(words), 0u);
  EXPECT_EQ(failure([&] { refuse_file_as_folder(folder / "b/c"); }), "no failure");
}

TEST(File, IsNotPutIntoALinkToNothing) {
  const TemporaryFolder folder;
  const fs::path link = folder / "link";
  fs::create_symlink("none", link);
  const std::string words =
      link.string() +
      ": is a link to none, which is not there: make that folder, remove the link, or name another folder";
  EXPECT_EQ(failure([&] { write_file(link / "cache/a", "new"); }), words);
  EXPECT_EQ(failure([&] { refuse_file_as_folder(link); }), words);
  fs::create_directory(folder / "none");
  EXPECT_EQ(failure([&] { refuse_file_as_folder(link / "cache"); }), "no failure");
}

// A limit on the size of files stands in for a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limited);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(File, APipeIsNotReplaced) {
  const TemporaryFolder folder;
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(failure([&] { write_file(pipe, "new"); }),
            pipe.string() + ": is a device or a pipe, and would be replaced: name a file");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(File, AFailedWriteLeavesTheOldFile) {
  const TemporaryFolder folder;
  write_file(folder / "a", "old");
  const std::string large(100000, 'x');
  std::string words;
  {
    const FileSizeLimit full_disk(1000);
    words = failure([&] { write_file(folder / "a", large); });
  }
  EXPECT_EQ(words, (folder / "a").string() + ": cannot be written: File too large");
  EXPECT_EQ(read_file(folder / "a"), "old");
  EXPECT_EQ(entries(folder.path()), 1u);
}

}  // namespace
}  // namespace drape

#include "grader/base/safe_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// How many files lie in a folder, temporary ones among them.
std::ptrdiff_t count_files(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(SafeFile, ReplacesAFileAndLeavesNothingElse) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "a.txt";
  write_file_safely(file, "one");
  write_file_safely(file, std::string("t\0wo", 4));
  EXPECT_EQ(read_whole_file(file), std::string("t\0wo", 4));
  EXPECT_EQ(count_files(folder.path()), 1);
}

TEST(SafeFile, WhatCannotBeWrittenIsNamedAndLeavesWhatWasThere) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "taken");
  for (const fs::path& file : {folder.path() / "taken", folder.path() / "missing" / "a.txt"}) {
    try {
      write_file_safely(file, "text");
      ADD_FAILURE() << file << " was written";
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(file.string() + ": cannot be written: "));
    }
  }
  EXPECT_TRUE(fs::is_directory(folder.path() / "taken"));
  EXPECT_EQ(count_files(folder.path()), 1);
}

unsigned mode_of(const fs::path& file) {
  struct stat status {};
  EXPECT_EQ(::stat(file.c_str(), &status), 0);
  return status.st_mode & 0777U;
}

TEST(SafeFile, AFileKeepsItsModeAndANewOneHasThatOfTheUmask) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "private.json";
  std::ofstream(file) << "old";
  for (const mode_t mode : {0600U, 0664U}) {
    ASSERT_EQ(::chmod(file.c_str(), mode), 0);
    write_file_safely(file, "new");
    EXPECT_EQ(mode_of(file), mode);
  }
  const mode_t before = ::umask(027);
  write_file_safely(folder.path() / "fresh", "new");
  ::umask(before);
  EXPECT_EQ(mode_of(folder.path() / "fresh"), 0640U);
}

/// What a person who is not root is told who writes a file; "" if it is written.
std::string refusal_to_a_user(const fs::path& file) {
  const FileDescriptor told = make_scratch_file();
  const pid_t child = ::fork();
  if (child == 0) {
    if (::geteuid() == 0 && (::setgid(61'236) != 0 || ::setuid(61'236) != 0)) ::_exit(2);
    const std::string error = user_error([&] { write_file_safely(file, "new"); });
    const ssize_t written = ::write(told.get(), error.data(), error.size());
    ::_exit(written == static_cast<ssize_t>(error.size()) ? 0 : 2);
  }
  int status = -1;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  std::string error(1000, '\0');
  const ssize_t size = ::pread(told.get(), error.data(), error.size(), 0);
  error.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
  return error;
}

TEST(SafeFile, AReadOnlyFileIsNotReplacedEvenWhereItsFolderMayBeWrittenTo) {
  const ScratchFolder folder;
  fs::permissions(folder.path(), fs::perms::all);
  const fs::path file = folder.path() / "grades.csv";
  std::ofstream(file) << "old";
  ASSERT_EQ(::chmod(file.c_str(), 0444), 0);
  EXPECT_EQ(refusal_to_a_user(file), file.string() + ": cannot be written: Permission denied");
  EXPECT_EQ(read_whole_file(file), "old");
  EXPECT_EQ(count_files(folder.path()), 1);
  ASSERT_EQ(::chmod(file.c_str(), 0666), 0);
  EXPECT_EQ(refusal_to_a_user(file), "");
  EXPECT_EQ(read_whole_file(file), "new");
}

TEST(SafeFile, AFileOfTheUserThatIsCalledPartialStays) {
  const ScratchFolder folder;
  std::ofstream(folder.path() / "a.txt.partial") << "mine";
  write_file_safely(folder.path() / "a.txt", "text");
  EXPECT_EQ(read_whole_file(folder.path() / "a.txt.partial"), "mine");
}

TEST(SafeFile, TheAdviceFitsTheReason) {
  const ScratchFolder folder;
  const auto told = [](const fs::path& file) {
    return user_error([&] { write_file_safely(file, "text"); }).substr(file.string().size());
  };
  EXPECT_EQ(told(folder.path()), ": cannot be written: it is a folder; name a file");
  EXPECT_EQ(told(folder.path() / "missing" / "a.txt"),
            ": cannot be written: No such file or directory; make the folder first");
  EXPECT_EQ(told(folder.path() / std::string(300, 'a')),
            ": cannot be written: File name too long");
}

TEST(SafeFile, LinkStaysALink) {
  const ScratchFolder folder;
  fs::create_directory(folder.path() / "real");
  fs::create_symlink("real/b.txt", folder.path() / "a.txt");
  std::ofstream(folder.path() / "real" / "b.txt") << "old";
  write_file_safely(folder.path() / "a.txt", "new");
  EXPECT_TRUE(fs::is_symlink(folder.path() / "a.txt"));
  EXPECT_EQ(read_whole_file(folder.path() / "real" / "b.txt"), "new");
}

// As root, /dev/null and /dev/stdout could be replaced by a file.
TEST(SafeFile, PipeIsWrittenToAndStaysAPipe) {
  const ScratchFolder folder;
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink(pipe, folder.path() / "link");
  for (const char* name : {"pipe", "link"}) {
    std::string seen;
    std::thread reader([&] { seen = read_whole_file(pipe); });
    write_file_safely(folder.path() / name, "through the pipe");
    if (!fs::is_fifo(pipe)) fs::remove(pipe);
    reader.join();
    EXPECT_EQ(seen, "through the pipe");
    EXPECT_TRUE(fs::is_fifo(pipe));
  }
  EXPECT_EQ(count_files(folder.path()), 2);
}

}  // namespace
}  // namespace meshgrade

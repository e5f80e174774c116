#include "grader/base/safe_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "grader/base/errors.h"
#include "grader/base/process.h"

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

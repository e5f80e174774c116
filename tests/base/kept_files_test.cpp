#include "grader/base/kept_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <vector>

#include "grader/base/process.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kPlenty = 1U << 20U;

class KeptFilesTest : public testing::Test {
 protected:
  fs::path folder() const { return scratch_.path() / "kept"; }

  fs::path only_file() const {
    const std::vector<fs::directory_entry> files{fs::directory_iterator(folder()), {}};
    EXPECT_EQ(files.size(), 1U);
    return files.at(0).path();
  }

  ScratchFolder scratch_;
};

std::string read(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(KeptFilesTest, GivesBackWhatWasKeptAlsoToTheNextProgram) {
  const std::string bytes("a\0b\n", 4);
  KeptFiles(folder(), kPlenty).keep("key", bytes);
  const KeptFiles again(folder(), kPlenty);
  EXPECT_EQ(again.find("key"), bytes);
  EXPECT_EQ(again.find("other"), std::nullopt);
  EXPECT_EQ(again.usage().files, 1U);
}

TEST_F(KeptFilesTest, WhatIsDamagedCountsAsNothingAndGoes) {
  const KeptFiles kept(folder(), kPlenty);
  for (const bool cut_off : {true, false}) {
    kept.keep("key", "some bytes");
    const fs::path file = only_file();
    std::string text = read(file);
    if (cut_off) {
      text.pop_back();
    } else {
      text.back() = '?';
    }
    std::ofstream(file, std::ios::binary) << text;
    EXPECT_EQ(kept.find("key"), std::nullopt);
    EXPECT_FALSE(fs::exists(file));
  }
}

TEST_F(KeptFilesTest, AFileUnderAnotherNameCountsAsNothing) {
  const KeptFiles kept(folder(), kPlenty);
  kept.keep("key", "bytes");
  const fs::path first = only_file();
  kept.keep("other", "others");
  fs::path second;
  for (const auto& entry : fs::directory_iterator(folder())) {
    if (entry.path() != first) second = entry.path();
  }
  fs::copy_file(first, second, fs::copy_options::overwrite_existing);
  EXPECT_EQ(kept.find("other"), std::nullopt);
  EXPECT_EQ(kept.find("key"), "bytes");
}

TEST_F(KeptFilesTest, IsClosedToOthers) {
  const KeptFiles kept(folder(), kPlenty);
  EXPECT_EQ(fs::status(folder()).permissions(), fs::perms::owner_all);
}

TEST_F(KeptFilesTest, NothingIsTakenFromAFolderThatOthersCanWriteTo) {
  KeptFiles(folder(), kPlenty).keep("key", "bytes");
  fs::permissions(folder(), fs::perms::owner_all | fs::perms::others_all);
  const KeptFiles kept(folder(), kPlenty);
  EXPECT_FALSE(kept.works());
  EXPECT_EQ(kept.find("key"), std::nullopt);
  kept.keep("more", "bytes");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder()), {}), 1);
}

TEST_F(KeptFilesTest, NothingIsKeptWhereThereIsNoFolder) {
  std::ofstream(scratch_.path() / "file") << "text";
  for (const fs::path& place : {fs::path(), scratch_.path() / "file" / "kept"}) {
    const KeptFiles kept(place, kPlenty);
    EXPECT_FALSE(kept.works());
    kept.keep("key", "bytes");
    EXPECT_EQ(kept.find("key"), std::nullopt);
    EXPECT_EQ(kept.usage().files, 0U);
  }
}

TEST_F(KeptFilesTest, ThoseThatWereNotUsedForLongestGoWhenThereAreTooMany) {
  const std::string bytes(1000, 'x');
  const KeptFiles kept(folder(), 10'000);
  for (int i = 0; i < 100; ++i) {
    kept.keep("key " + std::to_string(i), bytes);
    // Files of the same moment have no order.
    for (const auto& entry : fs::directory_iterator(folder()))
      fs::last_write_time(entry, entry.last_write_time() - std::chrono::seconds(1));
    EXPECT_TRUE(kept.find("key 0").has_value()) << i;  // used again and again
    EXPECT_LE(kept.usage().bytes, 15'000U);
  }
  EXPECT_TRUE(kept.find("key 99").has_value());
  EXPECT_FALSE(kept.find("key 1").has_value());
}

}  // namespace
}  // namespace meshgrade

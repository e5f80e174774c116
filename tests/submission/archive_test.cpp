// Archives come from strangers: each bad one is a clear error or a note, and nothing is ever
// written outside the folder.

#include "grader/submission/archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/submission/submission.h"
#include "tests/support/made_archive.h"
#include "tests/support/scratch_files.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

namespace fs = std::filesystem;

class Archives : public testing::Test {
 protected:
  /// All files below the scratch folder but the archives themselves.
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_.path())) {
      const fs::path name = entry.path().lexically_relative(scratch_.path());
      if (*name.begin() != "in" && !entry.is_directory()) names.insert(name.string());
    }
    return names;
  }

  fs::path made(const std::string& name, const std::vector<MadeEntry>& entries,
                const std::string& password = "") const {
    return make_archive(scratch_.path() / "in" / name, entries, password);
  }

  std::string unpack(const fs::path& archive, const ArchiveLimits& limits = {}) const {
    fs::create_directories(scratch_.path() / "out");
    return join(unpack_archive(archive, scratch_.path() / "out", limits), "; ");
  }

  static std::string read(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  ScratchFolder scratch_;
};

TEST_F(Archives, EveryKindIsUnpacked) {
  for (const char* kind :
       {".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.bz2", ".tar.zst", ".7z"}) {
    const ScratchFolder out;
    const fs::path archive = made(std::string("hw") + kind, {{"src/flip.cpp", "int x;"}});
    EXPECT_TRUE(is_archive_name(archive));
    EXPECT_THAT(unpack_archive(archive, out.path(), {}), IsEmpty()) << kind;
    EXPECT_EQ(read(out.path() / "src" / "flip.cpp"), "int x;") << kind;
  }
}

TEST_F(Archives, ASingleCompressedFileIsUnpacked) {
  const fs::path file = write_file(scratch_.path() / "in" / "flip.cpp", "int x;");
  for (const std::string tool : {"gzip", "xz", "zstd"}) {
    Command command;
    command.arguments = {tool, "-k", file.string()};
    ASSERT_TRUE(run_process(command).ok()) << tool << " is needed for this test";
  }
  for (const char* ending : {".gz", ".xz", ".zst"}) {
    const Submission submission = find_submission(file.string() + ending, {});
    ASSERT_EQ(submission.sources.size(), 1U) << ending;
    EXPECT_EQ(submission.sources[0].name, "flip.cpp");
    EXPECT_EQ(submission.sources[0].text, "int x;");
  }
}

TEST_F(Archives, NamesKeepTheirLetters) {
  const fs::path archive = made("hw.tar", {{"M\xC3\xBCller/fl\xC3\xA4"
                                            "che.cpp",
                                            "x"}});
  EXPECT_EQ(unpack(archive), "");
  EXPECT_THAT(files(), ElementsAre("out/M\xC3\xBCller/fl\xC3\xA4"
                                   "che.cpp"));
}

TEST_F(Archives, NothingLeavesTheFolder) {
  for (const char* kind : {"hw.tar", "hw.zip"}) {
    fs::remove_all(scratch_.path() / "out");
    const std::string notes = unpack(made(kind, {{"../escaped.cpp", "x"},
                                                 {"a/../../escaped.cpp", "x"},
                                                 {"/tmp/meshgrade_escaped.cpp", "x"},
                                                 {"..\\escaped.cpp", "x"},
                                                 {"good.cpp", "x"}}));
    EXPECT_THAT(files(), ElementsAre("out/good.cpp")) << kind;
    EXPECT_FALSE(fs::exists("/tmp/meshgrade_escaped.cpp"));
    EXPECT_THAT(notes, HasSubstr("../escaped.cpp is left out: its name leads out"));
    EXPECT_THAT(notes, HasSubstr("escaped.cpp is left out: its name is not one within"));
  }
}

TEST_F(Archives, AnEmptyFolderIsThere) {
  EXPECT_EQ(unpack(made("hw.zip", {{"class/ann/", "", AE_IFDIR}, {"../up/", "", AE_IFDIR}})),
            "");
  EXPECT_TRUE(fs::is_directory(scratch_.path() / "out" / "class" / "ann"));
  EXPECT_FALSE(fs::exists(scratch_.path() / "up"));
}

TEST_F(Archives, LinksAndDevicesAreLeftOut) {
  const std::string notes =
      unpack(made("hw.tar", {{"link", "", AE_IFLNK, "/etc/passwd"},
                             {"link/below.cpp", "x"},
                             {"out", "", AE_IFLNK, ".."},
                             {"out/escaped.cpp", "x"},
                             {"hard.cpp", "", AE_IFREG, "/etc/passwd", true},
                             {"fifo", "", AE_IFIFO},
                             {"device", "", AE_IFCHR},
                             {"good.cpp", "x"}}));
  EXPECT_THAT(files(), UnorderedElementsAre("out/good.cpp", "out/link/below.cpp",
                                            "out/out/escaped.cpp"));
  for (const char* name : {"link", "hard.cpp", "fifo", "device"}) {
    EXPECT_THAT(notes, HasSubstr(std::string(name) + " is left out: not an ordinary file"));
  }
}

TEST_F(Archives, NamesThatClashAreTold) {
  const std::string notes = unpack(made("hw.zip", {{"flip.cpp", "first"},
                                                   {"flip.cpp", "second"},
                                                   {"FLIP.cpp", "third"},
                                                   {"flip.cpp/inside.cpp", "fourth"}}));
  EXPECT_EQ(read(scratch_.path() / "out" / "flip.cpp"), "first");
  EXPECT_THAT(notes, HasSubstr("flip.cpp is left out: something else in the archive has its "
                               "name"));
  EXPECT_THAT(notes, HasSubstr("FLIP.cpp: another name in the archive differs only in upper"));
}

TEST_F(Archives, ABombIsRefused) {
  ArchiveLimits limits;
  limits.bytes = 1U << 20U;
  const fs::path bomb = made("bomb.tar.gz", {{"a.cpp", std::string(50U << 20U, '\0')}});
  EXPECT_LT(fs::file_size(bomb), 100'000U);
  EXPECT_EQ(user_error([&] { unpack(bomb, limits); }),
            "bomb.tar.gz: holds more than 1 MB when it is unpacked");
  EXPECT_LE(fs::file_size(scratch_.path() / "out" / "a.cpp"), limits.bytes);
}

TEST_F(Archives, ABombInAFileThatNobodyAskedForIsRefused) {
  ArchiveLimits limits;
  limits.bytes = 1U << 20U;
  const auto nothing = [](const fs::path&) { return Take::kNothing; };
  for (const char* kind : {"bomb.tar.gz", "bomb.zip"}) {
    const fs::path bomb = made(kind, {{"a.obj", std::string(50U << 20U, '\0')}});
    EXPECT_THAT(user_error([&] { unpack_archive(bomb, scratch_.path(), limits, nothing); }),
                HasSubstr("holds more than 1 MB"))
        << kind;
  }
}

TEST_F(Archives, AFileBeyondItsLimitIsCut) {
  ArchiveLimits limits;
  limits.file_bytes = 10;
  unpack(made("hw.zip", {{"a.cpp", std::string(1000, 'a')}, {"b.cpp", "b"}}), limits);
  EXPECT_EQ(read(scratch_.path() / "out" / "a.cpp"), std::string(10, 'a'));
  EXPECT_EQ(read(scratch_.path() / "out" / "b.cpp"), "b");
}

TEST_F(Archives, AHundredThousandEntriesAreRefused) {
  std::vector<MadeEntry> entries;
  for (int i = 0; i < 100'000; ++i)
    entries.push_back({"dir/" + std::to_string(i), ""});
  const fs::path archive = made("many.tar.gz", entries);
  const auto nothing = [](const fs::path&) { return Take::kNothing; };
  EXPECT_EQ(user_error([&] { unpack_archive(archive, scratch_.path(), {}, nothing); }),
            "many.tar.gz: holds more than 50000 entries");
}

TEST_F(Archives, FoldersTooDeepAreLeftOut) {
  std::string deep;
  for (int i = 0; i < 200; ++i)
    deep += "d/";
  EXPECT_THAT(unpack(made("hw.tar", {{deep + "a.cpp", "x"}})), HasSubstr("too deep"));
  EXPECT_THAT(files(), IsEmpty());
}

TEST_F(Archives, AnEncryptedOneIsRefused) {
  const fs::path archive = made("secret.zip", {{"a.cpp", "int x;"}}, "password");
  EXPECT_EQ(user_error([&] { unpack(archive); }),
            "secret.zip: the archive is encrypted; it must be handed in without a password");
}

TEST_F(Archives, ATruncatedOneIsRefused) {
  for (const char* kind : {"hw.zip", "hw.tar.gz", "hw.7z", "hw.tar.xz"}) {
    std::string noise;
    for (unsigned i = 0, x = 1; i < 100'000; ++i, x = x * 1664525U + 1013904223U)
      noise += static_cast<char>(x >> 24U);
    const fs::path archive = made(kind, {{"a.cpp", noise}, {"b.cpp", noise}});
    const ScratchFolder out;
    fs::resize_file(archive, fs::file_size(archive) / 2);
    EXPECT_THAT(user_error([&] { unpack_archive(archive, out.path(), {}); }),
                HasSubstr("the archive is damaged"))
        << kind;
  }
}

TEST_F(Archives, WhatIsNoArchiveIsRefused) {
  for (const char* name : {"hw.zip", "hw.tar.gz", "hw.7z", "flip.cpp.gz"}) {
    const fs::path file = write_file(scratch_.path() / "in" / name, "Dear grader, my zip");
    EXPECT_THAT(user_error([&] { unpack(file); }), HasSubstr("the archive is damaged")) << name;
  }
}

TEST_F(Archives, ASubmissionMayBeOne) {
  const Submission submission =
      find_submission(made("hw.zip", {{"hw/flip.cpp", "int f;"},
                                      {"hw/notes.md", "x"},
                                      {"hw/.git/config", "x"},
                                      {"__MACOSX/hw/._flip.cpp", "x"}}),
                      {});
  ASSERT_EQ(submission.sources.size(), 1U);
  EXPECT_EQ(submission.sources[0].text, "int f;");
  EXPECT_EQ(submission.name, "hw.zip");
}

TEST_F(Archives, AnArchiveInAnArchiveIsOpenedOnce) {
  const auto wrap = [&](const std::string& name, const fs::path& inner) {
    return made(name, {{"inner.zip", read(inner)}});
  };
  const fs::path once = wrap("once.zip", made("hw.zip", {{"flip.cpp", "int f;"}}));
  EXPECT_EQ(find_submission(once, {}).sources.at(0).text, "int f;");
  const fs::path twice = wrap("twice.zip", once);
  EXPECT_THAT(user_error([&] { find_submission(twice, {}); }),
              HasSubstr("an archive in an archive in an archive is not opened"));
}

TEST_F(Archives, AFolderMayHoldOne) {
  made("hw.zip", {{"flip.cpp", "int f;"}});
  EXPECT_EQ(find_submission(scratch_.path() / "in", {}).sources.at(0).text, "int f;");
  write_file(scratch_.path() / "in" / "split.cpp", "int s;");
  const Submission both = find_submission(scratch_.path() / "in", {});
  EXPECT_EQ(both.sources.size(), 1U);
  EXPECT_THAT(both.notes, ElementsAre("hw.zip is left out: there are C++ files beside it"));
}

TEST_F(Archives, OtherKindsAreNamed) {
  const fs::path file = write_file(scratch_.path() / "in" / "hw.rar", "Rar!");
  EXPECT_THAT(user_error([&] { find_submission(file, {}); }),
              HasSubstr("of archives, zip, tar, gz, bz2, xz, zst and 7z can be opened"));
}

TEST_F(Archives, AHugeFileInASubmissionIsLeftOut) {
  const fs::path archive =
      made("hw.zip", {{"big.cpp", std::string(3U << 20U, ' ')}, {"flip.cpp", "int f;"}});
  const Submission submission = find_submission(archive, {});
  EXPECT_EQ(submission.sources.size(), 1U);
  EXPECT_THAT(submission.notes, ElementsAre(HasSubstr("big.cpp is left out: larger than")));
}

}  // namespace
}  // namespace meshgrade

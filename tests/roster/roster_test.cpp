// What is common to all layouts: keys, file names, parts; and the plain folder.

#include "grader/roster/roster.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/scratch_files.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> keys(const Roster& roster) {
  std::vector<std::string> all;
  for (const HandIn& hand_in : roster.hand_ins)
    all.push_back(hand_in.key);
  return all;
}

TEST(Roster, PlainFolderHoldsFoldersAndFiles) {
  const ScratchFolder folder;
  write_file(folder.path() / "bob" / "flip.cpp", "int b;");
  write_file(folder.path() / "alice" / "flip.cpp", "int a;");
  write_file(folder.path() / "carol.cpp", "int c;");
  write_file(folder.path() / "notes.txt", "to myself");
  write_file(folder.path() / ".DS_Store", "noise");
  write_file(folder.path() / "__MACOSX" / "x.cpp", "noise");
  const Roster roster = read_roster(folder.path(), {});
  EXPECT_EQ(roster.layout, "plain");
  EXPECT_THAT(keys(roster), ElementsAre("alice", "bob", "carol"));
  ASSERT_EQ(roster.left_out.size(), 1U);
  EXPECT_EQ(roster.left_out[0].what, "notes.txt");
  EXPECT_EQ(roster.hand_ins[2].people.at(0).id, "carol");
  EXPECT_EQ(take_submission(roster.hand_ins[2], {}).sources.at(0).text, "int c;");
}

TEST(Roster, NobodyIsLostWhereTwoHaveTheSameKey) {
  const ScratchFolder folder;
  write_file(folder.path() / "bob" / "flip.cpp", "int b;");
  write_file(folder.path() / "bob.cpp", "int c;");
  EXPECT_THAT(keys(read_roster(folder.path(), {})), ElementsAre("bob", "bob (2)"));
}

TEST(Roster, LinksAreNotFollowed) {
  const ScratchFolder folder;
  write_file(folder.path() / "bob" / "flip.cpp", "int b;");
  std::filesystem::create_directory_symlink("/etc", folder.path() / "mallory");
  EXPECT_THAT(keys(read_roster(folder.path(), {})), ElementsAre("bob"));
}

TEST(Roster, NothingHandedInIsAnError) {
  const ScratchFolder folder;
  EXPECT_THAT(user_error([&] { read_roster(folder.path(), {}); }),
              HasSubstr("nothing was handed in here"));
  EXPECT_THAT(user_error([&] { read_roster(folder.path() / "no", {}); }),
              HasSubstr("there is no such"));
  EXPECT_THAT(user_error([&] {
                read_roster(folder.path(), {"blackboard", ""});
              }),
              HasSubstr("there is no layout \"blackboard\"; there are"));
}

TEST(Roster, PartsAreBroughtTogetherByTheNamesTheyWereGiven) {
  const ScratchFolder folder;
  HandIn hand_in;
  hand_in.key = "dora";
  hand_in.parts = {{write_file(folder.path() / "dora_1_flip.cpp", "int f;"), "flip.cpp"},
                   {write_file(folder.path() / "dora_2_split.cpp", "int s;"), "split.cpp"}};
  const Submission submission = take_submission(hand_in, {});
  EXPECT_EQ(submission.name, "dora");
  ASSERT_EQ(submission.sources.size(), 2U);
  EXPECT_EQ(submission.sources[1].name, "split.cpp");
  EXPECT_EQ(submission.sources[1].text, "int s;");
}

TEST(Roster, APartCannotLeaveItsFolder) {
  const ScratchFolder folder;
  HandIn hand_in;
  hand_in.key = "mallory";
  hand_in.parts = {{write_file(folder.path() / "a", "int f;"), "../../escaped.cpp"}};
  EXPECT_EQ(take_submission(hand_in, {}).sources.at(0).name, "escaped.cpp");
  EXPECT_FALSE(std::filesystem::exists(folder.path().parent_path() / "escaped.cpp"));
}

TEST(Roster, NothingToGradeIsToldWithoutThePlace) {
  const ScratchFolder folder;
  write_file(folder.path() / "eve" / "essay.txt", "Dear grader");
  const Roster roster = read_roster(folder.path(), {});
  const std::string message = user_error([&] { take_submission(roster.hand_ins.at(0), {}); });
  EXPECT_THAT(message, HasSubstr("no C++ source file"));
  EXPECT_EQ(message.find(folder.path().string()), std::string::npos);
}

TEST(SafeFileName, IsSafeAndDifferentForDifferentKeys) {
  const std::vector<std::string> all{"alice",
                                     "Alice",
                                     "ALICE",
                                     "",
                                     ".",
                                     "..",
                                     "../../etc/passwd",
                                     "a/b",
                                     "a\\b",
                                     "a_b",
                                     "a b",
                                     "-rf",
                                     ".hidden",
                                     "nul\n",
                                     "a~b",
                                     "x@y.edu",
                                     "\xC3\xA9",
                                     "e\xCC\x81",
                                     std::string(300, 'x'),
                                     std::string(301, 'x'),
                                     "=1+1",
                                     "a:b",
                                     "a*b",
                                     "trailing."};
  std::vector<std::string> names;
  for (const std::string& key : all) {
    const std::string name = safe_file_name(key);
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789._-@~"),
              std::string::npos)
        << name;
    EXPECT_NE(name[0], '.');
    EXPECT_NE(name[0], '-');
    EXPECT_LE(name.size(), 100U);
    names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_EQ(safe_file_name("x@y.edu"), "x@y.edu");
}

}  // namespace
}  // namespace meshgrade

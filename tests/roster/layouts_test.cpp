// Each platform's way to hand out what was handed in: found by itself, everybody found, and
// everything that is not graded said.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "grader/roster/roster.h"
#include "tests/support/scratch_files.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

class Layouts : public testing::Test {
 protected:
  void add(const std::string& name, const std::string& text = "int x;") const {
    write_file(scratch_.path() / "class" / name, text);
  }

  Roster read(const RosterOptions& options = {}) const {
    return read_roster(scratch_.path() / "class", options);
  }

  /// "key: id name email (file, file) time late"
  static std::vector<std::string> lines(const Roster& roster) {
    std::vector<std::string> all;
    for (const HandIn& hand_in : roster.hand_ins) {
      std::string line = hand_in.key + ":";
      for (const Person& person : hand_in.people)
        line += " [" + person.id + "|" + person.name + "|" + person.email + "]";
      for (const Part& part : hand_in.parts)
        line += " " + part.name;
      line += hand_in.submitted_at.empty() ? "" : " at " + hand_in.submitted_at;
      all.push_back(line + (hand_in.late ? " late" : ""));
    }
    return all;
  }

  static std::vector<std::string> left_out(const Roster& roster) {
    std::vector<std::string> all;
    for (const Omission& omission : roster.left_out)
      all.push_back(omission.what + ": " + omission.why);
    return all;
  }

  ScratchFolder scratch_;
};

TEST_F(Layouts, Canvas) {
  add("leeann_1234_99_flip.cpp");
  add("leeann_1234_100_split-1.cpp");
  add("\xC3\xB6zcem_LATE_77_101_homework.zip");
  add("smithjo_78_102_my_12_34_file.cpp");
  add("poet_79_text.html");
  add("anon_q8Xyz_103_flip.cpp");
  add("LATE_anon_abc_104_flip.cpp");
  add("readme.txt");
  const Roster roster = read();
  EXPECT_EQ(roster.layout, "canvas");
  EXPECT_THAT(
      lines(roster),
      ElementsAre("anon_abc: [abc|anon|] flip.cpp late", "anon_q8Xyz: [q8Xyz|anon|] flip.cpp",
                  "leeann_1234: [1234|leeann|] split.cpp flip.cpp",
                  "poet_79: [79|poet|] text.html",
                  "smithjo_78: [78|smithjo|] my_12_34_file.cpp",
                  "\xC3\xB6zcem_77: [77|\xC3\xB6zcem|] homework.zip late"));
  EXPECT_THAT(left_out(roster),
              ElementsAre("readme.txt: its name is not one that Canvas gives"));
}

TEST_F(Layouts, CanvasCountsStayWhereTwoFilesWouldMeet) {
  add("lee_1_10_flip.cpp");
  add("lee_1_11_flip-1.cpp");
  add("lee_1_12_split-2.cpp");
  EXPECT_THAT(lines(read()), ElementsAre("lee_1: [1|lee|] flip.cpp flip-1.cpp split.cpp"));
}

TEST_F(Layouts, Moodle) {
  add("Ann Lee_4711_assignsubmission_file_/flip.cpp");
  add("Ann Lee_4711_assignsubmission_onlinetext_/onlinetext.html");
  add("Bob_Ross Jr_4712_assignsubmission_file/flip.cpp");
  add("Participant_4713_assignsubmission_file_flip.cpp");
  add("Team_2_4714_assignsubmission_file/src/flip.cpp");
  add("grades.csv");
  const Roster roster = read();
  EXPECT_EQ(roster.layout, "moodle");
  EXPECT_THAT(lines(roster),
              ElementsAre("Ann Lee_4711: [4711|Ann Lee|] flip.cpp onlinetext.html",
                          "Bob Ross Jr_4712: [4712|Bob Ross Jr|] flip.cpp",
                          "Participant_4713: [4713|Participant|] flip.cpp",
                          "Team 2_4714: [4714|Team 2|] src"));
  EXPECT_THAT(left_out(roster),
              ElementsAre("grades.csv: its name is not one that Moodle gives"));
}

TEST_F(Layouts, Gradescope) {
  add("submission_1/flip.cpp");
  add("submission_2/flip.cpp");
  add("submission_9/flip.cpp");
  add("__MACOSX/submission_1/flip.cpp");
  add("submission_1/.DS_Store");
  add("submission_metadata.yml", R"(---
submission_1:
  :submitters:
  - :name: Ann Lee
    :sid: '00123'
    :email: ann@x.edu
  - :name: Bob Ross
    :sid:
    :email: bob@x.edu
  :created_at: 2026-01-31 23:59:00.000000000 Z
  :score: 1.0
  :history:
  - :created_at: 2026-01-30
    :score: 0
submission_2:
  :submitters:
  - :name: "Cem \"=1+1\""
    :sid: '7'
    :email: cem@x.edu
submission_3:
  :submitters: []
)");
  const Roster roster = read();
  EXPECT_EQ(roster.layout, "gradescope");
  EXPECT_THAT(lines(roster),
              ElementsAre("submission_1: [00123|Ann Lee|ann@x.edu] [bob@x.edu|Bob "
                          "Ross|bob@x.edu] submission_1 at 2026-01-31 23:59:00.000000000 Z",
                          "submission_2: [7|Cem \"=1+1\"|cem@x.edu] submission_2",
                          "submission_9: [submission_9||] submission_9"));
  EXPECT_THAT(left_out(roster), ElementsAre("submission_3: listed in submission_metadata.yml, "
                                            "but there is no such folder"));
}

TEST_F(Layouts, GradescopesDamagedMetadataAreRefused) {
  add("submission_1/flip.cpp");
  add("submission_metadata.yml", "submission_1: [");
  EXPECT_THAT(user_error([&] { read(); }),
              HasSubstr("submission_metadata.yml: cannot be read"));
  add("submission_metadata.yml", "- a list");
  EXPECT_THAT(user_error([&] { read(); }), HasSubstr("submission_metadata.yml: is no map"));
  add("submission_metadata.yml", "../../etc:\n  :submitters: []\n");
  EXPECT_THAT(lines(read()), ElementsAre("submission_1: [submission_1||] submission_1"));
}

TEST_F(Layouts, GitHubClassroom) {
  add("flip-submissions/flip-ann/flip.cpp");
  add("flip-submissions/flip-team-1/flip.cpp");
  add("flip-submissions/odd/flip.cpp");
  add("flip-submissions/grades.csv",
      "assignment_name,github_username,roster_identifier,student_repository_name,"
      "submission_timestamp\r\nflip,bob,Bob Ross,flip-team-1,2026-01-31\r\n"
      "flip,cem,Cem Oz,flip-team-1,2026-01-31\r\n");
  const Roster roster = read();
  EXPECT_EQ(roster.layout, "github-classroom");
  EXPECT_THAT(lines(roster), ElementsAre("flip-ann: [ann||] flip-ann",
                                         "flip-team-1: [bob|Bob Ross|] [cem|Cem Oz|] "
                                         "flip-team-1 at 2026-01-31",
                                         "odd: [odd||] odd"));
}

TEST_F(Layouts, ClonedRepositoriesAreGitHubClassrooms) {
  add("ann/.git/config");
  add("ann/flip.cpp");
  add("bob/.git/config");
  EXPECT_EQ(read().layout, "github-classroom");
}

TEST_F(Layouts, Autolab) {
  add("ann_lee@x.edu_2_handin.zip");
  add("ann_lee@x.edu_10_handin.zip");
  add("bob@x.edu_1_flip.cpp");
  add("annotated_bob@x.edu_1_flip.cpp");
  const Roster roster = read();
  EXPECT_EQ(roster.layout, "autolab");
  EXPECT_THAT(lines(roster),
              ElementsAre("ann_lee@x.edu: [ann_lee@x.edu||ann_lee@x.edu] handin.zip",
                          "bob@x.edu: [bob@x.edu||bob@x.edu] flip.cpp"));
  EXPECT_EQ(roster.hand_ins[0].parts[0].path.filename(), "ann_lee@x.edu_10_handin.zip");
  EXPECT_THAT(left_out(roster),
              ElementsAre("ann_lee@x.edu_2_handin.zip: there is a later version",
                          "annotated_bob@x.edu_1_flip.cpp: a copy with remarks"));
}

TEST_F(Layouts, Nbgrader) {
  add("submitted/ann/hw1/flip.cpp");
  add("submitted/ann/hw1/timestamp.txt", "2026-01-31 12:00:00 UTC\n");
  add("submitted/bob/hw1/flip.cpp");
  add("source/hw1/flip.cpp");
  EXPECT_EQ(read().layout, "nbgrader");
  EXPECT_THAT(lines(read()),
              ElementsAre("ann: [ann||] hw1 at 2026-01-31 12:00:00 UTC", "bob: [bob||] hw1"));
  add("submitted/bob/hw2/flip.cpp");
  EXPECT_THAT(user_error([&] { read(); }),
              HasSubstr("several assignments here: hw1, hw2; choose one with --part"));
  const Roster second = read({"", "hw2"});
  EXPECT_THAT(lines(second), ElementsAre("bob: [bob||] hw2"));
  EXPECT_THAT(left_out(second), ElementsAre("ann: has nothing for the assignment hw2"));
}

TEST_F(Layouts, PlainFolderHoldsFoldersArchivesAndFiles) {
  add("ann/flip.cpp");
  add("bob.tar.gz");
  add("cem.cpp");
  add("notes.txt");
  const Roster roster = read();
  EXPECT_EQ(roster.layout, "plain");
  EXPECT_THAT(lines(roster), ElementsAre("ann: [ann||] ann", "bob: [bob||] bob.tar.gz",
                                         "cem: [cem||] cem.cpp"));
}

TEST_F(Layouts, AFolderAroundTheClassIsSeenThrough) {
  add("download/leeann_1234_99_flip.cpp");
  EXPECT_EQ(read().layout, "canvas");
  const ScratchFolder other;
  write_file(other.path() / "hw" / "ann" / "flip.cpp", "");
  write_file(other.path() / "hw" / "bob" / "flip.cpp", "");
  EXPECT_THAT(lines(read_roster(other.path(), {})),
              ElementsAre("ann: [ann||] ann", "bob: [bob||] bob"));
}

TEST_F(Layouts, ASingleStudentIsNotTakenForAClass) {
  add("ann/flip.cpp");
  add("ann/split.cpp");
  EXPECT_THAT(lines(read()), ElementsAre("ann: [ann||] ann"));
}

TEST_F(Layouts, OneCanBeForced) {
  add("leeann_1234_99_flip.cpp");
  add("ann.cpp");
  EXPECT_THAT(lines(read({"plain", ""})),
              ElementsAre("ann: [ann||] ann.cpp",
                          "leeann_1234_99_flip: [leeann_1234_99_flip||] "
                          "leeann_1234_99_flip.cpp"));
}

}  // namespace
}  // namespace meshgrade

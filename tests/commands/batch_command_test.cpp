// The commands for a class, as a person calls them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "grader/base/safe_file.h"
#include "grader/commands/batch_progress.h"
#include "tests/commands/command_line.h"
#include "tests/support/scratch_files.h"

namespace meshgrade {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class BatchCommand : public CommandLine {
 protected:
  BatchCommand() {
    write_file(class_ / "ann" / "edge_flip.cpp",
               read_whole_file(reference() + "/edge_flip.cpp"));
    write_file(class_ / "bob" / "essay.txt", "Dear grader");
    write_file(class_ / "notes.md", "x");
  }

  Said batch(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments{"batch", class_.string(), "--exercise", "edge_flip"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return call(arguments);
  }

  fs::path class_ = scratch_.path() / "class";
  fs::path results_ = scratch_.path() / "results";
};

TEST_F(BatchCommand, ListShowsWhoAndWhatIsLeftOutAndWritesNothing) {
  const Said said = batch({"--list"});
  EXPECT_EQ(said.status, 0);
  EXPECT_THAT(said.output, HasSubstr("layout: plain\n2 hand-ins:\n  ann\n    for   ann\n"));
  EXPECT_THAT(said.output, HasSubstr("left out:\n  notes.md: neither a folder nor an archive"));
  EXPECT_FALSE(fs::exists(results_));
}

TEST_F(BatchCommand, ListMarksWhoIsLate) {
  write_file(class_ / "leeann_LATE_1_2_edge_flip.cpp", "int a;\n");
  write_file(class_ / "rossbob_3_4_edge_flip.cpp", "int a;\n");
  for (const char* other : {"ann", "bob", "notes.md"})
    fs::remove_all(class_ / other);
  const std::string known = batch({"--list"}).output;
  EXPECT_THAT(known, HasSubstr("files edge_flip.cpp\n    at    (late)\n"));
  const std::string file = (scratch_.path() / "late.toml").string();
  write_file(file,
             read_whole_file(std::string(MESHGRADE_SOURCE_DIR) + "/grader/assignment.toml") +
                 "\n[late]\ndue = 2026-03-01T12:00:00Z\nper_day = 5\n");
  const std::string ruled = batch({"--list", "--assignment", file}).output;
  EXPECT_THAT(ruled, HasSubstr("(late): late by the platform, which tells no time"));
  EXPECT_THAT(ruled, HasSubstr("at    no time is known: nothing is taken off"));
}

TEST_F(BatchCommand, GradesThenKeepsThenExportsAndCompares) {
  const Said first = batch({"-o", results_.string()});
  EXPECT_EQ(first.status, 1) << first.output;
  EXPECT_THAT(first.output, HasSubstr("ann: 20 of 20 points"));
  EXPECT_THAT(first.output, HasSubstr("bob: ungradable (no C++ source file"));
  EXPECT_THAT(first.output, HasSubstr("1 of 2 hand-ins graded, 1 ungradable"));
  EXPECT_THAT(batch({"-o", results_.string()}).output,
              HasSubstr("ann: 20 of 20 points (unchanged)"));
  for (const char* file : {"class.json", "grades.csv", "summary.txt", "summary.json",
                           "results/ann/report.json", "results/ann/report.txt"})
    EXPECT_TRUE(fs::exists(results_ / file)) << file;
  EXPECT_EQ(call({"export", results_.string(), "gradescope"}).status, 0);
  EXPECT_TRUE(fs::exists(results_ / "exports" / "gradescope" / "ann" / "results.json"));
  EXPECT_EQ(call({"export", results_.string(), "canvas", "--column", "HW (7)"}).status, 0);
  EXPECT_THAT(read_whole_file(results_ / "exports" / "canvas.csv"), HasSubstr("HW (7)"));
  const Said same = call({"diff", results_.string(), results_.string()});
  EXPECT_EQ(same.status, 0) << same.output;
  EXPECT_EQ(same.output, "0 hand-ins changed of 2\n");
}

TEST_F(BatchCommand, RecognisesWhichAssignmentAClassIsAbout) {
  write_file(class_ / "cid" / "vertex_inset.cpp",
             read_whole_file(reference() + "/polygon_meshes/vertex_inset.cpp"));
  const auto graded = [&](const char* results) {
    return call({"batch", class_.string(), "-o", (scratch_.path() / results).string()}).output;
  };
  // One hand-in about the first assignment is enough for that.
  EXPECT_THAT(graded("first"), testing::AllOf(testing::Not(HasSubstr("recognised")),
                                              HasSubstr("cid: 0 of 100 points")));
  fs::remove_all(class_ / "ann");
  EXPECT_THAT(graded("second"),
              testing::AllOf(HasSubstr("recognised: --assignment polygon_meshes"),
                             HasSubstr("cid: 10 of 325 points")));
  EXPECT_THAT(call({"batch", class_.string(), "--list"}).output,
              HasSubstr("recognised: --assignment polygon_meshes"));
}

TEST_F(BatchCommand, PicturesLieBesideTheReportUntilNothingIsWrong) {
  write_file(class_ / "ann" / "edge_flip.cpp",
             read_whole_file(wrong("edge_flip/next_wrong/edge_flip.cpp")));
  batch({"-o", results_.string()});
  const fs::path pictures = results_ / "results" / "ann" / "figures";
  // A student finds the picture from beside the text.
  const std::string text = read_whole_file(pictures.parent_path() / "report.txt");
  const std::size_t named = text.find("picture   ");
  ASSERT_NE(named, std::string::npos);
  const std::string name = text.substr(named + 10, text.find('\n', named) - named - 10);
  EXPECT_TRUE(fs::is_regular_file(pictures.parent_path() / name)) << name;
  ASSERT_TRUE(fs::is_directory(pictures));
  const std::string first = fs::directory_iterator(pictures)->path().filename().string();
  EXPECT_THAT(read_whole_file(results_ / "results" / "ann" / "report.json"), HasSubstr(first));
  write_file(class_ / "ann" / "edge_flip.cpp", read_whole_file(reference() + "/edge_flip.cpp"));
  batch({"-o", results_.string()});
  EXPECT_FALSE(fs::exists(pictures));
}

TEST_F(BatchCommand, PagesShowThePicturesAndTheMeshes) {
  write_file(class_ / "ann" / "edge_flip.cpp",
             read_whole_file(wrong("edge_flip/next_wrong/edge_flip.cpp")));
  batch({"-o", results_.string(), "--html"});
  const fs::path page = results_ / "results" / "ann" / "report.html";
  const std::string html = read_whole_file(page);
  const auto says = [&](const char* text) { return html.find(text) != std::string::npos; };
  EXPECT_TRUE(says("viewBox=\\\"0 0")) << "a picture";
  EXPECT_TRUE(says("\"scene\":{")) << "the broken mesh";
  EXPECT_THAT(read_whole_file(results_ / "class.html"), HasSubstr("results/ann/report.html"));
  EXPECT_THAT(read_whole_file(results_ / "class.html"), HasSubstr("similar.html"));
  EXPECT_THAT(read_whole_file(results_ / "similar.html"), HasSubstr("<html"));
  batch({"-o", results_.string(), "--html"});
  EXPECT_TRUE(read_whole_file(page) == html) << "what is kept stays";
  batch({"-o", results_.string(), "--force"});
  EXPECT_FALSE(fs::exists(page)) << "a page of an earlier grading would tell old news";
}

TEST_F(BatchCommand, MistakesAreSaid) {
  EXPECT_EQ(batch({}).status, 2);
  EXPECT_THAT(batch({}).output, HasSubstr("-o RESULTS"));
  EXPECT_THAT(batch({"-o", (class_ / "results").string()}).output,
              HasSubstr("must not lie within what was handed in"));
  EXPECT_THAT(batch({"-o", results_.string(), "--only", "zoe"}).output,
              HasSubstr("there is no hand-in of \"zoe\""));
  EXPECT_THAT(call({"export", results_.string(), "csv"}).output,
              HasSubstr("there are no results of a class here"));
  EXPECT_THAT(
      call({"batch", (scratch_.path() / "no.zip").string(), "-o", results_.string()}).output,
      HasSubstr("there is no such"));
}

TEST_F(BatchCommand, AnAutograderWritesItsResultWhateverItIs) {
  const fs::path file = scratch_.path() / "results.json";
  const std::string target = "gradescope=" + file.string();
  EXPECT_EQ(call({"autograde", (class_ / "ann").string(), "--write", target}).status, 0);
  EXPECT_THAT(read_whole_file(file), HasSubstr("\"score\": 20.0"));
  EXPECT_EQ(call({"autograde", (class_ / "bob").string(), "--write", target}).status, 0);
  EXPECT_THAT(read_whole_file(file), HasSubstr("\"score\": 0.0"));
  EXPECT_THAT(call({"autograde", reference(), "--write", "blackboard=x"}).output,
              HasSubstr("--write takes FORMAT=FILE"));
}

TEST_F(BatchCommand, AnInterruptStopsItAndItGoesOn) {
  write_file(class_ / "eve" / "edge_flip.cpp",
             read_whole_file(wrong("edge_flip/sleeps/edge_flip.cpp")));
  const Said stopped = call_and_interrupt("[ -e '" + results_.string() + "/results/ann' ]",
                                          {"batch", class_.string(), "-o", results_.string(),
                                           "--exercise", "edge_flip", "--jobs", "2"});
  EXPECT_THAT(stopped.output, HasSubstr("stopped; the same command goes on from here"));
  EXPECT_FALSE(fs::exists(results_ / ".tmp"));
  const Said rest = batch({"-o", results_.string(), "--only", "ann"});
  EXPECT_THAT(rest.output, HasSubstr("ann: 20 of 20 points"));
}

/// Processes whose program lies below a folder. Their command line tells; the link to their
/// program is a path of the sandbox's own file system.
std::size_t processes_of(const fs::path& folder) {
  std::size_t count = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
    std::ifstream line(entry.path() / "cmdline");
    std::string program;
    std::getline(line, program, '\0');
    count += program.rfind(folder.string() + "/", 0) == 0 ? 1 : 0;
  }
  return count;
}

TEST_F(BatchCommand, WhenItIsKilledNoStudentsCodeRunsOn) {
  write_file(class_ / "eve" / "edge_flip.cpp",
             read_whole_file(wrong("edge_flip/sleeps/edge_flip.cpp")));
  // Where another user comes to the results, the submission runs there.
  fs::permissions(scratch_.path(), fs::perms::others_exec | fs::perms::group_exec,
                  fs::perm_options::add);
  const pid_t process = ::fork();
  if (process == 0) {
    batch({"-o", results_.string(), "--only", "eve"});
    ::_exit(0);
  }
  const auto wait_for = [&](bool running) {
    for (int i = 0; i < 1000 && (processes_of(results_) > 0) != running; ++i)
      ::usleep(20'000);
    return processes_of(results_);
  };
  EXPECT_GT(wait_for(true), 0U) << "the student's code must have begun";
  ::kill(process, SIGKILL);
  ::waitpid(process, nullptr, 0);
  EXPECT_EQ(wait_for(false), 0U);
}

Roster roster_of(std::size_t count) {
  Roster roster;
  for (std::size_t i = 0; i < count; ++i)
    roster.hand_ins.push_back({"student" + std::to_string(i), {}, {}, "", false});
  return roster;
}

TEST(BatchProgress, TheBarCountsAndTellsTheTimeLeft) {
  const Roster roster = roster_of(10);
  BatchProgress progress(roster, 10, true);
  EXPECT_EQ(progress.bar(0.0), "[....................] 0/10");
  BatchStep step;
  step.status = ResultStatus::kGraded;
  step.points = step.max_points = 10.0;
  step.kept = true;
  progress.count(step);
  EXPECT_EQ(progress.bar(0.0), "[##..................] 1/10  1 full") << "kept: no time known";
  step.kept = false;
  step.points = 5.0;
  progress.count(step);
  step.status = ResultStatus::kUngradable;
  progress.count(step);
  EXPECT_EQ(progress.bar(60.0),
            "[######..............] 3/10  1 full, 1 partial, 1 ungradable; 4 min left");
}

TEST(BatchProgress, ALineSaysWhoAndWhat) {
  const Roster roster = roster_of(2);
  BatchProgress progress(roster, 2, false);
  BatchStep step{1, ResultStatus::kUngradable, false, false, 0.0, 0.0, "no C++ source file"};
  progress.count(step);
  EXPECT_EQ(progress.line(step), "1/2 student1: ungradable (no C++ source file)");
}

TEST(BatchProgress, ASecondTryIsToldAndCounted) {
  const Roster roster = roster_of(2);
  BatchProgress progress(roster, 2, false);
  progress.count({0, ResultStatus::kGraded, false, true, 7.0, 10.0, "its process died"});
  const BatchStep failed{1, ResultStatus::kGraderError, false, true, 0.0, 0.0, "no memory"};
  progress.count(failed);
  EXPECT_EQ(progress.line(failed),
            "2/2 student1: grader error (at the second try, after an error of the grader: no "
            "memory)");
  EXPECT_EQ(progress.again(), 2U);
}

}  // namespace
}  // namespace meshgrade

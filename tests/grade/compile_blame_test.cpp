#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "grader/base/process.h"
#include "grader/commands/context.h"
#include "grader/grade/grading.h"

namespace meshgrade {
namespace {

Report grade_normal(const Submission& submission, const Home& home) {
  return grade(read_assignment(standard_assignment()), submission, home, {"vertex_normal"},
               [](const std::string&) {});
}

const SourceFile kNormal{"vertex_normal.cpp",
                         "#include \"meshedit/meshedit.h\"\n"
                         "meshedit::Vector3D helper() { return {1, 0, 0}; }\n"
                         "namespace meshedit {\n"
                         "Vector3D Vertex::normal() const { return helper(); }\n"
                         "}\n"};

TEST(CompileBlame, CompilerThatBreaksIsAnErrorOfTheGrader) {
  const ScratchFolder folder;
  const std::filesystem::path script = folder.path() / "compiler";
  Home home = find_home();
  std::ofstream(script) << "#!/bin/sh\n"
                        << "case \"$*\" in *vertex_normal.cpp\\ -o*) kill -9 $$ ;; esac\n"
                        << "exec " << home.compiler << " \"$@\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  home.compiler = script.string();
  home.sandbox = Sandbox();  // in which this compiler could not be found
  Submission submission;
  submission.sources = {kNormal};
  const Report report = grade_normal(submission, home);
  EXPECT_STREQ(verdict_name(report.exercises.at(0).verdict), "grader error");
  EXPECT_TRUE(report.has_grader_error());
  EXPECT_EQ(report.exercises.at(0).cases.at(0).note,
            "vertex_normal.cpp, which holds Vertex::normal, was not compiled: the compiler "
            "itself broke, twice");
}

TEST(CompileBlame, FileOfTheExerciseIsNotCompiledAlsoWhereTheFunctionIsNotInIt) {
  Submission submission;
  submission.sources = {{"vertex_normal.cpp", "garbage\n"}};
  const Report report = grade_normal(submission, find_home());
  EXPECT_STREQ(verdict_name(report.exercises.at(0).verdict), "not compiled");
  EXPECT_EQ(report.exercises.at(0).cases.at(0).note,
            "vertex_normal.cpp does not compile, and holds no Vertex::normal");
}

TEST(CompileBlame, FileThatDoesNotLinkIsToldWhy) {
  Submission submission;
  submission.sources = {{"a.cpp",
                         "#include \"meshedit/meshedit.h\"\n"
                         "meshedit::Vector3D helper() { return {0, 1, 0}; }\n"},
                        kNormal};
  const Report report = grade_normal(submission, find_home());
  EXPECT_STREQ(verdict_name(report.exercises.at(0).verdict), "not compiled");
  EXPECT_EQ(
      report.exercises.at(0).cases.at(0).note,
      "vertex_normal.cpp, which holds Vertex::normal, does not link: helper is defined in "
      "a.cpp as well; make one of them static, or rename it");
}

}  // namespace
}  // namespace meshgrade

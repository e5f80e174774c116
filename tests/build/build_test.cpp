#include "grader/build/build.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <optional>

#include <filesystem>
#include <fstream>

#include "grader/base/errors.h"
#include "grader/cases/mesh_input.h"
#include "grader/sandbox/lent_user.h"
#include "tests/support/sample_meshes.h"
#include "tests/support/submissions.h"

namespace meshgrade {
namespace {

const SourceFile kGoodNormal = normal_file("  return {1, 0, 0};");

/// The first normal of a tetrahedron by the built worker.
Point3 first_normal(const Build& build) {
  const Case c{
      "vertex_normal", "basic", 1, "", to_wire(NormalInput{sample_polygons("tetrahedron.obj")}),
      10'000};
  const Outcome outcome = run_cases(build, {&c}, Limits{}, Company::kTogether).at(0);
  return outcome.steps.empty() ? Point3{NAN, NAN, NAN} : from_wire<Point3>(outcome.steps[0]);
}

bool is_clean(const Build& build, const std::string& messages) {
  const Home home = test_home();
  for (const std::string& path :
       {build.folder.path().string(), home.include.string(), home.kit.string()}) {
    if (messages.find(path) != std::string::npos) return false;
  }
  return messages.find('\033') == std::string::npos;
}

TEST(Build, FileThatDoesNotCompileCostsOnlyItself) {
  const Build build = build_sources(
      {{"broken.cpp", "int f( {\n"}, kGoodNormal, {"also.cpp", "int a = \"\";\n"}});
  EXPECT_FALSE(build.find("broken.cpp")->ok);
  EXPECT_FALSE(build.find("also.cpp")->ok);
  EXPECT_TRUE(build.find("normal.cpp")->ok);
  EXPECT_NE(build.find("broken.cpp")->messages.find("broken.cpp:1:"), std::string::npos);
  EXPECT_TRUE(is_clean(build, build.find("broken.cpp")->messages));
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
  EXPECT_EQ(build.find("no_such_file.cpp"), nullptr);
}

TEST(Build, FileThatNeedsALaterOneIsLinkedWithIt) {
  const Build build =
      build_sources({{"a.cpp", "int later(); int early() { return later(); }\n"},
                     {"b.cpp", "int later() { return 3; }\n"},
                     {"c.cpp", "int clash() { return 1; }\n"},
                     {"d.cpp", "int clash() { return 2; }\n"}});
  EXPECT_TRUE(build.find("a.cpp")->ok);
  EXPECT_TRUE(build.find("b.cpp")->ok);
}

TEST(Build, SameFunctionInTwoFilesLeavesOneOutWithAMessage) {
  const Build build = build_sources({{"a.cpp", "int helper() { return 1; }\n"},
                                     {"b.cpp", "int helper() { return 2; }\n"},
                                     kGoodNormal});
  EXPECT_TRUE(build.find("a.cpp")->ok);
  EXPECT_FALSE(build.find("b.cpp")->ok);
  EXPECT_NE(build.find("b.cpp")->messages.find("helper"), std::string::npos);
  EXPECT_TRUE(is_clean(build, build.find("b.cpp")->messages));
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
}

TEST(Build, LinkErrorIsToldInPlainWordsFirst) {
  const Build build = build_sources(
      {{"a.cpp", "int helper() { return 1; }\n"}, {"b.cpp", "int helper() { return 2; }\n"}});
  EXPECT_TRUE(build.find("a.cpp")->linked);
  EXPECT_FALSE(build.find("b.cpp")->linked);
  const std::string plain =
      "helper is defined in a.cpp as well; make one of them static, or rename it\n";
  EXPECT_EQ(build.find("b.cpp")->messages.substr(0, plain.size()), plain)
      << build.find("b.cpp")->messages;
}

/// A compiler that breaks `times` times and then works.
Home home_with_breaking_compiler(const ScratchFolder& folder, int times) {
  Home home = test_home();
  const std::filesystem::path script = folder.path() / "compiler";
  const std::string count = (folder.path() / "count").string();
  std::ofstream(script) << "#!/bin/sh\n"
                        << "echo x >> " << count << "\n"
                        << "case $(wc -l < " << count << ") in\n"
                        << "  [1-" << times << "]) kill -9 $$ ;;\n"
                        << "esac\n"
                        << "exec " << home.compiler << " \"$@\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  home.compiler = script.string();
  home.sandbox = Sandbox();  // in which this compiler could not be found
  return home;
}

TEST(Build, CompilerThatBreaksOnceIsAskedAgain) {
  const ScratchFolder folder;
  const Build build = build_submission(submission_of({kGoodNormal}),
                                       home_with_breaking_compiler(folder, 1), Limits{});
  EXPECT_TRUE(build.files[0].ok) << build.files[0].messages;
  EXPECT_FALSE(build.files[0].compiler_died);
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
}

TEST(Build, CompilerThatBreaksTwiceIsNotTheStudentsFault) {
  const ScratchFolder folder;
  const Build build = build_submission(submission_of({kGoodNormal}),
                                       home_with_breaking_compiler(folder, 2), Limits{});
  EXPECT_FALSE(build.files[0].ok);
  EXPECT_TRUE(build.files[0].compiler_died);
  EXPECT_NE(build.files[0].messages.find("no fault of the code"), std::string::npos);
  EXPECT_FALSE(build_sources({{"a.cpp", "int f( {\n"}}).files[0].compiler_died);
}

TEST(Build, FunctionThatIsNowhereCostsOnlyItsCaller) {
  const Build build =
      build_sources({{"a.cpp", "int nowhere(); int a() { return nowhere(); }\n"}, kGoodNormal});
  ASSERT_EQ(build.find("a.cpp")->left_out.size(), 1U);
  EXPECT_EQ(build.find("a.cpp")->left_out[0].function, "a");
  EXPECT_NE(build.find("a.cpp")->messages.find("nowhere"), std::string::npos);
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
}

TEST(Build, OwnMainDoesNoHarm) {
  const Build build = build_sources({{"main.cpp", "int main() { return 5; }\n"}, kGoodNormal});
  EXPECT_TRUE(build.find("main.cpp")->ok) << build.find("main.cpp")->messages;
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
}

TEST(Build, HeadersOfTheStudentAreFound) {
  const Build build =
      build_sources({normal_file("  return {kOne, 0, 0};", "#include \"mine.h\"")},
                    {{"mine.h", "#pragma once\nconst double kOne = 1;\n"}});
  EXPECT_TRUE(build.files[0].ok) << build.files[0].messages;
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
}

TEST(Build, NothingAtAllCanBeBuilt) {
  const Build build = build_sources({});
  EXPECT_TRUE(build.files.empty());
  EXPECT_TRUE(std::filesystem::exists(build.worker));
}

TEST(Build, MessagesNameNoFolderOfTheMachine) {
  const Build build = build_sources(
      {{"a.cpp",
        "#include \"meshedit/meshedit.h\"\n"
        "#include \"meshedit/nothing.h\"\n"},
       {"b.cpp",
        "#include \"meshedit/meshedit.h\"\n"
        "using namespace meshedit;\n"
        "void f(HalfedgeIter h, VertexIter v) { h->twin() = v; h->setNeighbors(h); }\n"}});
  for (const BuiltFile& file : build.files) {
    EXPECT_FALSE(file.messages.empty());
    EXPECT_TRUE(is_clean(build, file.messages)) << file.messages;
  }
}

TEST(Build, WarningsOfAFileThatCompilesAreKept) {
  const Build build = build_sources({{"a.cpp", "int f() { int unused; return 1; }\n"}});
  EXPECT_TRUE(build.files[0].ok);
  EXPECT_NE(build.files[0].messages.find("unused"), std::string::npos);
}

TEST(Build, CompilerThatTakesTooLongIsStopped) {
  Limits limits;
  limits.compile_seconds = 2;
  const std::string bomb =
      "template <int N> struct F { enum { v = F<N - 1>::v + F<N - 2>::v }; };\n"
      "constexpr long spin(long n) { long s = 0; for (long i = 0; i < n; ++i) s += i; "
      "return s; }\n"
      "template <int N> struct G { static constexpr long v = spin(200000 + N) + G<N - 1>::v; "
      "};\n"
      "template <> struct G<0> { static constexpr long v = 0; };\n"
      "long x = G<800>::v;\n";
  const auto start = std::chrono::steady_clock::now();
  const Build build =
      build_submission(submission_of({{"bomb.cpp", bomb}}), test_home(), limits);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_FALSE(build.files[0].ok);
  EXPECT_NE(build.files[0].messages.find("took longer than 2 seconds"), std::string::npos)
      << build.files[0].messages.substr(0, 500);
}

TEST(Build, EndlessIncludeIsStopped) {
  Limits limits;
  limits.compile_seconds = 3;
  const Build build = build_submission(
      submission_of({{"zero.cpp", "#include \"/dev/zero\"\n"}}), test_home(), limits);
  EXPECT_FALSE(build.files[0].ok);
  EXPECT_FALSE(build.files[0].messages.empty());
}

/// In a batch, other runs take and give back users between the steps of this one.
TEST(Build, WorkerRunsAsAnotherUserThanItWasLinkedBy) {
  const mode_t before = ::umask(077);
  const Build build = build_sources({kGoodNormal});
  std::optional<LentUser> taken;
  if (::geteuid() == 0) taken.emplace();
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
  ::umask(before);
}

TEST(Build, FunctionsOfTheStudentsOwnReplaceNoneOfTheWorkers) {
  const Build build = build_sources(
      {kGoodNormal,
       {"own.cpp",
        "extern \"C\" long write(int, const void*, unsigned long) { return -1; }\n"
        "extern \"C\" long pwrite(int, const void*, unsigned long, long) { return -1; }\n"
        "extern \"C\" void* malloc(unsigned long) { return nullptr; }\n"}});
  EXPECT_TRUE(build.find("own.cpp")->ok) << build.find("own.cpp")->messages;
  EXPECT_EQ(first_normal(build), (Point3{1, 0, 0}));
}

// A busy machine is no fault of the student's: functions behind an adapter that is missing
// would be told as not implemented.
TEST(Build, AdapterThatTakesTooLongIsTheGradersFault) {
  const ScratchFolder folder;
  Home home = test_home();
  const std::filesystem::path script = folder.path() / "slow";
  std::ofstream(script) << "#!/bin/sh\n"
                        << "case \"$*\" in *adapter.cpp*) sleep 10 ;; esac\n"
                        << "exec " << home.compiler << " \"$@\"\n";
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  home.compiler = script.string();
  home.sandbox = Sandbox();  // in which this compiler could not be found
  Submission submission;
  submission.dialect = Dialect::kScotty3d;
  submission.sources = {{"halfedge-local.cpp", "int nothing_yet() { return 0; }\n"}};
  Limits limits;
  limits.compile_seconds = 2;
  EXPECT_THROW(build_submission(submission, home, limits), GraderError);
}

}  // namespace
}  // namespace meshgrade

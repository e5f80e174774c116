#include "grader/submission/skeleton_cutter.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "grader/base/errors.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The message with which `source` is refused; empty if it is not.
std::string refusal_of(const std::string& source) {
  try {
    cut_solution(source, "reference/edge_flip.cpp");
  } catch (const GraderError& error) {
    return error.what();
  }
  return "";
}

testing::AssertionResult is_refused(const std::string& source, const std::string& place,
                                    const std::string& reason) {
  const std::string message = refusal_of(source);
  if (message.rfind("reference/edge_flip.cpp:" + place + ": ", 0) == 0 &&
      message.find(reason) != std::string::npos && message.find('\n') == std::string::npos) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << "the message is: \"" << message << '"';
}

TEST(SkeletonCutter, TextWithoutMarksStaysByteForByte) {
  for (const std::string text : {"", "\n", "int a;", "int a;\r\n\n\n  // a solution\n"}) {
    EXPECT_EQ(cut_solution(text, "f"), text);
  }
}

TEST(SkeletonCutter, BodyBecomesTodoAndNotImplemented) {
  const std::string source =
      "int f(int x) {\n"
      "  // SOLUTION BEGIN A::f\n"
      "  int y = x;\n"
      "\n"
      "  return y;\n"
      "  // SOLUTION END\n"
      "}\n";
  EXPECT_EQ(cut_solution(source, "f"),
            "int f(int x) {\n"
            "  // TODO: your code goes here. Delete the next line when you start.\n"
            "  notImplemented(\"A::f\");\n"
            "}\n");
}

TEST(SkeletonCutter, StubKeepsTheIndentationOfItsMark) {
  EXPECT_EQ(cut_solution("\t// SOLUTION BEGIN f\n// SOLUTION END\n", "f"),
            "\t// TODO: your code goes here. Delete the next line when you start.\n"
            "\tnotImplemented(\"f\");\n");
}

TEST(SkeletonCutter, PartWithoutNameVanishesWithOneEmptyLine) {
  EXPECT_EQ(cut_solution("a\n\n// SOLUTION BEGIN\nhelper\n// SOLUTION END\n\nb\n", "f"),
            "a\n\nb\n");
}

TEST(SkeletonCutter, PartWithoutNameJoinsNoLinesThatItDoesNotStandBetween) {
  EXPECT_EQ(cut_solution("a\n// SOLUTION BEGIN\n// SOLUTION END\n\nb\n", "f"), "a\n\nb\n");
  EXPECT_EQ(cut_solution("a\n\n// SOLUTION BEGIN\n// SOLUTION END\nb\n", "f"), "a\n\nb\n");
  EXPECT_EQ(cut_solution("// SOLUTION BEGIN\n// SOLUTION END\n\nb\n", "f"), "b\n");
  EXPECT_EQ(cut_solution("a\n// SOLUTION BEGIN\n// SOLUTION END", "f"), "a\n");
}

TEST(SkeletonCutter, CuttingTwiceIsCuttingOnce) {
  const std::string once =
      cut_solution("f() {\n  // SOLUTION BEGIN f\n  x\n  // SOLUTION END\n}\n", "f");
  EXPECT_EQ(cut_solution(once, "f"), once);
}

TEST(SkeletonCutter, BeginWithoutEndIsRefusedAtTheBegin) {
  EXPECT_TRUE(is_refused("a\n  // SOLUTION BEGIN f\nb\n", "2", "without a SOLUTION END"));
}

TEST(SkeletonCutter, EndWithoutBeginIsRefused) {
  EXPECT_TRUE(is_refused("a\n\n  // SOLUTION END\n", "3", "without a SOLUTION BEGIN"));
  EXPECT_TRUE(is_refused("  // SOLUTION BEGIN f\n  // SOLUTION END\n// SOLUTION END\n", "3",
                         "without a SOLUTION BEGIN"));
}

TEST(SkeletonCutter, NestedPartsAreRefusedWithBothLines) {
  EXPECT_TRUE(is_refused("// SOLUTION BEGIN\na\n  // SOLUTION BEGIN f\n  // SOLUTION END\n",
                         "3", "begins at line 1"));
}

TEST(SkeletonCutter, UnknownMarksAreRefused) {
  const std::string reason = "this is no mark";
  EXPECT_TRUE(is_refused("// SOLUTION\n", "1", reason));
  EXPECT_TRUE(is_refused("// SOLUTION BEGINS f\n", "1", reason));
  EXPECT_TRUE(is_refused("// SOLUTION ENDS\n", "1", reason));
  EXPECT_TRUE(is_refused("x();  // SOLUTION BEGIN f\n", "1", reason));
  EXPECT_TRUE(is_refused("  // SOLUTION BEGIN two words\n", "1", reason));
  EXPECT_TRUE(is_refused("  // SOLUTION BEGIN f\n  // SOLUTION STOP\n", "2", reason));
}

TEST(SkeletonCutter, NameBelongsToIndentedPartsOnly) {
  EXPECT_TRUE(is_refused("// SOLUTION BEGIN f\n// SOLUTION END\n", "1", "must be indented"));
  EXPECT_TRUE(is_refused("  // SOLUTION BEGIN\n  // SOLUTION END\n", "1", "must name"));
}

std::set<std::string> sources_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".cpp") names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(Skeleton, HasTheSameFilesAsTheReference) {
  const fs::path root = MESHGRADE_SOURCE_DIR;
  EXPECT_EQ(sources_in(root / "student_skeleton"), sources_in(root / "reference"));
}

TEST(Skeleton, EveryFileIsTheReferenceWithItsSolutionsCutOut) {
  const fs::path root = MESHGRADE_SOURCE_DIR;
  for (const std::string& name : sources_in(root / "reference")) {
    const std::string skeleton =
        cut_solution(read(root / "reference" / name), "reference/" + name);
    EXPECT_EQ(read(root / "student_skeleton" / name), skeleton) << name;
    EXPECT_NE(skeleton.find("notImplemented("), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace meshgrade

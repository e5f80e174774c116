#include "grader/similarity/similarity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "grader/base/process.h"
#include "grader/base/safe_file.h"
#include "tests/support/scratch_files.h"
#include "tests/support/user_error.h"

namespace meshgrade {
namespace {

const std::string kSource = MESHGRADE_SOURCE_DIR;

Submission skeleton() {
  return find_submission(kSource + "/student_skeleton", {});
}

std::string renamed(const std::string& text) {
  return "// all my own work\n" +
         std::regex_replace(text, std::regex("\\b(h|sum|b|c|normal_sum)\\b"), "my_$1");
}

class Similarity : public testing::Test {
 protected:
  std::vector<SimilarPair> compare() {
    const Roster roster = read_roster(folder_.path(), {});
    return read_for_comparison(roster, skeleton(), {}, notes_).pairs(1);
  }

  ScratchFolder folder_;
  std::vector<std::string> notes_;
};

TEST_F(Similarity, ACopyWithOtherNamesStandsOnTop) {
  const std::string normal = read_whole_file(kSource + "/reference/vertex_normal.cpp");
  write_file(folder_.path() / "ann" / "normal.cpp", normal);
  write_file(folder_.path() / "bob" / "normal.cpp", renamed(normal));
  write_file(folder_.path() / "cem" / "curve.cpp",
             read_whole_file(kSource + "/reference/bezier_curve.cpp"));
  write_file(folder_.path() / "dan" / "essay.txt", "x");
  const auto pairs = compare();
  ASSERT_FALSE(pairs.empty());
  EXPECT_EQ(pairs[0].first, "ann");
  EXPECT_EQ(pairs[0].second, "bob");
  EXPECT_GE(pairs[0].most(), 95);
  for (std::size_t i = 1; i < pairs.size(); ++i)
    EXPECT_LT(pairs[i].most(), pairs[0].most());
  EXPECT_THAT(notes_, testing::ElementsAre(testing::HasSubstr("dan is not compared")));
}

TEST_F(Similarity, TheSkeletonAloneIsNothingInCommon) {
  for (const char* who : {"ann", "bob"}) {
    for (const SourceFile& file : skeleton().sources)
      write_file(folder_.path() / who / file.name, file.text);
  }
  EXPECT_THAT(compare(), testing::IsEmpty());
}

TEST_F(Similarity, FilesOfTheCourseChangeNothing) {
  for (const char* who : {"ann", "bob"}) {
    write_file(folder_.path() / who / "src" / "student_code.cpp",
               std::string("#include \"student_code.h\"\nnamespace CGL {\n") +
                   (*who == 'a' ? "double first(double x) { return x * x + 1.0; }\n"
                                : "bool second(int n) { while (n > 4) n /= 2; return !n; }\n") +
                   "}\n");
  }
  const auto found = [&] {
    std::vector<std::pair<int, int>> shares;
    for (const SimilarPair& pair : compare())
      shares.emplace_back(pair.of_first, pair.of_second);
    return shares;
  };
  const auto without = found();
  const std::string program = read_whole_file(kSource + "/grader/base/text.cpp");
  for (const char* who : {"ann", "bob"}) {
    const auto src = folder_.path() / who / "src";
    write_file(src / "meshEdit.cpp", "#include \"meshEdit.h\"\n" + program);
    write_file(src / "collada.h", program);
  }
  EXPECT_EQ(found(), without);
}

TEST_F(Similarity, SkeletonLinesAreTakenOutWhateverTheirSpace) {
  Submission handed_out;
  handed_out.sources = {{"a.cpp", "int given() {\n  return 1;\n}\n"}};
  EXPECT_EQ(without_skeleton("int given()  {\r\n\treturn 1;\n  return 2;\n}\n", handed_out),
            "               \n          \n  return 2;\n}\n");
}

}  // namespace
}  // namespace meshgrade

#include "grader/mutants/variants.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace meshgrade {
namespace {

std::string textbook(const std::string& exercise) {
  const std::filesystem::path folder =
      std::filesystem::path(MESHGRADE_SOURCE_DIR) / "tests" / "mutants" / "textbook";
  std::ostringstream text;
  text << std::ifstream(folder / (exercise + ".cpp")).rdbuf();
  return text.str();
}

TEST(Variants, TheSameSeedGivesTheSameVariant) {
  const std::string solution = textbook("edge_split");
  Random one(5, "variants");
  Random other(5, "variants");
  EXPECT_EQ(make_variant(solution, one), make_variant(solution, other));
}

TEST(Variants, OfASplitAreNearlyAllDifferent) {
  const std::string solution = textbook("edge_split");
  Random random(5, "variants");
  std::set<std::string> texts{solution};
  for (int i = 0; i < 50; ++i)
    texts.insert(make_variant(solution, random));
  EXPECT_EQ(texts.size(), 51U);
}

TEST(Variants, CreateAsManyElementsAsTheOriginal) {
  const auto count = [](const std::string& text, const std::string& word) {
    std::size_t found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos;
         at = text.find(word, at + 1))
      ++found;
    return found;
  };
  const std::string solution = textbook("edge_split");
  Random random(11, "variants");
  for (int i = 0; i < 20; ++i) {
    const std::string variant = make_variant(solution, random);
    for (const char* word : {"newHalfedge()", "newEdge()", "newFace()", "newVertex()"}) {
      EXPECT_EQ(count(variant, word), count(solution, word)) << variant;
    }
  }
}

TEST(Variants, LeaveEverythingOutsideTheMarksAlone) {
  const std::string solution = "int f(int a) {\n  return a + 1;\n}\n";
  Random random(3, "variants");
  EXPECT_EQ(make_variant(solution, random), solution);
}

}  // namespace
}  // namespace meshgrade

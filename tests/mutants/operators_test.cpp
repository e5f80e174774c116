#include "grader/mutants/operators.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grader/mutants/adequacy.h"
#include "grader/mutants/mutant.h"

namespace meshgrade {
namespace {

std::string in_function(const std::string& lines) {
  return "namespace meshedit {\n\nVector3D Vertex::normal() const {\n"
         "  // SOLUTION BEGIN Vertex::normal\n" +
         lines + "  // SOLUTION END\n}\n\n}  // namespace meshedit\n";
}

/// What the mutants of one operator make of the lines that they change.
std::vector<std::string> mutants_of(const std::string& lines, const std::string& name) {
  const Original original{"textbook", {}};
  std::vector<std::string> found;
  for (const Mutant& mutant : make_mutants(original, {"x.cpp", in_function(lines)})) {
    if (mutant.operator_name == name) found.push_back(mutant.becomes);
  }
  return found;
}

using Texts = std::vector<std::string>;

TEST(Mutants, AStatementIsDroppedAndADeclarationIsNot) {
  EXPECT_EQ(mutants_of("  double a = 1;\n  a = 2;\n", "drop-statement"), Texts({";"}));
}

TEST(Mutants, OnlyNextAndTwinOfSetNeighborsAreSwapped) {
  EXPECT_EQ(mutants_of("  h->setNeighbors(n, t, v, e, f);\n", "swap-arguments"),
            Texts({"h->setNeighbors(t, n, v, e, f);"}));
}

TEST(Mutants, AVariableIsReplacedByTheNextOfItsType) {
  EXPECT_EQ(mutants_of("  FaceIter f = x();\n  FaceIter g = x();\n  EdgeIter e = x();\n"
                       "  h->face() = f;\n",
                       "other-variable"),
            Texts({"h->face() = g;"}));
}

TEST(Mutants, AStepIsAnotherOrIsMissingOrTooMany) {
  EXPECT_EQ(mutants_of("  h = g->next();\n", "other-step"),
            Texts({"h = g->twin();", "h = g;", "h = g->next()->next();"}));
}

TEST(Mutants, TemplateBracketsAndArrowsAreNoComparisons) {
  EXPECT_TRUE(mutants_of("  std::vector<double> a;\n  h->next();\n", "comparison").empty());
  EXPECT_EQ(mutants_of("  b = i < n;\n", "comparison"), Texts({"b = i <= n;", "b = i > n;"}));
}

TEST(Mutants, ConditionsAreDroppedTurnedAndHalved) {
  const Texts found = mutants_of("  if (a && b) c();\n", "condition");
  EXPECT_EQ(found, Texts({"if (true) c();", "if (false) c();", "if (!(a && b)) c();",
                          "if (a ) c();", "if ( b) c();"}));
}

TEST(Mutants, AMistakeIsMadeOnSomeOccasionsOnly) {
  const Texts found = mutants_of("  Vector3D a;\n  a = b();\n", "sometimes");
  EXPECT_NE(std::find(found.begin(), found.end(), "if (!above_valence_12) a = b();"),
            found.end());
  EXPECT_NE(std::find(found.begin(), found.end(),
                      "if (halfedge()->vertex()->degree() > 12) return {}; Vector3D a;"),
            found.end());
}

TEST(Mutants, AMistakeMadeSometimesIsExplainedByTheSameMadeAlways) {
  const Original original{"textbook", {}};
  std::size_t sometimes = 0;
  for (const Mutant& mutant : make_mutants(original, {"x.cpp", in_function("  a = b();\n")})) {
    if (mutant.becomes.rfind("if (!", 0) != 0) continue;
    ++sometimes;
    EXPECT_EQ(mutant.always, "textbook/x.cpp: drop-statement: a = b(); => ;");
    EXPECT_EQ(reason_of(mutant, {{mutant.always, "because"}}), "because");
    EXPECT_EQ(reason_of(mutant, {}), "");
  }
  EXPECT_GE(sometimes, 3U);
}

TEST(Mutants, NothingOutsideTheMarksIsChanged) {
  const Original original{"reference", {}};
  EXPECT_TRUE(make_mutants(original, {"x.cpp", "int f() {\n  return 1 + 2;\n}\n"}).empty());
}

TEST(Mutants, NoTwoAreTheSameAndEachHasAnIdOfItsOwn) {
  const Original original{"reference", {}};
  const std::string lines =
      "  a = 1;\n  a = 1;\n  for (int i = 0; i < 3; ++i) {\n    b();\n  }\n";
  std::vector<std::string> ids;
  std::vector<std::string> texts;
  for (const Mutant& mutant : make_mutants(original, {"x.cpp", in_function(lines)})) {
    ids.push_back(mutant.id());
    texts.push_back(mutant.text);
    EXPECT_EQ(mutant.function, "normal");
  }
  for (auto* list : {&ids, &texts}) {
    std::sort(list->begin(), list->end());
    EXPECT_EQ(std::adjacent_find(list->begin(), list->end()), list->end());
  }
}

}  // namespace
}  // namespace meshgrade

#include "grader/mutants/source_code.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

constexpr const char* kText = R"(#include "meshedit/meshedit.h"
namespace meshedit {
// SOLUTION BEGIN
namespace {
void helper(HalfedgeMesh& mesh, HalfedgeIter h) {
  h->next() = mesh.newHalfedge();
}
}  // namespace
// SOLUTION END
EdgeIter HalfedgeMesh::flipEdge(EdgeIter e0) {
  // SOLUTION BEGIN HalfedgeMesh::flipEdge
  if (e0->isBoundary()) return e0;
  const HalfedgeIter h = e0->halfedge();
  for (std::size_t i = 0; i < 3; ++i) {
    h->vertex()->isNew = true;
  }
  return e0;
  // SOLUTION END
}
}  // namespace meshedit
)";

TEST(SourceCode, FindsFunctionsWithTheirNames) {
  const SourceCode code(kText);
  ASSERT_EQ(code.functions().size(), 2U);
  EXPECT_EQ(code.functions()[0].name, "helper");
  EXPECT_TRUE(code.functions()[0].is_void);
  EXPECT_EQ(code.functions()[1].name, "flipEdge");
  EXPECT_FALSE(code.functions()[1].is_void);
}

TEST(SourceCode, FindsWhatIsDeclared) {
  const SourceCode code(kText);
  std::vector<std::string> found;
  for (const Declaration& d : code.declarations()) {
    found.push_back(d.type + " " + std::string(code.tokens()[d.name].text));
  }
  EXPECT_EQ(found,
            std::vector<std::string>({"HalfedgeMesh mesh", "HalfedgeIter h", "EdgeIter e0",
                                      "HalfedgeIter h", "std::size_t i"}));
}

TEST(SourceCode, FindsSimpleStatements) {
  const SourceCode code(kText);
  std::vector<std::string> found;
  for (Span statement : code.statements())
    found.emplace_back(code.text_of(statement));
  EXPECT_EQ(found, std::vector<std::string>({"h->next() = mesh.newHalfedge();", "return e0;",
                                             "const HalfedgeIter h = e0->halfedge();",
                                             "h->vertex()->isNew = true;", "return e0;"}));
}

TEST(SourceCode, OnlyTheSolutionIsOpen) {
  const SourceCode code(kText);
  for (const Token& token : code.tokens()) {
    if (token.is("flipEdge") || token.is("meshedit")) {
      EXPECT_FALSE(token.is_open);
    }
    if (token.is("isNew") || token.is("helper")) {
      EXPECT_TRUE(token.is_open);
    }
  }
}

}  // namespace
}  // namespace meshgrade

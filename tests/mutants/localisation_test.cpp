#include "grader/mutants/localisation.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

std::set<PointerName> wrong(const std::string& was, const std::string& becomes) {
  Mutant mutant;
  mutant.original = "textbook";
  mutant.exercise = "edge_split";
  mutant.was = was;
  mutant.becomes = becomes;
  return wrong_pointers(mutant);
}

using Names = std::set<PointerName>;

TEST(WrongPointers, AWrongArgumentIsOnePointer) {
  EXPECT_EQ(wrong("bm->setNeighbors(ma, mb, b, edge_bm, face_abm);",
                  "bm->setNeighbors(ma, mb, c, edge_bm, face_abm);"),
            Names({"half-edge bm.vertex"}));
}

TEST(WrongPointers, SwappedArgumentsAreTwo) {
  EXPECT_EQ(wrong("bm->setNeighbors(ma, mb, b, edge_bm, face_abm);",
                  "bm->setNeighbors(mb, ma, b, edge_bm, face_abm);"),
            Names({"half-edge bm.next", "half-edge bm.twin"}));
}

TEST(WrongPointers, ADroppedAnchorIsOne) {
  EXPECT_EQ(wrong("edge_mc->halfedge() = mc;", ";"), Names({"edge cm.halfedge"}));
}

TEST(WrongPointers, AnotherElementMeansThatBothAreWrong) {
  EXPECT_EQ(wrong("a->halfedge() = am;", "b->halfedge() = am;"),
            Names({"vertex a.halfedge", "vertex b.halfedge"}));
}

TEST(WrongPointers, LinesThatDoMoreDoNotCount) {
  EXPECT_TRUE(wrong("const HalfedgeIter ca = h->next();", "const HalfedgeIter ca = h->twin();")
                  .empty());
  EXPECT_TRUE(wrong("a->halfedge() = am;", "return {}; a->halfedge() = am;").empty());
}

TEST(NamedPointer, IsReadFromAFindingsElement) {
  EXPECT_EQ(named_pointer("h12.next, of bm"), "half-edge bm.next");
  EXPECT_EQ(named_pointer("v3.halfedge, of a"), "vertex a.halfedge");
  EXPECT_EQ(named_pointer("e5.halfedge, of mc"), named_pointer("e5.halfedge, of cm"));
  EXPECT_EQ(named_pointer("f2.halfedge, of bma"), named_pointer("f2.halfedge, of abm"));
}

TEST(NamedPointer, IsEmptyForOtherElements) {
  EXPECT_EQ(named_pointer("h12"), "");
  EXPECT_EQ(named_pointer("the mesh"), "");
  EXPECT_EQ(named_pointer(""), "");
}

}  // namespace
}  // namespace meshgrade

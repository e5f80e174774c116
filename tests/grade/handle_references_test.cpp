#include "grader/grade/handle_references.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

TEST(FindHandleReference, NamesTheLineOfAReferenceToAPointer) {
  EXPECT_EQ(find_handle_reference("void f() {\n  HalfedgeIter& ca = h->next();\n}\n"),
            "line 2: HalfedgeIter& ca = h->next()");
  EXPECT_EQ(find_handle_reference("const EdgeCIter &e = h->edge();"),
            "line 1: const EdgeCIter &e = h->edge()");
  EXPECT_EQ(find_handle_reference("auto& t = h->twin();"), "line 1: auto& t = h->twin()");
}

TEST(FindHandleReference, LeavesOtherReferencesAlone) {
  for (const char* code : {
           "HalfedgeIter ca = h->next();",
           "void f(HalfedgeIter& h, EdgeIter& e);",
           "for (EdgeIter& e : edges) mesh.flipEdge(e);",
           "// HalfedgeIter& ca = h->next();",
           "const char* s = \"HalfedgeIter& ca = h->next();\";",
           "auto& list = lists[0];",
           "bool same = a == b && c == d;",
           "HalfedgeIter& (*f)() = nullptr;",
       }) {
    EXPECT_EQ(find_handle_reference(code), "") << code;
  }
}

JudgedExercise exercise_with(std::size_t wrong_pointers) {
  JudgedExercise exercise;
  exercise.cases.emplace_back();
  Finding finding;
  finding.pointers.wrong.resize(wrong_pointers);
  exercise.cases[0].judgement.findings.push_back(finding);
  return exercise;
}

TEST(NoteHandleReferences, SpeaksOnlyOfManyWrongPointersInTheFileOfTheExercise) {
  Submission submission;
  submission.sources = {{"other.cpp", "HalfedgeIter& x = h->next();"},
                        {"edge_flip.cpp",
                         "EdgeIter HalfedgeMesh::flipEdge(EdgeIter e) {\n"
                         "  HalfedgeIter& ca = h->next();"}};
  JudgedExercise many = exercise_with(5);
  note_handle_references(submission, {"HalfedgeMesh::flipEdge"}, many);
  ASSERT_EQ(many.notes.size(), 1U);
  EXPECT_EQ(many.notes[0].rfind("edge_flip.cpp, line 2: HalfedgeIter& ca = h->next(): ", 0), 0U)
      << many.notes[0];
  JudgedExercise one = exercise_with(1);
  note_handle_references(submission, {"HalfedgeMesh::flipEdge"}, one);
  EXPECT_TRUE(one.notes.empty());
  JudgedExercise other = exercise_with(5);
  note_handle_references(submission, {"HalfedgeMesh::splitEdge"}, other);
  EXPECT_TRUE(other.notes.empty());
}

}  // namespace
}  // namespace meshgrade

// What is kept of a sanitizer's report.

#include "grader/grade/sanitizer_log.h"

#include <gtest/gtest.h>

namespace meshgrade {
namespace {

TEST(CleanSanitizerLog, KeepsWhatHappenedAndTheStudentsFrames) {
  EXPECT_EQ(
      clean_sanitizer_log(
          "=================================================================\n"
          "==42==ERROR: AddressSanitizer: heap-use-after-free on address 0x603000000070 at pc "
          "0x4e33a3 bp 0x7ffd sp 0x7ffe\n"
          "READ of size 8 at 0x603000000070 thread T0\n"
          "    #0 0x4e33a2 in meshedit::HalfedgeMesh::flipEdge(int) edge_flip.cpp:12\n"
          "    #1 0x4136b4 in run_task /home/me/meshgrade/grader/worker/child.cpp:154\n"
          "    #2 0x7fa6 in _start (/tmp/meshgrade-x/worker+0x4050c0)\n"
          "\n"
          "SUMMARY: AddressSanitizer: heap-use-after-free\n"
          "Shadow bytes around the buggy address:\n"),
      "  AddressSanitizer: heap-use-after-free\n"
      "  READ of size 8\n"
      "      edge_flip.cpp:12, meshedit::HalfedgeMesh::flipEdge(int)\n");
}

TEST(CleanSanitizerLog, KeepsUndefinedBehaviour) {
  EXPECT_EQ(clean_sanitizer_log(
                "./edge_flip.cpp:19:15: runtime error: member access within null pointer\n"
                "    #0 0x405a04 in flipEdge ./edge_flip.cpp:19:15\n"),
            "  ./edge_flip.cpp:19:15: runtime error: member access within null pointer\n"
            "      edge_flip.cpp:19, flipEdge\n");
}

TEST(CleanSanitizerLog, OfNothingIsNothing) {
  EXPECT_EQ(clean_sanitizer_log(""), "");
}

TEST(CleanSanitizerLog, LineMayBeAsLongAsItLikes) {
  const std::string name(300'000, 'f');
  EXPECT_EQ(clean_sanitizer_log("    #0 0x1 in " + name + " ./edge_flip.cpp:12\n"), "");
  EXPECT_LT(clean_sanitizer_log("==1==ERROR: " + name + "\n").size(), 3000U);
}

}  // namespace
}  // namespace meshgrade

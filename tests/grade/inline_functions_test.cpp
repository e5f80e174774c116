// A function that is defined `inline`, in a header or not, is as good as another: nobody in its
// own file need call it.

#include <gtest/gtest.h>

#include <algorithm>

#include "grader/commands/context.h"
#include "grader/grade/grading.h"
#include "grader/submission/function_extents.h"

namespace meshgrade {
namespace {

/// The solution with every member function that is defined outside of its class made inline.
Submission inline_solution(const Assignment& assignment) {
  Submission submission =
      find_submission(find_home().reference / assignment.folder, assignment.submission);
  for (SourceFile& file : submission.sources) {
    std::vector<FunctionExtent> functions = find_functions(file.text);
    std::reverse(functions.begin(), functions.end());  // so that offsets before stay right
    for (const FunctionExtent& function : functions) {
      if (function.name.find("::") != std::string::npos)
        file.text.insert(function.begin, "inline ");
    }
  }
  return submission;
}

class InlineFunctions : public testing::TestWithParam<const char*> {};

TEST_P(InlineFunctions, HaveEveryPoint) {
  const Assignment assignment = load_assignment(GetParam());
  const Submission submission = inline_solution(assignment);
  const Report report =
      grade(assignment, submission, find_home(), {}, [](const std::string&) {});
  EXPECT_EQ(report.points, report.max_points);
}

TEST_P(InlineFunctions, HaveEveryPointInHeaders) {
  const Assignment assignment = load_assignment(GetParam());
  Submission submission = inline_solution(assignment);
  for (SourceFile& file : submission.sources) {
    const std::string header = file.name + ".h";
    submission.headers.push_back({header, "#pragma once\n" + file.text});
    file.text = "#include \"" + header + "\"\n";
  }
  const Report report =
      grade(assignment, submission, find_home(), {}, [](const std::string&) {});
  EXPECT_EQ(report.points, report.max_points);
}

INSTANTIATE_TEST_SUITE_P(Assignments, InlineFunctions, testing::Values("", "polygon_meshes"),
                         [](const auto& tested) {
                           const std::string name = tested.param;
                           return name.empty() ? std::string("standard") : name;
                         });

}  // namespace
}  // namespace meshgrade

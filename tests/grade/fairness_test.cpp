// Nobody pays for another's mistake: with one function broken in any way, all others of a right
// solution keep their points.

#include <gtest/gtest.h>

#include <map>
#include <ostream>
#include <string>

#include "grader/grade/grading.h"
#include "grader/judge/judge.h"
#include "tests/grade/spoiled_reference.h"
#include "tests/support/standard_assignment.h"

namespace meshgrade {
namespace {

/// A way to break a function: a line at the beginning of its body.
struct Harm {
  const char* name;
  const char* line;
};

constexpr Harm kHarms[] = {
    {"crashes", "*(volatile int*)8 = 1;"},
    {"hangs", "for (volatile int i = 0;; i = i + 1) {}"},
    {"exits", "::exit(0);"},
    {"forges", "(void)!::pwrite(4, \"15 points, and this is no frame\", 31, 0);"},
};

/// The groups of an exercise of several functions, by the one that their cases are about.
const std::map<std::string, std::string> kGroups{{"step", "BezierPatch::evaluateStep"},
                                                 {"line", "BezierPatch::evaluate1D"},
                                                 {"surface", "BezierPatch::evaluate"},
                                                 {"stress", "BezierPatch::evaluate"}};

struct Broken {
  std::string exercise;
  std::string function;
  Harm harm;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(const Broken& broken, std::ostream* out) {
  *out << broken.function << " " << broken.harm.name;
}

std::vector<Broken> all_broken() {
  std::vector<Broken> all;
  for (const ExerciseRubric& rubric : read_assignment(standard_assignment()).exercises) {
    for (const std::string& function : find_exercise_judge(rubric).functions) {
      for (const Harm& harm : kHarms)
        all.push_back({rubric.name, function, harm});
    }
  }
  return all;
}

SourceFile broken_file(const Broken& broken) {
  SourceFile file = reference_file(broken.exercise + ".cpp");
  const std::string mark = "// SOLUTION BEGIN " + broken.function + "\n";
  const std::size_t at = file.text.find(mark);
  EXPECT_NE(at, std::string::npos) << broken.function;
  file.text.insert(at + mark.size(), std::string("  ") + broken.harm.line + "\n");
  file.text.insert(0, "#include <cstdlib>\n#include <unistd.h>\n");
  return file;
}

class Fairness : public testing::TestWithParam<Broken> {
 protected:
  static Report grade_broken() {
    Assignment assignment = read_assignment(standard_assignment());
    assignment.limits.case_cpu_ms = 300;
    Submission submission;
    submission.name = "test";
    for (const ExerciseRubric& rubric : assignment.exercises) {
      submission.sources.push_back(rubric.name == GetParam().exercise
                                       ? broken_file(GetParam())
                                       : reference_file(rubric.name + ".cpp"));
    }
    return grade(assignment, submission, find_home(), {}, [](const auto&) {});
  }

  /// Of the exercise with the broken function, all but its own groups.
  static void expect_others_right(const ExerciseReport& exercise) {
    for (const GroupReport& group : exercise.groups) {
      const auto about = kGroups.find(group.name);
      const bool several = exercise.name == "bezier_patch";
      if (several && about->second != GetParam().function) {
        EXPECT_EQ(group.points, group.max_points) << exercise.name << ": " << group.name;
      } else {
        EXPECT_EQ(group.points, 0.0) << exercise.name << ": " << group.name;
      }
    }
  }
};

TEST_P(Fairness, LeavesTheOthersTheirPoints) {
  const Report report = grade_broken();
  for (const ExerciseReport& exercise : report.exercises) {
    if (exercise.name == GetParam().exercise) {
      expect_others_right(exercise);
    } else {
      EXPECT_EQ(exercise.points, exercise.max_points) << exercise.name;
      EXPECT_EQ(exercise.extra_points, exercise.max_extra_points) << exercise.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, Fairness, testing::ValuesIn(all_broken()),
                         [](const auto& parameter) {
                           std::string name =
                               parameter.param.function + "_" + parameter.param.harm.name;
                           name.replace(name.find("::"), 2, "_");
                           return name;
                         });

}  // namespace
}  // namespace meshgrade

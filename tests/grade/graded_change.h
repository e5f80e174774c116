#pragma once

// Solutions of the second assignment that are the reference but for a line, graded.

#include <algorithm>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include "grader/grade/grading.h"
#include "tests/grade/spoiled_reference.h"

namespace meshgrade {

inline ExerciseReport grade_one(const std::string& exercise, SourceFile file) {
  static const Home home = find_home();
  static const Assignment assignment = load_assignment("polygon_meshes");
  file.name = exercise + ".cpp";
  Submission submission;
  submission.name = "test";
  submission.sources = {std::move(file)};
  const Report report =
      grade(assignment, submission, home, {exercise}, [](const std::string&) {});
  return report.exercises.at(0);
}

/// The assignment with these groups of an exercise only, which relies on no other: for
/// solutions that are wrong there, and call operations that are right.
inline Assignment only_groups(const std::string& exercise,
                              const std::vector<std::string>& groups) {
  Assignment assignment = load_assignment("polygon_meshes");
  for (ExerciseRubric& rubric : assignment.exercises) {
    if (rubric.name != exercise) continue;
    rubric.needs.clear();
    std::erase_if(rubric.groups, [&](const Group& group) {
      return std::find(groups.begin(), groups.end(), group.name) == groups.end();
    });
  }
  return assignment;
}

inline std::string path_of(const std::string& exercise) {
  return "polygon_meshes/" + exercise + ".cpp";
}

inline const Finding& first_finding(const ExerciseReport& report) {
  static const Finding none;
  for (const CaseReport& c : report.cases) {
    if (!c.findings.empty()) return c.findings[0].finding;
  }
  return none;
}

/// What is named as the cause, over all cases.
inline std::set<std::string> causes_of(const ExerciseReport& report) {
  std::set<std::string> names;
  for (const CaseReport& c : report.cases) {
    for (const auto& told : c.findings) {
      for (const Misconception& m : told.finding.likely)
        names.insert(m.name);
    }
  }
  return names;
}

struct Change {
  const char* name;
  const char* exercise;
  const char* was;
  const char* becomes;
  const char* rule;  ///< of the first finding; of a right solution empty
};

inline std::ostream& operator<<(std::ostream& out, const Change& change) {
  return out << change.exercise << ": " << change.name;
}

}  // namespace meshgrade

#pragma once

// Solutions of the second assignment that are the reference but for a line, graded.

#include <ostream>

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

#pragma once

#include <stdexcept>

#include "grader/cases/case_list.h"

namespace meshgrade {

inline const Assignment& standard_rubric() {
  static const Assignment assignment =
      read_assignment(MESHGRADE_SOURCE_DIR "/grader/assignment.toml");
  return assignment;
}

inline const Assignment& polygon_rubric() {
  static const Assignment assignment =
      read_assignment(MESHGRADE_SOURCE_DIR "/grader/polygon_meshes.toml");
  return assignment;
}

/// The exercises of all assignments that come along.
inline std::vector<std::string> all_exercises() {
  std::vector<std::string> names;
  for (const Assignment* assignment : {&standard_rubric(), &polygon_rubric()}) {
    for (const ExerciseRubric& rubric : assignment->exercises)
      names.push_back(rubric.name);
  }
  return names;
}

/// The assignment that comes along and has this exercise.
inline const Assignment& assignment_with(const std::string& exercise) {
  return standard_rubric().find(exercise) != nullptr ? standard_rubric() : polygon_rubric();
}

inline const ExerciseRubric& rubric_of(const std::string& exercise) {
  return *assignment_with(exercise).find(exercise);
}

/// All cases of one exercise of the assignments that come along.
inline const std::vector<Case>& standard_cases(const std::string& exercise) {
  static std::map<std::string, std::vector<Case>> made;
  std::vector<Case>& cases = made[exercise];
  if (cases.empty()) {
    cases = make_cases(assignment_with(exercise), rubric_of(exercise),
                       MESHGRADE_SOURCE_DIR "/meshes");
  }
  return cases;
}

/// A right answer to these is made from lists of faces, step after step: under the sanitizers,
/// only small meshes have their turn. The release build takes all.
inline bool takes_minutes_when_sanitized([[maybe_unused]] const Case& c) {
#ifdef __SANITIZE_ADDRESS__
  return (c.exercise == "isotropic_remeshing" || c.exercise == "simplification") &&
         c.input.size() > 5'000;
#else
  return false;
#endif
}

inline const Case& standard_case(const std::string& id) {
  for (const Case& c : standard_cases(id.substr(0, id.find(':')))) {
    if (c.id() == id) return c;
  }
  throw std::out_of_range("no case " + id);
}

}  // namespace meshgrade

#pragma once

#include <stdexcept>

#include "grader/cases/case_list.h"

namespace meshgrade {

inline const Assignment& standard_rubric() {
  static const Assignment assignment =
      read_assignment(MESHGRADE_SOURCE_DIR "/grader/assignment.toml");
  return assignment;
}

/// All cases of one exercise of the standard assignment.
inline const std::vector<Case>& standard_cases(const std::string& exercise) {
  static std::map<std::string, std::vector<Case>> made;
  std::vector<Case>& cases = made[exercise];
  if (cases.empty()) {
    cases = make_cases(standard_rubric(), *standard_rubric().find(exercise),
                       MESHGRADE_SOURCE_DIR "/meshes");
  }
  return cases;
}

inline const Case& standard_case(const std::string& id) {
  for (const Case& c : standard_cases(id.substr(0, id.find(':')))) {
    if (c.id() == id) return c;
  }
  throw std::out_of_range("no case " + id);
}

}  // namespace meshgrade

#pragma once

#include <string>
#include <vector>

#include "grader/report/report.h"

namespace meshgrade {

/// A group of cases as most platforms show it: one test with points and a text.
struct GradedGroup {
  const ExerciseReport* exercise = nullptr;
  const GroupReport* group = nullptr;
  const CaseReport* failure = nullptr;  ///< its first failure; nullptr if there is none
  std::string number;                   ///< "4.1": exercise and group
  std::string name;                     ///< "Edge flip: every inner edge of small meshes"
  std::string text;                     ///< how many cases passed, and the failure explained

  bool passed() const { return failure == nullptr && group->judged > 0; }
};

/// The groups of all exercises, in their order.
std::vector<GradedGroup> graded_groups(const Report& report);

/// A case as the terminal shows it.
std::string explain_case(const ExerciseReport& exercise, const CaseReport& c);

/// What is wrong with the submission as a whole: files that do not compile, and notes.
std::string general_text(const Report& report);

/// The points as a part of all required ones, from 0 to 1.
double share_of_points(const Report& report, bool extra_credit);

/// The text, cut off after so many bytes between two characters, with a word about it.
std::string cut_off(const std::string& text, std::size_t bytes);

}  // namespace meshgrade

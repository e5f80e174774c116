#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/assignment/late_rule.h"
#include "grader/batch/result_store.h"
#include "grader/roster/roster.h"

namespace meshgrade {

/// What an exercise is worth, and what somebody got for it.
struct ExercisePoints {
  std::string name;
  std::string verdict;  ///< empty where nothing was graded
  double points = 0.0;  ///< without extra credit
  double max_points = 0.0;
  double extra_points = 0.0;
  double max_extra_points = 0.0;
  std::string title = {};  ///< of the exercise; empty in the rows of a class
};

/// One hand-in of the class in short; the whole report is in the store.
struct ClassRow {
  std::string key;
  std::vector<Person> people;
  std::string submitted_at;
  bool late = false;  ///< by the assignment's rule, or else by the platform
  ResultStatus status = ResultStatus::kMissing;
  std::string reason;
  double points = 0.0;  ///< without extra credit, after what is taken off for being late
  double extra_points = 0.0;
  std::vector<ExercisePoints> exercises;  ///< those of the assignment, in its order; as earned
  double late_deduction = 0.0;            ///< what was taken off
  std::string late_note = {};             ///< how late it came, or why that is not known

  double points_before_late() const { return points + late_deduction; }

  /// Whether there are points to give: a fault of the grader gives none, not even 0.
  bool has_points() const {
    return status == ResultStatus::kGraded || status == ResultStatus::kUngradable;
  }
};

/// The results of a class.
struct ClassResults {
  std::string assignment;  ///< its title
  std::string layout;
  double max_points = 0.0;
  double max_extra_points = 0.0;
  std::vector<ExercisePoints> exercises;  ///< what they are worth
  std::vector<ClassRow> rows;             ///< in the order of the roster
  std::vector<Omission> left_out;
};

/// The file of a batch's folder that holds them.
constexpr const char* kClassFile = "class.json";

/// Looks up in the store what the hand-ins of the roster got, and takes off what the rule for
/// late work says.
ClassResults collect_results(const Roster& roster, const Assignment& assignment,
                             const std::vector<std::string>& exercises,
                             const ResultStore& store,
                             const std::optional<LateRule>& late = std::nullopt);

/// "87 - 10 = 77 points: 2 h after it was due"; empty if nothing is known of being late.
std::string late_text(const ClassRow& row);

/// The results as JSON; docs/batch.md explains the keys.
std::string to_json(const ClassResults& results);

/// The results that a batch has left in this folder.
/// @throws UserError if there are none, or they cannot be read
ClassResults load_class_results(const std::filesystem::path& batch_folder);

/// Reads what to_json() has written.
/// @throws UserError if it is something else
ClassResults read_class_results(const std::string& json);

}  // namespace meshgrade

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/base/stage_times.h"
#include "grader/build/build.h"
#include "grader/cases/case.h"
#include "grader/judge/judge.h"
#include "grader/sandbox/sandbox.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// A frame of the student's call stack with the line of code.
struct CodePlace {
  std::string function;
  std::string file;
  int line = 0;
  std::string code;  ///< the line itself, without the space around it
};

struct FindingReport {
  Finding finding;
  std::vector<CodePlace> places;  ///< innermost first
};

struct CaseReport {
  std::string id;
  std::string group;
  std::string title;
  std::string shrunk_from;  ///< what the case was before it was made smaller; mostly empty
  Verdict verdict = Verdict::kPassed;
  std::vector<FindingReport> findings;
  std::string note;
  bool excused = false;       ///< does not count: see CaseJudgement
  bool passes_alone = false;  ///< as in CaseJudgement
  bool hidden = false;        ///< not handed out: see student_view()
  std::string output;         ///< what the code printed in this case, cut off
  std::uint64_t output_bytes = 0;
  std::string figure;  ///< the name of the file with its picture; empty if none was written
  MeshScene scene;     ///< the step that went wrong, for the viewer; mostly empty
};

struct GroupReport {
  std::string name;
  std::string title;
  bool extra_credit = false;
  double points = 0.0;
  double max_points = 0.0;
  std::size_t passed = 0;
  std::size_t judged = 0;  ///< cases that count: all but those that are excused
  std::size_t cases = 0;
  std::string why;  ///< why it earns nothing, though cases passed; mostly empty
};

struct ExerciseReport {
  std::string name;
  std::string title;
  Verdict verdict = Verdict::kPassed;
  double points = 0.0;  ///< without extra credit
  double max_points = 0.0;
  double extra_points = 0.0;
  double max_extra_points = 0.0;
  std::vector<GroupReport> groups;
  std::vector<CaseReport> cases;
  std::vector<std::string> notes;  ///< "uses Warren's weights", "edge_split fails: see there"
  /// Exercises whose right solution stood in for the student's in the cases that count.
  std::vector<std::string> stand_ins;
};

/// Written into each report as JSON; docs/report.md says when it changes.
constexpr const char* kReportSchema = "meshgrade-report/1";

struct FileReport {
  std::string name;
  bool compiled = false;
  std::string messages;
  bool linked = true;  ///< false if it compiles, but not together with the other files
};

/// Everything that any rendering shows.
struct Report {
  std::string assignment;
  std::string submission;
  std::uint64_t seed = 0;
  HiddenShow hidden_show = HiddenShow::kAll;  ///< what students may see of hidden cases
  std::vector<std::string> notes;
  std::vector<FileReport> files;
  std::vector<ExerciseReport> exercises;
  Sandbox sandbox;  ///< in which the submission was compiled and run
  double points = 0.0;
  double max_points = 0.0;
  double extra_points = 0.0;
  double max_extra_points = 0.0;
  std::vector<Stage> timing;  ///< of the check; empty unless somebody asked

  bool has_grader_error() const;
  /// Of exercises about which nothing could be said. They are not earned, and not lost by a
  /// mistake either: a person has to look.
  double points_not_judged() const;
};

/// The report as the student may see it: of hidden cases only what the assignment allows.
Report student_view(Report report);

/// An exercise after judging, its cases in order.
struct JudgedCase {
  Case asked;
  CaseJudgement judgement;
  std::string output;
  std::uint64_t output_bytes = 0;
  std::string shrunk_from;  ///< as in CaseReport
};
struct JudgedExercise {
  const ExerciseRubric* rubric = nullptr;
  std::vector<JudgedCase> cases;
  std::vector<std::string> notes;
  std::vector<std::string> stand_ins;  ///< as in ExerciseReport
};

/// Adds up the points and collects what there is to say.
Report make_report(const Assignment& assignment, const Submission& submission,
                   const Build& build, const std::vector<JudgedExercise>& exercises);

}  // namespace meshgrade

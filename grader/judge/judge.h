#pragma once

#include <set>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/cases/case.h"
#include "grader/judge/finding.h"
#include "grader/run/outcome.h"

namespace meshgrade {

/// One case with what came of it.
struct JudgeTask {
  const Case& asked;
  const Outcome& outcome;
  const ExerciseRubric& rubric;
  double tolerance;  ///< of positions, relative to the size of the mesh
  /// Also say pointer by pointer what is wrong, which takes time that the verdict does not
  /// need.
  bool explain = true;
  /// Also measure how far each vertex of a subdivided mesh is off, wrong or not.
  bool measure = false;
};

/// Choices that a solution may make but must make in the same way everywhere, for example the
/// weights of Loop subdivision. Holds those that agree with all cases judged so far; a judge
/// takes out what a case rules out.
using Conventions = std::set<std::string>;

/// What the contract leaves open and a caller may rely on all the same: lines of the reference
/// that another right solution has otherwise.
struct OpenChoice {
  const char* was;
  const char* becomes;
  const char* meaning;  ///< "one that marks both halves of the old edge as new"
};

/// What the judge knows of an exercise.
struct ExerciseJudge {
  std::vector<std::string> functions;  ///< that the student writes: "HalfedgeMesh::flipEdge"
  Conventions conventions;             ///< all that are allowed, before the first case

  /// Compares the completed steps of an outcome with what is right and adds findings. The
  /// ending of the outcome is judged elsewhere. @throws WireError if a step is malformed
  void (*judge_steps)(const JudgeTask& task, Conventions& conventions,
                      CaseJudgement& judgement);

  Misconceptions misconceptions = {};  ///< all that its findings can name

  /// Adds to the finding of a fault a picture of what the code had done until then; none if
  /// there is nothing to show. @throws WireError if the interrupted state is malformed
  void (*show_stop)(const JudgeTask& task, Finding& finding) = nullptr;

  /// Whether it tells CaseJudgement::right_share.
  bool counts_pointers = false;

  std::vector<OpenChoice> choices = {};  ///< besides what the reference chooses

  /// Which one of `functions` a case calls, where there are several. @throws WireError if its
  /// input is malformed
  std::string (*called_by)(const Case& asked) = nullptr;
};

/// Makes sure of a claim that all steps are done. Call it when no step is wrong.
/// @throws WireError if the outcome is done with fewer steps than were asked for
void require_all_steps(const Outcome& outcome, std::size_t asked);

/// The judge of an exercise, set up for the options of its rubric.
/// @throws UserError if an option is unknown or has a value that does not exist, or points are
///         given for pointers where there are none
ExerciseJudge find_exercise_judge(const ExerciseRubric& rubric);

/// Judges one case: its steps, then how it ended.
CaseJudgement judge_case(const ExerciseJudge& judge, const JudgeTask& task,
                         Conventions& conventions);

}  // namespace meshgrade

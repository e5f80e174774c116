#include "grader/grade/compile_blame.h"

#include <algorithm>
#include <filesystem>

#include "grader/base/contains.h"
#include "grader/build/tool_words.h"

namespace meshgrade {
namespace {

bool is_exercise_function(const Assignment& assignment, const std::string& function) {
  return std::any_of(assignment.exercises.begin(), assignment.exercises.end(),
                     [&](const ExerciseRubric& rubric) {
                       return contains(find_exercise_judge(rubric).functions, function);
                     });
}

/// A function that was left out of its file because it does not compile answers "not
/// implemented". Says what is true instead. A function of another exercise costs only that one.
void blame_left_out_functions(const Assignment& assignment, const Build& build,
                              const ExerciseJudge& judge, CaseJudgement& judgement) {
  for (const BuiltFile& file : build.files) {
    for (const LeftOut& left : file.left_out) {
      const std::string what = left.not_judged
                                   ? "is not judged, since it uses what the grader lacks ("
                                   : "does not compile (";
      const std::string why =
          what + file.name + ":" + std::to_string(left.line) + ": " + left.message + ")";
      if (judgement.note == left.function + " is not implemented") {
        judgement.note = left.function + " " + why;
      } else if (judgement.note == "it calls " + left.function + ", which is not implemented") {
        judgement.note = "it calls " + left.function + ", which " + why;
      } else {
        continue;
      }
      if (left.not_judged) {
        judgement.verdict = Verdict::kNotJudged;
        judgement.excused = true;
      } else if (contains(judge.functions, left.function) ||
                 !is_exercise_function(assignment, left.function)) {
        judgement.verdict = Verdict::kNotCompiled;
      }
      return;
    }
  }
}

std::string trouble_with(const BuiltFile& file) {
  if (file.compiler_died) return "was not compiled: the compiler itself broke, twice";
  if (file.linked) return "does not compile";
  const std::string why = explain_link_error(file.messages);
  return "does not link" + (why.empty() ? "" : ": " + why);
}

/// "HalfedgeMesh::flipEdge is not implemented" is no surprise if its file does not compile.
void blame_files_that_do_not_compile(const Submission& submission, const Build& build,
                                     const ExerciseJudge& judge, CaseJudgement& judgement) {
  for (const SourceFile& source : submission.sources) {
    const BuiltFile* file = build.find(source.name);
    if (file == nullptr || file->ok) continue;
    for (const std::string& function : judge.functions) {
      if (judgement.note.find(function) == std::string::npos ||
          source.text.find(function) == std::string::npos) {
        continue;
      }
      judgement.verdict = file->compiler_died ? Verdict::kGraderError : Verdict::kNotCompiled;
      judgement.note = source.name + ", which holds " + function + ", " + trouble_with(*file);
      return;
    }
  }
}

/// Where the function is not to be found at all, not even misspelled: the file that is named
/// like its exercise says why, if it does not compile.
void blame_file_of_exercise(const std::string& exercise, const Submission& submission,
                            const Build& build, const ExerciseJudge& judge,
                            CaseJudgement& judgement) {
  for (const SourceFile& source : submission.sources) {
    const BuiltFile* file = build.find(source.name);
    if (file == nullptr || file->ok || file->compiler_died) continue;
    if (std::filesystem::path(source.name).stem() != exercise) continue;
    for (const std::string& function : judge.functions) {
      if (judgement.note != function + " is not implemented") continue;
      judgement.verdict = Verdict::kNotCompiled;
      judgement.note = source.name + " " + trouble_with(*file) + ", and holds no " + function;
      return;
    }
  }
}

}  // namespace

void blame_compilation(const Assignment& assignment, const Submission& submission,
                       const Build& build, const ExerciseJudge& judge, const Case& asked,
                       CaseJudgement& judgement) {
  if (judgement.verdict != Verdict::kNotImplemented &&
      judgement.verdict != Verdict::kNotJudged) {
    return;
  }
  blame_files_that_do_not_compile(submission, build, judge, judgement);
  blame_left_out_functions(assignment, build, judge, judgement);
  blame_file_of_exercise(asked.exercise, submission, build, judge, judgement);
}

}  // namespace meshgrade

#include "grader/report/report.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "grader/base/text.h"
#include "grader/report/endless_loop.h"

namespace meshgrade {
namespace {

constexpr std::size_t kMostPlaces = 8;

std::string trim(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The lines of the submission's files, to quote from.
class SourceLines {
 public:
  explicit SourceLines(const Submission& submission) {
    for (const SourceFile* file : own_files(submission)) {
      lines_[file->name] = split_lines(printable(file->text));
      texts_[file->name] = file->text;
    }
  }

  /// All of a file; empty if the submission has none of this name.
  std::string text(const std::string& file) const {
    const auto found = texts_.find(file);
    return found == texts_.end() ? "" : found->second;
  }

  std::string line(const std::string& file, int number) const {
    const auto found = lines_.find(file);
    if (found == lines_.end() || number < 1) return {};
    const auto index = static_cast<std::size_t>(number) - 1;
    return index < found->second.size() ? trim(found->second[index]) : "";
  }

 private:
  std::map<std::string, std::vector<std::string>> lines_;
  std::map<std::string, std::string> texts_;
};

/// The loop that does not end, in place of the line in which it was stopped: the innermost one
/// that does not count, or else the innermost one. Frames inside of it go.
std::vector<StackFrame> at_the_loop(const std::vector<StackFrame>& stack,
                                    const SourceLines& sources) {
  std::optional<std::size_t> chosen;
  EnclosingLoop told;
  for (std::size_t i = 0; i < stack.size(); ++i) {
    const auto loop = enclosing_loop(sources.text(stack[i].file), stack[i].line);
    if (!loop || (chosen && loop->counts)) continue;
    chosen = i;
    told = *loop;
    if (!loop->counts) break;
  }
  if (!chosen) return stack;
  std::vector<StackFrame> frames(stack.begin() + static_cast<std::ptrdiff_t>(*chosen),
                                 stack.end());
  frames[0].line = told.line;
  return frames;
}

bool is_endless(const Finding& finding) {
  return finding.rule == "out-of-time" || finding.rule == "out-of-steps";
}

std::vector<CodePlace> to_places(const std::vector<StackFrame>& stack,
                                 const SourceLines& sources) {
  std::vector<CodePlace> places;
  for (const StackFrame& frame : stack) {
    if (places.size() == kMostPlaces) break;
    places.push_back(
        {frame.function, frame.file, frame.line, sources.line(frame.file, frame.line)});
  }
  return places;
}

CaseReport to_case_report(const JudgedCase& judged, const SourceLines& sources) {
  CaseReport report;
  report.id = judged.asked.id();
  report.group = judged.asked.group;
  report.title = judged.asked.title;
  report.shrunk_from = judged.shrunk_from;
  report.verdict = judged.judgement.verdict;
  report.note = judged.judgement.note;
  report.excused = judged.judgement.excused;
  report.passes_alone = judged.judgement.passes_alone;
  report.hidden = judged.asked.hidden;
  report.scene = judged.judgement.scene;
  report.output = judged.output;
  report.output_bytes = judged.output_bytes;
  for (const Finding& finding : judged.judgement.findings) {
    report.findings.push_back(
        {finding,
         to_places(is_endless(finding) ? at_the_loop(finding.stack, sources) : finding.stack,
                   sources)});
  }
  return report;
}

double round_points(double points) {
  return std::round(points * 100.0) / 100.0;
}

/// What a group with failures earns by its pointers, at most: not even one that is wrong is
/// free.
constexpr double kMostByPointers = 0.8;

/// The part of its points that a group earns, some of whose cases failed.
double earned_share(Partial partial, const GroupReport& group,
                    const std::vector<const CaseJudgement*>& failed) {
  if (partial == Partial::kCases)
    return static_cast<double>(group.passed) / static_cast<double>(group.judged);
  if (partial == Partial::kNone) return 0.0;
  double sum = 0.0;
  for (const CaseJudgement* judgement : failed)
    sum += judgement->right_share;
  return kMostByPointers * sum / static_cast<double>(failed.size());
}

GroupReport add_up(const Group& group, const std::vector<JudgedCase>& cases,
                   const std::vector<GroupReport>& before) {
  GroupReport report{group.name, group.title, group.extra_credit, 0.0, group.points, 0, 0,
                     0,          ""};
  std::vector<const CaseJudgement*> failed;
  for (const JudgedCase& c : cases) {
    if (c.asked.group != group.name) continue;
    ++report.cases;
    if (c.judgement.excused) continue;
    ++report.judged;
    if (c.judgement.verdict == Verdict::kPassed)
      ++report.passed;
    else
      failed.push_back(&c.judgement);
  }
  const bool needed_group_failed =
      std::any_of(before.begin(), before.end(), [&](const GroupReport& other) {
        return other.name == group.needs && other.points == 0.0 && other.max_points > 0.0;
      });
  if (report.judged == 0) return report;
  if (needed_group_failed) {
    report.why = "counts only if " + group.needs + " earns points";
    return report;
  }
  const double share = failed.empty() ? 1.0 : earned_share(group.partial, report, failed);
  report.points = round_points(group.points * share);
  if (report.points == 0.0 && report.passed > 0 && group.points > 0.0) {
    report.why = group.partial == Partial::kPointers
                     ? "nothing that must change is right in the cases that fail"
                     : "counts only if all of its cases pass";
  }
  return report;
}

bool has_judged_case(const ExerciseReport& exercise) {
  return std::any_of(exercise.cases.begin(), exercise.cases.end(),
                     [](const CaseReport& c) { return !c.excused; });
}

/// The verdict of the first case that was not passed, in the order of the groups that are
/// required. A missing verdict for some cases does not spoil that of the others.
Verdict overall_verdict(const ExerciseReport& exercise) {
  if (!exercise.cases.empty() && !has_judged_case(exercise)) return Verdict::kNotJudged;
  Verdict verdict = Verdict::kPassed;
  for (const GroupReport& group : exercise.groups) {
    if (group.extra_credit) continue;
    for (const CaseReport& c : exercise.cases) {
      if (c.group != group.name || c.verdict == Verdict::kPassed || c.excused) continue;
      if (c.verdict == Verdict::kGraderError) return c.verdict;
      if (verdict == Verdict::kPassed || verdict == Verdict::kNotJudged) verdict = c.verdict;
    }
  }
  return verdict;
}

ExerciseReport to_exercise_report(const JudgedExercise& judged, const SourceLines& sources) {
  ExerciseReport report;
  report.name = judged.rubric->name;
  report.title = judged.rubric->title;
  report.notes = judged.notes;
  report.stand_ins = judged.stand_ins;
  for (const JudgedCase& c : judged.cases)
    report.cases.push_back(to_case_report(c, sources));
  for (const Group& group : judged.rubric->groups) {
    report.groups.push_back(add_up(group, judged.cases, report.groups));
    const GroupReport& added = report.groups.back();
    (added.extra_credit ? report.extra_points : report.points) += added.points;
    (added.extra_credit ? report.max_extra_points : report.max_points) += added.max_points;
  }
  report.verdict = overall_verdict(report);
  return report;
}

/// The title tells the input, and what the code printed may tell it as well.
void hide_details(CaseReport& c, HiddenShow show) {
  c.title = "a hidden case";
  c.shrunk_from.clear();
  c.figure.clear();
  c.scene = {};
  c.note = c.verdict == Verdict::kPassed ? "" : "its details are not shown";
  c.output.clear();
  c.output_bytes = 0;
  std::vector<FindingReport> findings;
  if (show == HiddenShow::kRule && !c.findings.empty()) {
    FindingReport& only = findings.emplace_back();
    only.finding.rule = c.findings[0].finding.rule;
    only.finding.meaning = c.findings[0].finding.meaning;
  }
  c.findings = std::move(findings);
}

/// What students may see of hidden cases, and what of these is not here.
void add_hidden(const Assignment& assignment, Report& report) {
  if (assignment.hidden) {
    report.hidden_show = assignment.hidden->show;
    if (!assignment.hidden->seed) {
      report.notes.emplace_back("hidden cases are not part of this: their seed is not here");
    }
  }
  const std::vector<OwnMesh> own = assignment.own_meshes();
  if (!assignment.hidden &&
      std::any_of(own.begin(), own.end(), [](const OwnMesh& mesh) { return mesh.hidden; })) {
    report.hidden_show = HiddenShow::kName;
  }
  const auto missing = static_cast<std::size_t>(std::count_if(
      own.begin(), own.end(), [](const OwnMesh& mesh) { return !mesh.is_there; }));
  if (missing > 0) {
    report.notes.push_back(std::string("hidden cases are not part of this: ") +
                           (missing == 1 ? "a mesh of theirs is" : "meshes of theirs are") +
                           " not here");
  }
}

}  // namespace

bool Report::has_grader_error() const {
  return std::any_of(exercises.begin(), exercises.end(), [](const ExerciseReport& exercise) {
    return std::any_of(exercise.cases.begin(), exercise.cases.end(),
                       [](const CaseReport& c) { return c.verdict == Verdict::kGraderError; });
  });
}

double Report::points_not_judged() const {
  double sum = 0.0;
  for (const ExerciseReport& exercise : exercises) {
    if (exercise.verdict == Verdict::kNotJudged) sum += exercise.max_points;
  }
  return sum;
}

Report student_view(Report report) {
  if (report.hidden_show == HiddenShow::kAll) return report;
  for (ExerciseReport& exercise : report.exercises) {
    for (CaseReport& c : exercise.cases) {
      if (c.hidden) hide_details(c, report.hidden_show);
    }
  }
  return report;
}

Report make_report(const Assignment& assignment, const Submission& submission,
                   const Build& build, const std::vector<JudgedExercise>& exercises) {
  Report report;
  report.assignment = assignment.title;
  report.submission = printable(submission.name);
  report.seed = assignment.seed;
  report.notes = submission.notes;
  add_hidden(assignment, report);
  report.sandbox = build.sandbox;
  for (const BuiltFile& file : build.files) {
    const bool whole = file.ok && file.left_out.empty();
    // Warnings stand with the failures of their functions.
    report.files.push_back({file.name, whole, whole ? "" : file.messages, file.linked});
    report.notes.insert(report.notes.end(), file.notes.begin(), file.notes.end());
    for (const LeftOut& left : file.left_out) {
      if (left.not_judged) continue;  // told among the file's own notes
      report.notes.push_back(file.name + ":" + std::to_string(left.line) + ": " +
                             left.function + " does not compile and is left out: " +
                             left.message + "; the rest of the file is graded");
    }
  }
  const SourceLines sources(submission);
  for (const JudgedExercise& judged : exercises) {
    report.exercises.push_back(to_exercise_report(judged, sources));
    const ExerciseReport& added = report.exercises.back();
    report.points += added.points;
    report.max_points += added.max_points;
    report.extra_points += added.extra_points;
    report.max_extra_points += added.max_extra_points;
  }
  return report;
}

}  // namespace meshgrade

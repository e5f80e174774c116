#include "grader/mutants/mistake_table.h"

#include <algorithm>

#include "grader/base/job_pool.h"
#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHeading = "## What is said of known mistakes";

std::vector<fs::path> folders_in(const fs::path& parent) {
  std::vector<fs::path> folders;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent)) {
    if (entry.is_directory()) folders.push_back(entry.path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

/// "// Wrong: the area counts twice." without its beginning; the folder's name if no file
/// begins so.
std::string mistake_of(const Submission& submission) {
  const std::string mark = "// Wrong: ";
  for (const SourceFile& source : submission.sources) {
    if (source.text.rfind(mark, 0) != 0) continue;
    return source.text.substr(mark.size(), source.text.find('\n') - mark.size());
  }
  std::string name = submission.folder.filename().string();
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// The submission's files, and the reference's for what it lacks.
Submission completed(Submission own, const Submission& reference) {
  for (const SourceFile& source : reference.sources) {
    const bool known =
        std::any_of(own.sources.begin(), own.sources.end(),
                    [&](const SourceFile& other) { return other.name == source.name; });
    if (!known) own.sources.push_back(source);
  }
  return own;
}

KnownMistake first_words(const ExerciseReport& exercise, const std::string& mistake) {
  KnownMistake known{exercise.name, mistake, verdict_name(exercise.verdict), ""};
  const CaseReport* first = first_failure(exercise);
  if (first == nullptr) return known;
  known.told = first->note;
  if (first->findings.empty()) return known;
  const Finding& finding = first->findings[0].finding;
  known.rule = finding.rule;
  known.told = finding.likely.empty() ? finding.look_at : finding.likely[0].advice;
  if (known.told.empty()) known.told = finding.actual;
  return known;
}

struct WireMistake {
  KnownMistake known;

  template <class Wire>
  void transfer(Wire& wire) {
    wire(known.exercise, known.mistake, known.rule, known.told);
  }
};

/// In a table, a bar would end the escaped_cell.
std::string escaped_cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.replace(at, 1, "\\|");
  return text;
}

}  // namespace

std::vector<KnownMistake> grade_known_mistakes(const Assignment& assignment,
                                               const fs::path& wrong,
                                               const Submission& reference,
                                               const GradeFunction& grade, unsigned jobs,
                                               const JobProgress& progress) {
  std::vector<fs::path> folders;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    const std::vector<fs::path> own = folders_in(wrong / rubric.name);
    folders.insert(folders.end(), own.begin(), own.end());
  }
  const auto work = [&](std::size_t i) {
    const Submission own = find_submission(folders[i], assignment.submission);
    const Report report =
        grade(completed(own, reference), {folders[i].parent_path().filename().string()});
    return to_wire(WireMistake{first_words(report.exercises.at(0), mistake_of(own))});
  };
  const auto results = run_jobs(folders.size(), jobs, work, [&](std::size_t done) {
    progress("known mistakes", done, folders.size());
  });
  std::vector<KnownMistake> mistakes;
  for (const std::string& result : results)
    mistakes.push_back(from_wire<WireMistake>(result).known);
  return mistakes;
}

std::string to_markdown(const std::vector<KnownMistake>& mistakes) {
  std::string text =
      std::string(kHeading) +
      "\n\n"
      "Mistakes that students make, each in a submission of its own in\n"
      "`tests/submissions/wrong`, and what the first finding says: its rule, and "
      "what the\n"
      "mistake probably comes from, or else what to look at. `meshgrade dev-check "
      "--mistakes`\n"
      "writes only this section.\n\n"
      "| exercise | the mistake | rule | the first finding says |\n"
      "|---|---|---|---|\n";
  for (const KnownMistake& known : mistakes) {
    text += "| " + known.exercise + " | " + escaped_cell(known.mistake) + " | `" +
            escaped_cell(known.rule) + "` | " + escaped_cell(known.told) + " |\n";
  }
  return text;
}

std::string with_mistakes(const std::string& page, const std::vector<KnownMistake>& mistakes) {
  std::string before = page.substr(0, page.find(kHeading));
  while (!before.empty() && before.back() == '\n')
    before.pop_back();
  return before + "\n\n" + to_markdown(mistakes);
}

}  // namespace meshgrade

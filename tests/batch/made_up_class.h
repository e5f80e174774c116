#pragma once

// A class and a grader that are made up: a submission says in its text what comes of it, so
// that a batch can be proved without a compiler.

#include <unistd.h>

#include <csignal>
#include <fstream>
#include <map>
#include <string>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/batch/batch.h"
#include "grader/batch/class_results.h"
#include "tests/support/scratch_files.h"

namespace meshgrade {

/// Gives the points that the source file's text says; "die", "throw" and "error" do that; "die
/// once" and the like at the first try only, and then give 1 point.
/// Each grading leaves a line in the file `log`.
inline Grading made_up_grading(const std::filesystem::path& log) {
  Grading grading;
  grading.identity = "grader 1";
  grading.to_text = [](const Report& report) { return report.submission + "\n"; };
  grading.grade = [log](const Submission& submission, unsigned) {
    std::ofstream(log, std::ios::app) << submission.name + "\n";
    std::string text = submission.sources.at(0).text;
    const std::size_t once = text.find(" once");
    if (once != std::string::npos) {
      const std::string mark = log.string() + "." + submission.name;
      text = std::filesystem::exists(mark) ? "1" : text.substr(0, once);
      std::ofstream(mark) << "tried\n";
    }
    if (text == "die") ::raise(SIGKILL);
    if (text == "throw") throw std::runtime_error("out of ideas");
    Report report;
    report.submission = submission.name;
    report.max_points = 10.0;
    if (text == "slow") ::usleep(20'000);
    ExerciseReport& exercise = report.exercises.emplace_back();
    exercise.name = "edge_flip";
    exercise.max_points = 10.0;
    if (text == "error") {
      exercise.cases.emplace_back().verdict = Verdict::kGraderError;
      return report;
    }
    report.points = exercise.points = text == "slow" ? 3.0 : std::stod(text);
    return report;
  };
  return grading;
}

/// What the made-up class is graded by.
inline Assignment one_exercise() {
  Assignment assignment;
  assignment.title = "Meshes";
  ExerciseRubric rubric;
  rubric.name = "edge_flip";
  rubric.groups.push_back({"basic", "", 10.0, false, Partial::kNone, "", ""});
  assignment.exercises = {rubric};
  return assignment;
}

/// A folder of submissions, a place for results, and a way to grade them.
class MadeUpClass {
 public:
  using Texts = std::map<std::string, std::string>;

  explicit MadeUpClass(const Texts& texts) {
    std::filesystem::create_directories(submissions());
    for (const auto& [who, text] : texts)
      hand_in(who, text);
  }

  void hand_in(const std::string& who, const std::string& text) const {
    write_file(submissions() / who / "flip.cpp", text);
  }

  std::filesystem::path submissions() const { return scratch.path() / "submissions"; }
  std::filesystem::path results() const { return scratch.path() / "results"; }
  std::filesystem::path log() const { return scratch.path() / "log"; }

  /// Grades them; the log says afterwards who was graded in this run.
  bool run(BatchOptions options = {}, const std::vector<std::string>& only = {}) {
    const Roster roster = read_roster(submissions(), {});
    std::filesystem::remove(log());
    steps.clear();
    options.chosen = choose_hand_ins(roster, only);
    options.progress = [&](const BatchStep& step) {
      steps[roster.hand_ins[step.hand_in].key] = step;
    };
    return run_batch(roster, grading, BatchFolder(results()), options);
  }

  /// Who was graded in the last run, sorted.
  std::vector<std::string> graded() const {
    std::vector<std::string> names;
    std::ifstream stream(log());
    for (std::string name; std::getline(stream, name);)
      names.push_back(name);
    std::sort(names.begin(), names.end());
    return names;
  }

  ResultStore store() const { return result_store(results()); }
  Result result_of(const std::string& who) const { return store().load(who); }

  ScratchFolder scratch;
  Grading grading = made_up_grading(log());
  std::map<std::string, BatchStep> steps;  ///< of the last run
};

}  // namespace meshgrade

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/build/build.h"
#include "grader/build/home.h"
#include "grader/judge/finding.h"
#include "grader/report/report.h"
#include "grader/submission/submission.h"

namespace meshgrade {

/// A submission that is compiled again and again while its student works on it.
class StudentProgram {
 public:
  /// @throws UserError if there is nothing to compile
  StudentProgram(const Assignment& assignment, Home home, std::filesystem::path submission);

  /// Compiles the files as they are now. If one does not compile, the program before goes on.
  /// @return whether there is a new program
  bool rebuild();

  /// Runs tasks, each for a few seconds at most. @return an outcome for each
  /// @throws UserError if there is no program yet
  std::vector<Outcome> run(const std::vector<Case>& asked) const;

  /// A judgement as a report tells it, with the student's lines of code.
  CaseReport tell(const std::string& exercise, const std::string& title,
                  CaseJudgement judgement, const Outcome& outcome) const;

  const Assignment& assignment() const { return assignment_; }
  const std::string& name() const { return name_; }
  const std::vector<BuiltFile>& files() const { return files_; }
  bool compiled() const { return compiled_; }
  std::size_t builds() const { return builds_; }

 private:
  const Assignment& assignment_;
  Home home_;
  std::filesystem::path submission_;
  std::string name_;
  std::optional<Submission> sources_;
  std::optional<Build> build_;
  std::vector<BuiltFile> files_;
  bool compiled_ = false;
  std::size_t builds_ = 0;
};

}  // namespace meshgrade

#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "grader/base/process.h"
#include "grader/batch/result_store.h"
#include "grader/roster/roster.h"

namespace meshgrade {

/// How a submission is graded, and what else the result depends on.
struct Grading {
  /// `slot` counts from 0 and tells submissions apart that are graded at the same time.
  std::function<Report(const Submission& submission, unsigned slot)> grade;
  std::function<std::string(const Report& report)> to_text;  ///< for people to read
  /// Adds files for people, such as pictures, to the folder of a result, and may note their
  /// names in the report. Called before the report is stored; may be empty.
  std::function<void(Report& report, const std::filesystem::path& folder)> add_files = {};
  SubmissionRules rules;
  std::string identity;  ///< of grader and assignment: another one, another result
};

/// What came of one hand-in.
struct BatchStep {
  std::size_t hand_in = 0;  ///< index in the roster
  ResultStatus status = ResultStatus::kMissing;
  bool kept = false;   ///< from an earlier run: nothing has changed
  bool again = false;  ///< the grader failed at first, and was asked once more
  double points = 0.0;
  double max_points = 0.0;
  std::string reason;  ///< why it is not graded, or graded again, or asked for once more
};

struct BatchOptions {
  unsigned jobs = 1;
  bool force = false;               ///< also what has not changed
  std::vector<std::size_t> chosen;  ///< which hand-ins of the roster
  std::function<void(const BatchStep&)> progress;
  std::function<bool()> stop;  ///< whether to end early
};

/// The hand-ins of these keys, or of people with these ids; all of them for no names.
/// @throws UserError if nobody is called like this
std::vector<std::size_t> choose_hand_ins(const Roster& roster,
                                         const std::vector<std::string>& names);

/// The folder for all that a batch writes. As long as this value lives, no other batch writes
/// to it, and everything temporary goes to a place within it, so that what a killed batch
/// leaves behind is known to the next one, which clears it away. (Not so if root grades into a
/// folder that is closed to others: then it goes where temporary files are anyway.)
class BatchFolder {
 public:
  /// @throws UserError if it cannot be made, or another batch has it
  explicit BatchFolder(const std::filesystem::path& folder);
  BatchFolder(const BatchFolder&) = delete;
  BatchFolder& operator=(const BatchFolder&) = delete;
  ~BatchFolder();

  const std::filesystem::path& path() const { return folder_; }
  ResultStore store() const { return result_store(folder_); }

 private:
  void clear() const;

  std::filesystem::path folder_;
  FileDescriptor lock_;
  std::string temporary_before_;
};

/// The hand-ins that are to be graded, key and fingerprint: not those whose result still holds,
/// nor those that cannot be graded.
std::map<std::string, std::string> pending_hand_ins(const Roster& roster,
                                                    const Grading& grading,
                                                    const ResultStore& store,
                                                    const BatchOptions& options);

/// Grades the hand-ins of a class and stores each result as soon as it is there. What has not
/// changed since an earlier run is kept. A hand-in for which the grader fails, or dies, is
/// graded once more; then it becomes a "grader error", which the next run tries again. It takes
/// no other with it.
/// @return false if it was stopped before the end
/// @throws UserError if the results cannot be written, or if the disk is about to be full
bool run_batch(const Roster& roster, const Grading& grading, const BatchFolder& folder,
               const BatchOptions& options);

}  // namespace meshgrade

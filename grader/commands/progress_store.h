#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "grader/report/report.h"

namespace meshgrade {

/// How far a student has come with one exercise.
struct ExerciseProgress {
  std::string verdict;  ///< of the last check; empty if there was none
  double points = 0.0;
  double max_points = 0.0;
  double extra_points = 0.0;
  double max_extra_points = 0.0;
  std::int64_t checked_at = 0;  ///< seconds since 1970
  std::uint32_t hints = 0;      ///< how many were shown
};

struct SubmissionProgress {
  std::filesystem::path submission;  ///< absolute
  std::map<std::string, ExerciseProgress> exercises;
};

/// What is remembered between two calls of the program: one small JSON file for each
/// submission, and the name of the submission that was checked last. It is a convenience: what
/// is missing or unreadable counts as nothing remembered.
class ProgressStore {
 public:
  /// An empty folder name: nothing is ever remembered.
  explicit ProgressStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  SubmissionProgress load(const std::filesystem::path& submission) const;

  /// @throws UserError if it cannot be written
  void save(const SubmissionProgress& progress) const;

  /// Keeps what a check has found, that this submission was the last one, and in `home` the
  /// folder of Meshgrade: by it the students' CMakeLists.txt finds it from anywhere.
  /// @throws UserError if it cannot be written
  void remember(const std::filesystem::path& submission, const Report& report) const;

  std::optional<std::filesystem::path> last_submission() const;

 private:
  std::filesystem::path file_of(const std::filesystem::path& submission) const;

  std::filesystem::path folder_;
};

/// The store of the person who runs this: $XDG_STATE_HOME/meshgrade, or
/// ~/.local/state/meshgrade.
ProgressStore personal_store();

/// Remembers a report in the personal store. That it cannot be written is told on stderr, and
/// is no reason to fail.
void remember_or_warn(const std::filesystem::path& submission, const Report& report);

/// The submission that was given, or the one that was checked last.
/// @throws UserError if there is neither
std::filesystem::path given_or_last(const std::string& given, const ProgressStore& store);

}  // namespace meshgrade

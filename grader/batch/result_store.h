#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "grader/report/report.h"

namespace meshgrade {

enum class ResultStatus {
  kGraded,
  kUngradable,   ///< nothing was handed in that can be graded: no points
  kGraderError,  ///< a fault of the grader: no statement is made
  kMissing,      ///< not graded yet
};

/// "graded", "ungradable", "grader error", "not graded yet"
const char* status_name(ResultStatus status);

/// What is known about one hand-in.
struct Result {
  std::string key;
  std::string fingerprint;  ///< of all that the result depends on
  ResultStatus status = ResultStatus::kMissing;
  std::string reason;            ///< why it is not graded
  std::optional<Report> report;  ///< if it is graded
};

/// Results on the disk, each in a folder of its own: `report.json` (docs/report.md),
/// `report.txt`, and `result.json` with the status and the SHA-256 of the other two. Each file
/// is written whole or not at all, `result.json` last: whatever interrupts, a result is there
/// and right, or it is missing.
class ResultStore {
 public:
  explicit ResultStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// `text` is the report for people to read.
  /// @throws UserError if it cannot be written
  void save(const Result& result, const std::string& text) const;

  /// Makes the folder of a result. @throws UserError if that is not possible
  std::filesystem::path make_folder(const std::string& key) const;

  /// kMissing if there is none, or if it is damaged: then with the reason.
  Result load(const std::string& key) const;

  std::filesystem::path folder_of(const std::string& key) const;

  /// Copies a result of another store, `result.json` last.
  /// @throws UserError if it cannot be written
  void take_over(const ResultStore& other, const std::string& key) const;

  const std::filesystem::path& folder() const { return folder_; }

  /// The key of the result in this folder of a result; empty if there is none.
  static std::string key_in(const std::filesystem::path& result_folder);

 private:
  std::filesystem::path folder_;
};

/// The results in the folder of a batch.
ResultStore result_store(const std::filesystem::path& batch_folder);

}  // namespace meshgrade

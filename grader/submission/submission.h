#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"

namespace meshgrade {

/// A text file of a submission.
struct SourceFile {
  std::string name;  ///< without folder
  std::string text;
};

/// What was handed in, as far as it is looked at: the sources to compile and the headers that
/// may come along. A copy in memory, so that later changes on disk do not matter.
struct Submission {
  std::string name;
  std::filesystem::path folder;
  std::vector<SourceFile> sources;
  std::vector<SourceFile> headers;
  std::vector<std::string> notes;  ///< what was left out, and why
};

/// Collects the C++ files of a folder, or a single file. Folders below are not searched, but
/// when the folder holds nothing than one other folder, that one is taken. Links, devices and
/// files that are too large are left out with a note.
/// @throws UserError if there is nothing to grade
Submission find_submission(const std::filesystem::path& path, const SubmissionRules& rules);

}  // namespace meshgrade

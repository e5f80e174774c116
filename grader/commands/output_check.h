#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/submission/submission.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace meshgrade {

/// A file that a command is to write.
struct Output {
  std::string option;  ///< where it was named, for messages: "--json"
  std::filesystem::path file;
};

/// Adds an option that names a file to write; an empty name is refused.
CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& file,
                               const std::string& help);

/// Refuses, before any work is done, what could not be written after it, and what would be lost
/// by it. Standard output ("-"), pipes and devices may always be written to. Links are
/// followed.
/// @param inputs  files that the command reads; those that are empty or not there are passed
///                over, and so are folders
/// @throws UserError if an output is an input, another output or a folder, or its folder is not
///         there
void check_outputs(const std::vector<Output>& outputs,
                   const std::vector<std::filesystem::path>& inputs);

/// The files of a submission that are graded; those from an archive have no file of their own.
std::vector<std::filesystem::path> files_of(const Submission& submission);

/// Whether a path, there or not, lies in a folder or is the folder itself. Links are followed.
bool lies_within(const std::filesystem::path& path, const std::filesystem::path& folder);

}  // namespace meshgrade

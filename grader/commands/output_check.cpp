#include "grader/commands/output_check.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Files that are not there yet are told apart by their names.
bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code error;
  if (fs::equivalent(one, other, error)) return true;
  const fs::path whole = fs::weakly_canonical(one, error);
  return !error && whole == fs::weakly_canonical(other, error) && !error;
}

void check_place(const Output& output) {
  std::error_code error;
  const std::string name = output.file.string();
  if (fs::is_directory(output.file, error)) {
    throw UserError(name + ": is a folder; name a file behind " + output.option);
  }
  const fs::path folder = output.file.parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error)) {
    throw UserError(name + ": there is no folder " + folder.string() + "; make it first");
  }
}

}  // namespace

CLI::Option* add_output_option(CLI::App& command, const std::string& name, std::string& file,
                               const std::string& help) {
  return command.add_option(name, file, help)->check([](const std::string& text) {
    return text.empty() ? "the name of the file is empty" : "";
  });
}

void check_outputs(const std::vector<Output>& outputs, const std::vector<fs::path>& inputs) {
  std::error_code error;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    if (output.file == "-" || is_stream(output.file)) continue;
    check_place(output);
    for (const fs::path& input : inputs) {
      if (fs::is_regular_file(input, error) && is_same_file(input, output.file)) {
        throw UserError(output.file.string() +
                        ": is an input, and would be overwritten; give another name behind " +
                        output.option);
      }
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_same_file(outputs[j].file, output.file)) continue;
      throw UserError(output.file.string() + ": two outputs go to this file, behind " +
                      outputs[j].option + " and " + output.option +
                      "; give each a file of its own");
    }
  }
}

std::vector<fs::path> files_of(const Submission& submission) {
  std::vector<fs::path> files;
  for (const auto* list : {&submission.sources, &submission.headers, &submission.course_sources,
                           &submission.course_headers}) {
    for (const SourceFile& file : *list)
      files.push_back(submission.folder / file.name);
  }
  return files;
}

bool lies_within(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path way =
      fs::weakly_canonical(path, error).lexically_relative(fs::weakly_canonical(folder, error));
  return !error && !way.empty() && *way.begin() != "..";
}

}  // namespace meshgrade

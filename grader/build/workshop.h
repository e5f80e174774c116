#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/base/process.h"
#include "grader/build/home.h"

namespace meshgrade {

/// A folder in which the compiler and the linker work on what was handed in, confined.
class Workshop {
 public:
  /// In a scratch folder of its own.
  Workshop(const Home& home, const Limits& limits);
  /// In a folder that is there already.
  Workshop(const Home& home, const Limits& limits, std::filesystem::path folder);

  const std::filesystem::path& folder() const { return folder_; }

  /// Writes a file. The name holds no folder.
  void put(const std::string& name, const std::string& text) const;

  /// Runs a tool here. What it says comes back without the machine's paths, safe to print.
  /// @param made  the file that it is to make: one that is there already is removed, since
  ///              another user may own it
  ProcessResult run(std::vector<std::string> arguments, const std::string& made) const;

  /// Moves a file that a tool has made to another folder.
  /// @throws GraderError if it is no ordinary file
  void hand_over(const std::string& name, const std::filesystem::path& to) const;

 private:
  std::string clean(std::string messages) const;

  const Home* home_;
  const Limits* limits_;
  std::optional<ScratchFolder> scratch_;
  std::filesystem::path folder_;
};

/// What a tool complains about, or which limit it reached; empty if it worked without a word.
std::string complaints(const ProcessResult& result, const Limits& limits);

}  // namespace meshgrade

#pragma once

// What an attack could reach and leave behind.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "grader/base/process.h"

namespace meshgrade {

/// A place for one attack: the instructor's files, and all scratch files of the grader, which
/// go here while this lives.
class CrimeScene {
 public:
  CrimeScene();
  CrimeScene(const CrimeScene&) = delete;
  CrimeScene& operator=(const CrimeScene&) = delete;
  ~CrimeScene();

  /// The header paths.h, which tells the attack where everything is.
  std::string paths_header() const;

  const std::string& secret() const { return secret_; }

  /// What is not as it was, in words; empty if all is. Ends processes that it finds.
  std::vector<std::string> traces() const;

 private:
  std::vector<pid_t> left_processes() const;
  void add_left_files(std::vector<std::string>& found) const;

  ScratchFolder folder_;
  std::filesystem::path scratch_;
  std::string secret_;
  std::string before_;  ///< the folder for temporary files
  FileDescriptor listener_;
  int port_ = 0;
};

/// The whole file; nothing if it cannot be read.
std::string bytes_of(const std::filesystem::path& file);

}  // namespace meshgrade

#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/package/package_files.h"

namespace meshgrade {

/// A platform that runs autograders.
struct Host {
  const char* name;   ///< "gradescope"
  const char* title;  ///< for --help
  const char* file;   ///< what the bundle is usually called
  /// Puts the contents of the bundle into an empty folder.
  void (*fill)(const PackageSource& source, const std::filesystem::path& folder);
};

const std::vector<Host>& hosts();

/// Writes what an instructor uploads there: the set-up, the runner, the grader and the
/// assignment. The kind of archive is that of the file's name: zip, or tar.
/// @throws UserError if there is no such host, or the file cannot be written
void write_bundle(const std::string& host, const PackageSource& source,
                  const std::filesystem::path& file);

}  // namespace meshgrade

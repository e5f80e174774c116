#pragma once

#include <filesystem>

namespace meshgrade {

/// Where a program comes from that goes into a package. Both empty: the package has none, and
/// builds its own from the sources in it.
struct ProgramFiles {
  std::filesystem::path installed;  ///< the folder that holds its bin/, lib/ and share/
  std::filesystem::path build;      ///< or the folder that it was built in

  bool empty() const { return installed.empty() && build.empty(); }
};

/// Copies the program, the libraries that come with it, and its kit: what the script
/// `meshgrade` looks for in `program/` beside itself.
/// @param target  a folder that is new or empty
/// @throws UserError if it cannot be copied
void copy_program(const ProgramFiles& program, const std::filesystem::path& target);

}  // namespace meshgrade

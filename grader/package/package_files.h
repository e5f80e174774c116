#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/package/program_files.h"

namespace meshgrade {

/// A file or a folder of the project, and where it goes in a package.
struct PackagePart {
  std::string from;
  std::string to;
};

/// What a package is made of.
struct PackageSource {
  std::filesystem::path project;     ///< the folder that holds include/, meshes/ and the others
  std::filesystem::path assignment;  ///< the file that the package's grader reads
  ProgramFiles program = {};         ///< comes along, so that nothing has to be built
};

/// What any package needs that grades: the script, the sources of the grader, the shared
/// headers, the visible meshes, the licence. An installed program has no sources to give.
std::vector<PackagePart> grader_parts(const std::filesystem::path& project);

/// Makes a folder for a package.
/// @throws UserError if it is there already and not empty, or cannot be made
void make_package_folder(const std::filesystem::path& target);

/// The assignment and the meshes of its own, as parts of a package whose grader reads the
/// assignment from its `to`.
/// @param hidden  also the meshes that are not handed out
std::vector<PackagePart> assignment_parts(const Assignment& assignment,
                                          const std::filesystem::path& file,
                                          const std::string& to, bool hidden);

/// Copies parts of the project. Links are left out, and so is what a build leaves behind.
/// @param secrets  files that are left out, in whichever part they lie
/// @throws UserError if one cannot be copied
void copy_parts(const std::filesystem::path& project, const std::vector<PackagePart>& parts,
                const std::filesystem::path& target,
                const std::vector<std::filesystem::path>& secrets = {});

}  // namespace meshgrade

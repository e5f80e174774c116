#pragma once

#include <filesystem>

#include "grader/package/package_files.h"

namespace meshgrade {

/// Writes the students' package: the skeleton, the shared headers, the grader, the visible
/// meshes and the students' pages, without the reference, the tests, or what only instructors
/// need. The seed of the assignment's hidden cases stays behind, wherever it lies.
/// @throws UserError if the assignment is wrong, or if the folder `target` is not empty or
/// cannot be written
void write_handout(const PackageSource& source, const std::filesystem::path& target);

}  // namespace meshgrade

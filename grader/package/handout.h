#pragma once

#include <filesystem>

namespace meshgrade {

/// Writes the students' package: the skeleton, the shared headers, the grader, the visible
/// meshes and the students' pages, without the reference, the tests, or what only instructors
/// need. `assignment` is the file that its grader reads; the seed of its hidden cases stays
/// behind, wherever it lies.
/// @throws UserError if the assignment is wrong, or if the folder `target` is not empty or
/// cannot be written
void write_handout(const std::filesystem::path& project,
                   const std::filesystem::path& assignment,
                   const std::filesystem::path& target);

}  // namespace meshgrade

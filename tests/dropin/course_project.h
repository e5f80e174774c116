#pragma once

#include <filesystem>

namespace meshgrade {

/// Puts a homework into a folder as the course hands it out: the files of the homework in src/,
/// among stand-ins for all of the course's own that the homework does not replace, and beside
/// src/ the course's library and what building leaves behind.
void put_into_course_project(const std::filesystem::path& homework,
                             const std::filesystem::path& project);

}  // namespace meshgrade

#include "grader/app/context.h"

#include "grader/base/errors.h"

namespace meshgrade {

std::filesystem::path source_folder() {
  return MESHGRADE_SOURCE_DIR;
}

Home find_home() {
  const std::filesystem::path source = source_folder();
  std::error_code ignored;
  const std::filesystem::path reference = source / "reference";
  return {source / "include",
          MESHGRADE_KIT_DIR,
          source / "meshes",
          source / "docs",
          std::filesystem::is_directory(reference, ignored) ? reference : "",
          MESHGRADE_COMPILER};
}

std::filesystem::path standard_assignment() {
  return source_folder() / "grader" / "assignment.toml";
}

std::filesystem::path or_standard_assignment(const std::string& file) {
  return file.empty() ? standard_assignment() : std::filesystem::path(file);
}

void require_hidden_seed(const Assignment& assignment) {
  if (!assignment.hidden || assignment.hidden->seed) return;
  throw UserError(assignment.hidden->seed_file.string() +
                  ": cannot be read; it holds the seed of the assignment's hidden cases");
}

}  // namespace meshgrade

#include "grader/app/context.h"

#include <fstream>
#include <system_error>

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

void write_file_safely(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::path temporary = file;
  temporary += ".partial";
  std::ofstream stream(temporary, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(temporary, file, error);
  if (!stream || error) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw UserError(file.string() +
                    ": cannot be written; is the folder there, with room left?");
  }
}

}  // namespace meshgrade

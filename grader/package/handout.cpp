#include "grader/package/handout.h"

#include <optional>

#include "grader/assignment/assignment.h"
#include "grader/package/package_files.h"

namespace meshgrade {
namespace {

std::vector<PackagePart> handout_parts() {
  std::vector<PackagePart> parts = grader_parts();
  parts.push_back({"student_skeleton", "student_skeleton"});
  // It lies at the top here, too, so that its links hold in both places.
  parts.push_back({"HANDOUT.md", "README.md"});
  for (const char* page : {"student.md", "installing.md", "rules.md", "report.md",
                           "report.schema.json", "formats.md", "dropin.md", "assignment.md",
                           "exercises", "viewer.md", "lopsided_cube.md", "pictures"}) {
    const std::string path = std::string("docs/") + page;
    parts.push_back({path, path});
  }
  return parts;
}

}  // namespace

void write_handout(const std::filesystem::path& project,
                   const std::filesystem::path& assignment,
                   const std::filesystem::path& target) {
  const std::optional<HiddenCases> hidden = read_assignment(assignment).hidden;
  make_package_folder(target);
  copy_parts(project, handout_parts(), target, hidden ? hidden->seed_file : "");
  copy_parts("", {{assignment.string(), "grader/assignment.toml"}}, target);
}

}  // namespace meshgrade

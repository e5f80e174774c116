#include "grader/package/handout.h"

#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/package/package_files.h"

namespace meshgrade {
namespace {

std::vector<PackagePart> handout_parts(const std::filesystem::path& project) {
  std::vector<PackagePart> parts = grader_parts(project);
  parts.push_back({"student_skeleton", "student_skeleton"});
  // It lies at the top here, too, so that its links hold in both places.
  parts.push_back({"HANDOUT.md", "README.md"});
  const std::string container = "grader/package/hosts/container/";
  parts.push_back({container + "Containerfile", "Containerfile"});
  parts.push_back({container + "devcontainer.json", ".devcontainer/devcontainer.json"});
  for (const char* page :
       {"student.md", "installing.md", "rules.md", "report.md", "report.schema.json",
        "formats.md", "dropin.md", "assignment.md", "exercises", "viewer.md", "loop_rules.md",
        "lopsided_cube.md", "polygon_meshes.md", "scotty3d.md", "pictures", "writeup",
        "writeup_rubric.toml"}) {
    const std::string path = std::string("docs/") + page;
    parts.push_back({path, path});
  }
  return parts;
}

}  // namespace

void write_handout(const PackageSource& source, const std::filesystem::path& target) {
  const Assignment read = read_assignment(source.assignment);
  std::vector<std::filesystem::path> secrets;
  if (read.hidden) secrets.push_back(read.hidden->seed_file);
  for (const OwnMesh& mesh : read.own_meshes()) {
    if (mesh.hidden) secrets.push_back(mesh.file);
  }
  make_package_folder(target);
  copy_parts(source.project, handout_parts(source.project), target, secrets);
  copy_parts("", assignment_parts(read, source.assignment, "grader/assignment.toml", false),
             target);
  if (!source.program.empty()) copy_program(source.program, target / "program");
}

}  // namespace meshgrade

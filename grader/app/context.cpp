#include "grader/app/context.h"

#include <unistd.h>
#include <fstream>
#include <iterator>

#include "grader/base/errors.h"
#include "grader/cases/own_meshes.h"
#include "grader/judge/judge.h"
#include "grader/sandbox/system_paths.h"

namespace meshgrade {

std::filesystem::path source_folder() {
  return MESHGRADE_SOURCE_DIR;
}

namespace {

namespace fs = std::filesystem;

/// A copy that all can read, with the times of the files: the compiler compares those of
/// precompiled headers.
void copy_folder(const fs::path& from, const fs::path& to) {
  fs::copy(from, to, fs::copy_options::recursive);
  fs::permissions(to, fs::perms(0755));
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(from)) {
    const fs::path copy = to / entry.path().lexically_relative(from);
    const bool runs = (entry.status().permissions() & fs::perms::owner_exec) != fs::perms::none;
    fs::permissions(copy, runs ? fs::perms(0755) : fs::perms(0644));
    if (entry.is_regular_file()) fs::last_write_time(copy, entry.last_write_time());
  }
}

/// Root's own folders are closed to the users that submissions run as: what those need is then
/// copied to where they can read it.
void open_to_submissions(Home& home) {
  if (::geteuid() != 0 || (is_open_to_others(home.kit / "flags.txt") &&
                           is_open_to_others(home.include / "meshedit" / "meshedit.h"))) {
    return;
  }
  home.copies = std::make_shared<ScratchFolder>();
  fs::permissions(home.copies->path(), fs::perms(0755));
  for (fs::path* folder : {&home.kit, &home.include}) {
    const fs::path copy = home.copies->path() / folder->filename();
    copy_folder(*folder, copy);
    *folder = copy;
  }
}

}  // namespace

Home find_home() {
  const fs::path source = source_folder();
  Home home;
  home.include = source / "include";
  home.kit = MESHGRADE_KIT_DIR;
  home.meshes = source / "meshes";
  home.docs = source / "docs";
  std::error_code ignored;
  if (fs::is_directory(source / "reference", ignored)) home.reference = source / "reference";
  home.compiler = MESHGRADE_COMPILER;
  open_to_submissions(home);
  home.sandbox = find_sandbox(home.kit, home.compiler);
  return home;
}

std::string viewer_page() {
  const std::filesystem::path file = source_folder() / "viewer" / "dist" / "viewer.html";
  std::ifstream stream(file, std::ios::binary);
  std::string page{std::istreambuf_iterator<char>(stream), {}};
  if (page.empty()) throw GraderError(file.string() + ": the viewer's page cannot be read");
  return page;
}

std::filesystem::path standard_assignment() {
  return source_folder() / "grader" / "assignment.toml";
}

std::filesystem::path or_standard_assignment(const std::string& file) {
  return file.empty() ? standard_assignment() : std::filesystem::path(file);
}

Assignment load_assignment(const std::string& file) {
  Assignment assignment = read_assignment(or_standard_assignment(file));
  for (const ExerciseRubric& rubric : assignment.exercises)
    find_exercise_judge(rubric);
  check_own_meshes(assignment);
  return assignment;
}

void require_hidden_seed(const Assignment& assignment) {
  for (const OwnMesh& mesh : assignment.own_meshes()) {
    if (!mesh.is_there) {
      throw UserError(mesh.place + ": there is no file " + mesh.file.string() +
                      ", which the assignment's hidden cases need");
    }
  }
  if (!assignment.hidden || assignment.hidden->seed) return;
  throw UserError(assignment.hidden->seed_file.string() +
                  ": cannot be read; it holds the seed of the assignment's hidden cases");
}

}  // namespace meshgrade

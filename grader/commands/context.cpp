#include "grader/commands/context.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <utility>

#include "grader/base/errors.h"
#include "grader/cases/own_meshes.h"
#include "grader/commands/installed_home.h"
#include "grader/commands/kept_work.h"
#include "grader/judge/judge.h"
#include "grader/sandbox/system_paths.h"

namespace meshgrade {

namespace {

namespace fs = std::filesystem;

fs::path find_source_folder() {
  const char* named = std::getenv("MESHGRADE_HOME");
  if (named != nullptr && *named != '\0') return named;
  const fs::path installed = installed_share();
  return installed.empty() ? MESHGRADE_SOURCE_DIR : installed;
}

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
  if (::geteuid() != 0) return;
  const std::pair<fs::path*, fs::path> needed[] = {
      {&home.kit, home.kit / "flags.txt"},
      {&home.include, home.include / "meshedit" / "meshedit.h"}};
  for (const auto& [folder, file] : needed) {
    if (is_open_to_others(file)) continue;
    if (!home.copies) {
      home.copies = std::make_shared<ScratchFolder>();
      fs::permissions(home.copies->path(), fs::perms(0755));
    }
    const fs::path copy = home.copies->path() / folder->filename();
    copy_folder(*folder, copy);
    *folder = copy;
  }
}

/// The compiler, and the kit that fits it.
void find_kit(Home& home) {
  const fs::path installed = installed_share();
  home.compiler = installed.empty() ? MESHGRADE_COMPILER : installed_compiler();
  home.kit = MESHGRADE_KIT_DIR;
  if (installed.empty()) return;
  ReadyKit kit = ready_kit(installed / "kit", home.include, home.compiler);
  home.kit = kit.folder;
  home.own_kit = std::move(kit.scratch);
}

}  // namespace

std::filesystem::path source_folder() {
  static const fs::path folder = find_source_folder();
  return folder;
}

Home find_home(const HomeOptions& options) {
  const StageTimer timer(options.times.get(), "find a compiler and a sandbox");
  const fs::path source = source_folder();
  Home home;
  home.times = options.times;
  home.include = source / "include";
  home.meshes = source / "meshes";
  home.docs = source / "docs";
  std::error_code ignored;
  if (fs::is_directory(source / "reference", ignored)) home.reference = source / "reference";
  find_kit(home);
  open_to_submissions(home);
  home.sandbox = find_sandbox(home.kit, home.compiler);
  if (options.keeps_work) keep_work(home);
  return home;
}

ProgramFiles program_files() {
  const fs::path share = installed_share();
  if (share.empty()) return {"", fs::path(MESHGRADE_KIT_DIR).parent_path()};
  return {share.parent_path().parent_path(), ""};
}

bool has_sources() {
  std::error_code ignored;
  return fs::exists(source_folder() / "CMakeLists.txt", ignored);
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

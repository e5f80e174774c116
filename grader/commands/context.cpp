#include "grader/commands/context.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/cases/own_meshes.h"
#include "grader/commands/installed_home.h"
#include "grader/commands/kept_work.h"
#include "grader/grade/dialect_fit.h"
#include "grader/judge/judge.h"
#include "grader/sandbox/system_paths.h"
#include "grader/submission/function_extents.h"

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
  if (file.empty()) return standard_assignment();
  std::error_code error;
  if (fs::exists(file, error) || fs::path(file).has_extension() ||
      fs::path(file).has_parent_path()) {
    return file;
  }
  fs::path named = source_folder() / "grader" / (file + ".toml");
  if (fs::exists(named, error)) return named;
  throw UserError("there is no assignment \"" + file + "\": name a file (TOML), or " +
                  join(named_assignments(), " or "));
}

std::vector<std::string> named_assignments() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(source_folder() / "grader")) {
    const fs::path& file = entry.path();
    if (file.extension() == ".toml" && file != standard_assignment())
      names.push_back(file.stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

Assignment load_assignment(const std::string& file) {
  Assignment assignment = read_assignment(or_standard_assignment(file));
  for (const ExerciseRubric& rubric : assignment.exercises)
    find_exercise_judge(rubric);
  check_own_meshes(assignment);
  return assignment;
}

namespace {

/// What the files of a submission define, and for which skeleton.
struct Definitions {
  std::set<std::string> functions;
  Dialect dialect = Dialect::kMeshedit;
};

/// None where a submission cannot be read, which is told where it is read to be graded.
Definitions definitions_of(const SubmissionTaker& take) {
  Definitions definitions;
  try {
    const Submission found = take();
    definitions.dialect = found.dialect;
    for (const SourceFile* file : own_files(found)) {
      for (const FunctionExtent& function : find_functions(file->text))
        definitions.functions.insert(function.name);
    }
  } catch (const UserError&) {
  }
  return definitions;
}

bool is_about(const Assignment& assignment, const Definitions& definitions) {
  const Assignment asked = fit_to_dialect(assignment, definitions.dialect);
  const std::set<std::string>& defined = definitions.functions;
  for (const ExerciseRubric& rubric : asked.exercises) {
    for (const std::string& function : find_exercise_judge(rubric).functions) {
      if (defined.count(function) != 0) return true;
    }
  }
  return false;
}

}  // namespace

std::string recognise_assignment(const std::string& named,
                                 const std::vector<SubmissionTaker>& submissions) {
  if (!named.empty()) return named;
  const Assignment standard = load_assignment("");
  std::map<std::string, Assignment> others;
  for (const std::string& name : named_assignments())
    others.emplace(name, load_assignment(name));
  std::string recognised;
  for (const SubmissionTaker& take : submissions) {
    const Definitions defined = definitions_of(take);
    if (is_about(standard, defined)) return {};
    for (const auto& [name, other] : others) {
      if (recognised.empty() && is_about(other, defined)) recognised = name;
    }
  }
  return recognised;
}

Assignment load_assignment_of(const std::string& named, const fs::path& submission) {
  return load_assignment(recognise_assignment(
      named, {[&] { return find_submission(submission, SubmissionRules()); }}));
}

Assignment as_class_is_asked(Assignment assignment,
                             const std::vector<SubmissionTaker>& submissions) {
  const Assignment early = fit_to_dialect(assignment, Dialect::kScotty3d2020);
  if (early.exercises.empty()) return assignment;
  std::vector<Submission> taken;
  for (const SubmissionTaker& take : submissions) {
    try {
      taken.push_back(take());
    } catch (const UserError&) {  // told where it is read to be graded
    }
    if (!taken.empty() && taken.back().dialect != Dialect::kScotty3d2020) return assignment;
  }
  return fit_to_class(std::move(assignment), taken);
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

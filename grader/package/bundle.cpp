#include "grader/package/bundle.h"

#include "grader/assignment/assignment.h"
#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/package/archive_writer.h"
#include "grader/package/handout.h"
#include "grader/package/package_files.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

const fs::path kHosts = fs::path("grader") / "package" / "hosts";

/// The assignment with the seed of its hidden cases: only where students cannot look.
void add_assignment(const fs::path& file, const fs::path& folder) {
  const Assignment assignment = read_assignment(file);
  std::vector<PackagePart> parts = assignment_parts(assignment, file, "assignment.toml", true);
  if (assignment.hidden) {
    const fs::path& seed = assignment.hidden->seed_file;
    if (fs::absolute(seed).parent_path() != fs::absolute(file).parent_path()) {
      throw UserError(seed.string() + ": the seed of hidden cases must lie beside " +
                      file.string() + ", so that a bundle can hold both");
    }
    parts.push_back({seed.string(), seed.filename().string()});
  }
  copy_parts("", parts, folder);
}

/// The grader with the reference, which lets subdivision be judged on its own.
void add_grader(const PackageSource& source, const fs::path& folder) {
  std::vector<PackagePart> parts = grader_parts(source.project);
  parts.push_back({"reference", "reference"});
  parts.push_back({"docs/exercises", "docs/exercises"});
  copy_parts(source.project, parts, folder);
  add_assignment(source.assignment, folder / "grader");
  if (!source.program.empty()) copy_program(source.program, folder / "program");
}

void add_scripts(const fs::path& project, const std::string& host, const fs::path& folder) {
  copy_parts(project, {{(kHosts / host).string(), "."}}, folder);
}

void fill_gradescope(const PackageSource& source, const fs::path& folder) {
  add_scripts(source.project, "gradescope", folder);
  add_grader(source, folder / "meshgrade");
}

/// Autolab takes two files: they are packed together, to be unpacked before the upload.
void fill_autolab(const PackageSource& source, const fs::path& folder) {
  const ScratchFolder inner;
  copy_parts(source.project, {{(kHosts / "autolab" / "grade.sh").string(), "grade.sh"}},
             inner.path());
  add_assignment(source.assignment, inner.path());
  add_grader(source, inner.path() / "meshgrade");
  write_archive(inner.path(), folder / "autograde.tar");
  const std::string makefile = "autograde-Makefile";
  copy_parts(source.project, {{(kHosts / "autolab" / makefile).string(), makefile}}, folder);
}

/// All of it is within the students' reach, so it is the handout.
void fill_github(const PackageSource& source, const fs::path& folder) {
  const fs::path scripts = kHosts / "github";
  write_handout(source, folder / ".meshgrade");
  copy_parts(source.project,
             {{(scripts / "grade.sh").string(), ".meshgrade/grade.sh"},
              {(scripts / "meshgrade.yml").string(), ".github/workflows/meshgrade.yml"}},
             folder);
}

void fill_prairielearn(const PackageSource& source, const fs::path& folder) {
  const fs::path scripts = kHosts / "prairielearn";
  copy_parts(source.project,
             {{(scripts / "run.sh").string(), "question/tests/run.sh"},
              {(scripts / "info.json").string(), "question/info.json"},
              {(scripts / "Dockerfile").string(), "image/Dockerfile"}},
             folder);
  add_grader(source, folder / "image" / "meshgrade");
}

}  // namespace

const std::vector<Host>& hosts() {
  static const std::vector<Host> list{
      {"gradescope", "a zip to upload as the autograder", "gradescope.zip", fill_gradescope},
      {"autolab", "autograde-Makefile and autograde.tar, to unpack and upload", "autolab.zip",
       fill_autolab},
      {"github", "a workflow and .meshgrade/, for the repository that students start from",
       "github.zip", fill_github},
      {"prairielearn", "the question's grader, and the image that it runs in",
       "prairielearn.zip", fill_prairielearn},
  };
  return list;
}

void write_bundle(const std::string& host, const PackageSource& source, const fs::path& file) {
  std::vector<std::string> names;
  for (const Host& known : hosts()) {
    names.emplace_back(known.name);
    if (host != known.name) continue;
    const ScratchFolder folder;
    known.fill(source, folder.path());
    write_archive(folder.path(), file);
    return;
  }
  throw UserError("there is no host \"" + host + "\"; there are " + join(names, ", "));
}

}  // namespace meshgrade

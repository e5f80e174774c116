#include "grader/package/program_files.h"

#include <system_error>

#include "grader/base/errors.h"
#include "grader/base/process.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

void copy_installed(const fs::path& installed, const fs::path& target) {
  const fs::path share = fs::path("share") / "meshgrade";
  for (const fs::path& part : {fs::path("bin") / "meshgrade", fs::path("lib") / "meshgrade",
                               share / "kit", share / "licences"}) {
    std::error_code error;
    fs::create_directories((target / part).parent_path(), error);
    if (!error) fs::copy(installed / part, target / part, fs::copy_options::recursive, error);
    if (error)
      throw UserError((target / part).string() + ": cannot be written: " + error.message());
  }
}

void install_built(const fs::path& build, const fs::path& target) {
  Command command;
  command.arguments = {"cmake",       "--install", build,    "--prefix", fs::absolute(target),
                       "--component", "program",   "--strip"};
  const ProcessResult result = run_process(command);
  if (result.ok()) return;
  throw UserError(target.string() + ": the program cannot be put there:\n" + result.output);
}

}  // namespace

void copy_program(const ProgramFiles& program, const fs::path& target) {
  if (program.installed.empty())
    install_built(program.build, target);
  else
    copy_installed(program.installed, target);
}

}  // namespace meshgrade

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <sstream>

#include "grader/base/errors.h"
#include "grader/base/interrupt.h"
#include "grader/base/text.h"
#include "grader/commands/autograde_command.h"
#include "grader/commands/batch_command.h"
#include "grader/commands/bundle_command.h"
#include "grader/commands/check_command.h"
#include "grader/commands/completions_command.h"
#include "grader/commands/dev_check_command.h"
#include "grader/commands/diff_command.h"
#include "grader/commands/doctor_command.h"
#include "grader/commands/exit_codes.h"
#include "grader/commands/export_command.h"
#include "grader/commands/handout_command.h"
#include "grader/commands/hint_command.h"
#include "grader/commands/list_command.h"
#include "grader/commands/mesh_info_command.h"
#include "grader/commands/replay_command.h"
#include "grader/commands/similarity_command.h"
#include "grader/commands/simplify_command.h"
#include "grader/commands/subdivide_command.h"
#include "grader/commands/view_command.h"
#include "grader/commands/watch_command.h"
#include "grader/commands/writeup_command.h"

namespace {

/// Else a mistyped command would be told to be an unexpected argument.
void require_command(const CLI::App& app, int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "-";
  const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
  const bool is_known =
      std::any_of(commands.begin(), commands.end(),
                  [&](const CLI::App* command) { return command->get_name() == name; });
  if (name.rfind('-', 0) == 0 || is_known) return;
  throw meshgrade::UserError("there is no command \"" + name + "\"; see --help");
}

int run(int argc, char** argv) {
  int exit_code = 0;
  CLI::App app("Meshgrade teaches half-edge meshes and Bezier surfaces, and grades them.",
               "meshgrade");
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("meshgrade ") + MESHGRADE_VERSION);
  meshgrade::add_check_command(app, exit_code);
  meshgrade::add_batch_command(app, exit_code);
  meshgrade::add_export_command(app, exit_code);
  meshgrade::add_diff_command(app, exit_code);
  meshgrade::add_similarity_command(app, exit_code);
  meshgrade::add_view_command(app, exit_code);
  meshgrade::add_writeup_command(app, exit_code);
  meshgrade::add_watch_command(app, exit_code);
  meshgrade::add_replay_command(app, exit_code);
  meshgrade::add_hint_command(app, exit_code);
  meshgrade::add_list_command(app, exit_code);
  meshgrade::add_subdivide_command(app, exit_code);
  meshgrade::add_simplify_command(app, exit_code);
  meshgrade::add_mesh_info_command(app, exit_code);
  meshgrade::add_autograde_command(app, exit_code);
  meshgrade::add_bundle_command(app, exit_code);
  meshgrade::add_handout_command(app, exit_code);
  meshgrade::add_doctor_command(app, exit_code);
  meshgrade::add_completions_command(app, MESHGRADE_VERSION, exit_code);
  meshgrade::add_dev_check_command(app, exit_code);
  app.footer(
      "`meshgrade COMMAND --help` explains a command, with examples.\n"
      "The script ./meshgrade also knows self-test, bench, fuzz and package.");
  require_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream complaint;
    const bool asked_for_help = app.exit(error, std::cout, complaint) == 0;
    std::cerr << meshgrade::printable(complaint.str());
    return asked_for_help ? 0 : meshgrade::kUserError;
  }
  return exit_code;
}

/// File names and what students wrote come into messages: nothing of them rules the terminal.
void say(const std::string& message) {
  std::cerr << "meshgrade: " << meshgrade::printable(message) << "\n";
}

int run_and_explain(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const meshgrade::UserError& error) {
    say(error.what());
    return meshgrade::kUserError;
  } catch (const std::exception& error) {
    say(std::string("the grader itself failed: ") + error.what());
    return meshgrade::kGraderFailed;
  }
}

/// Output that is lost is no success. Who closes a pipe early (`| head`) has seen enough.
int flush_output(int exit_code) {
  errno = 0;
  std::cout.flush();
  if (std::cout && std::ferror(stdout) == 0) return exit_code;
  // It failed earlier, where nobody kept the reason: a line's end more does no harm now.
  if (errno == 0 && ::write(STDOUT_FILENO, "\n", 1) == 1) errno = 0;
  if (errno == EPIPE) return exit_code;
  say(std::string("standard output cannot be written") +
      (errno == 0 ? "" : std::string(": ") + std::strerror(errno)));
  return std::max(exit_code, meshgrade::kUserError);
}

}  // namespace

int main(int argc, char** argv) {
  meshgrade::end_in_order_when_interrupted();
  try {
    const int exit_code = flush_output(run_and_explain(argc, argv));
    if (meshgrade::interruption() == 0) return exit_code;
  } catch (const meshgrade::Interrupted& interrupted) {
    meshgrade::end_by(interrupted);
  }
  meshgrade::end_by({meshgrade::interruption()});
}

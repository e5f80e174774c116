#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "grader/app/autograde_command.h"
#include "grader/app/batch_command.h"
#include "grader/app/bundle_command.h"
#include "grader/app/check_command.h"
#include "grader/app/dev_check_command.h"
#include "grader/app/diff_command.h"
#include "grader/app/doctor_command.h"
#include "grader/app/export_command.h"
#include "grader/app/handout_command.h"
#include "grader/app/hint_command.h"
#include "grader/app/list_command.h"
#include "grader/app/mesh_info_command.h"
#include "grader/app/replay_command.h"
#include "grader/app/similarity_command.h"
#include "grader/app/subdivide_command.h"
#include "grader/app/view_command.h"
#include "grader/app/watch_command.h"
#include "grader/base/errors.h"

namespace {

constexpr int kBadUsage = 2;
constexpr int kGraderFailed = 3;

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
  meshgrade::add_watch_command(app, exit_code);
  meshgrade::add_replay_command(app, exit_code);
  meshgrade::add_hint_command(app, exit_code);
  meshgrade::add_list_command(app, exit_code);
  meshgrade::add_subdivide_command(app, exit_code);
  meshgrade::add_mesh_info_command(app, exit_code);
  meshgrade::add_autograde_command(app, exit_code);
  meshgrade::add_bundle_command(app, exit_code);
  meshgrade::add_handout_command(app, exit_code);
  meshgrade::add_doctor_command(app, exit_code);
  meshgrade::add_dev_check_command(app, exit_code);
  app.footer(
      "`meshgrade COMMAND --help` explains a command, with examples.\n"
      "The script ./meshgrade also knows self-test, bench and fuzz.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUsage;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const meshgrade::UserError& error) {
    std::cerr << "meshgrade: " << error.what() << "\n";
    return kBadUsage;
  } catch (const std::exception& error) {
    std::cerr << "meshgrade: the grader itself failed: " << error.what() << "\n";
    return kGraderFailed;
  }
}

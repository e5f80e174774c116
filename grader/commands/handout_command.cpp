#include "grader/commands/handout_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/commands/context.h"
#include "grader/package/handout.h"

namespace meshgrade {
namespace {

struct HandoutOptions {
  std::string output;
  std::string assignment;
  bool with_program = false;
};

int handout(const HandoutOptions& options) {
  const std::filesystem::path assignment = or_standard_assignment(options.assignment);
  load_assignment(options.assignment);  // what is wrong with it is told here, not to students
  PackageSource source{source_folder(), assignment};
  if (options.with_program || !has_sources()) source.program = program_files();
  write_handout(source, options.output);
  std::cout << options.output << ": the students' package, without the reference.\n"
            << "Try it as a student would: cd " << options.output
            << " && ./meshgrade check student_skeleton\n";
  return 0;
}

}  // namespace

void add_handout_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<HandoutOptions>();
  CLI::App* command = app.add_subcommand(
      "handout", "Write the students' package: skeleton, headers, grader, meshes, pages");
  command->add_option("-o,--output", options->output, "A folder that is new or empty")
      ->required();
  command->add_option("--assignment", options->assignment,
                      "The assignment of the package (TOML); the standard one if not given");
  command->add_flag("--with-program", options->with_program,
                    "Also this program, for Linux on x86-64: nothing is built then");
  command->footer(
      "Examples:\n"
      "  meshgrade handout -o homework3\n"
      "  meshgrade handout -o homework3 --assignment my_assignment.toml\n"
      "  meshgrade handout -o homework3 --with-program\n"
      "Exit code: 0 written, 2 bad usage or a folder that cannot be written.");
  command->callback([options, &exit_code] { exit_code = handout(*options); });
}

}  // namespace meshgrade

#include "grader/commands/bundle_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/assignment/assignment.h"
#include "grader/commands/context.h"
#include "grader/commands/output_check.h"
#include "grader/package/bundle.h"

namespace meshgrade {
namespace {

struct BundleOptions {
  std::string host;
  std::string output;
  std::string assignment;
  bool with_program = false;
};

int bundle(const BundleOptions& options) {
  const std::filesystem::path assignment = or_standard_assignment(options.assignment);
  check_outputs({{"-o", options.output}}, {assignment});
  require_hidden_seed(load_assignment(options.assignment));
  PackageSource source{source_folder(), assignment};
  if (options.with_program || !has_sources()) source.program = program_files();
  write_bundle(options.host, source, options.output);
  std::cout << "wrote " << options.output << "\n";
  return 0;
}

std::string host_list() {
  std::string text = "Hosts:\n";
  for (const Host& host : hosts()) {
    const std::string name = host.name;
    text += "  " + name + std::string(14 - name.size(), ' ') + host.title + "\n";
  }
  return text;
}

}  // namespace

void add_bundle_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<BundleOptions>();
  CLI::App* command =
      app.add_subcommand("bundle", "Write an autograder for Gradescope and the like");
  command->add_option("host", options->host, "One of those below")->required();
  add_output_option(*command, "-o,--output", options->output, "The file: .zip, .tar or .tar.gz")
      ->required();
  command->add_option("--assignment", options->assignment,
                      "The assignment to grade (TOML); the standard one if not given");
  command->add_flag("--with-program", options->with_program,
                    "Also this program, for Linux on x86-64: nothing is built there");
  command->footer(
      host_list() +
      "Examples:\n"
      "  meshgrade bundle gradescope -o gradescope.zip\n"
      "  meshgrade bundle github -o github.zip --assignment my_assignment.toml\n"
      "  meshgrade bundle gradescope -o gradescope.zip --with-program\n"
      "docs/autograders.md says what to do with it. All but that for github hold the "
      "reference.\n"
      "Exit code: 0 written, 2 bad usage or a file that cannot be written.");
  command->callback([options, &exit_code] { exit_code = bundle(*options); });
}

}  // namespace meshgrade

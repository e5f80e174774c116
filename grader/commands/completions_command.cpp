#include "grader/commands/completions_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/commands/shell_support.h"

namespace meshgrade {

void add_completions_command(CLI::App& app, const std::string& version, int& exit_code) {
  auto form = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "completions", "Print how a shell completes commands and options, or the manual page");
  command->add_option("form", *form, "bash, zsh, fish or man")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish", "man"}));
  command->footer(
      "Examples:\n"
      "  source <(meshgrade completions bash)\n"
      "  meshgrade completions fish > ~/.config/fish/completions/meshgrade.fish\n"
      "  meshgrade completions man > meshgrade.1 && man ./meshgrade.1\n"
      "Exit code: 0, or 2 for a form that is not known.");
  command->callback([&app, form, version, &exit_code] {
    std::cout << (*form == "man" ? manual_page(app, version) : completions_for(*form, app));
    exit_code = 0;
  });
}

}  // namespace meshgrade

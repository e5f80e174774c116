#include "grader/commands/shell_support.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "grader/base/text.h"

namespace meshgrade {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    names.push_back("--" + name);
  return names;
}

std::string option_words(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : options_of(command)) {
    const std::vector<std::string> names = names_of(*option);
    words.insert(words.end(), names.begin(), names.end());
  }
  return join(words, " ");
}

/// One line, without what would end a quotation or mean something in a description.
std::string plain(const std::string& text) {
  std::string line = text.substr(0, text.find('\n'));
  line.erase(std::remove_if(
                 line.begin(), line.end(),
                 [](char c) { return std::string("'\"`$\\[]:").find(c) != std::string::npos; }),
             line.end());
  return line;
}

std::string bash_completions(const CLI::App& app) {
  std::vector<std::string> names;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
    cases += "    " + command->get_name() + ") words='" + option_words(*command) + "' ;;\n";
  }
  return "_meshgrade() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} words\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W '" +
         join(names, " ") +
         " --help --version' -- \"$current\")\n"
         "    return\n"
         "  fi\n"
         "  case ${COMP_WORDS[1]} in\n" +
         cases +
         "    *) return ;;\n"
         "  esac\n"
         "  case $current in -*) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- "
         "\"$current\") "
         ";; esac\n"
         "}\n"
         "complete -o bashdefault -o default -F _meshgrade meshgrade\n";
}

std::string zsh_completions(const CLI::App& app) {
  std::string names;
  std::string cases;
  for (const CLI::App* command : commands_of(app)) {
    names += "    '" + command->get_name() + ":" + plain(command->get_description()) + "'\n";
    cases += "    " + command->get_name() + ")\n      _arguments";
    for (const CLI::Option* option : options_of(*command)) {
      const bool takes_value = option->get_type_size_max() != 0;
      for (const std::string& name : names_of(*option)) {
        cases += " \\\n        '" + name + "[" + plain(option->get_description()) + "]" +
                 (takes_value ? ":value:_files'" : "'");
      }
    }
    cases += " \\\n        '*:file:_files' ;;\n";
  }
  return "#compdef meshgrade\n"
         "local -a commands\n"
         "commands=(\n" +
         names +
         ")\n"
         "if (( CURRENT == 2 )); then\n"
         "  _describe command commands\n"
         "else\n"
         "  local command=$words[2]\n"
         "  shift words\n"
         "  (( CURRENT-- ))\n"
         "  case $command in\n" +
         cases +
         "  esac\n"
         "fi\n";
}

std::string fish_completions(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : commands_of(app)) {
    text += "complete -c meshgrade -n __fish_use_subcommand -f -a " + command->get_name() +
            " -d '" + plain(command->get_description()) + "'\n";
    for (const CLI::Option* option : options_of(*command)) {
      text +=
          "complete -c meshgrade -n '__fish_seen_subcommand_from " + command->get_name() + "'";
      for (const std::string& name : option->get_snames())
        text += " -s " + name;
      for (const std::string& name : option->get_lnames())
        text += " -l " + name;
      text += (option->get_type_size_max() != 0 ? " -r -d '" : " -d '") +
              plain(option->get_description()) + "'\n";
    }
  }
  return text;
}

/// Text as man(7) prints it: a dot or an apostrophe at the start of a line would be a command.
std::string roff(const std::string& text) {
  std::string result;
  for (const std::string& line : split_lines(text)) {
    if (!line.empty() && (line[0] == '.' || line[0] == '\'')) result += "\\&";
    for (const char c : line)
      result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    result += "\n";
  }
  return result;
}

std::string manual_of_option(const CLI::Option& option) {
  const std::string names =
      option.nonpositional() ? join(names_of(option), ", ") : option.get_name(true);
  return ".TP\n.B " + roff(names.empty() ? option.get_name() : names) +
         roff(option.get_description());
}

std::string manual_of_command(const CLI::App& command) {
  std::string text =
      ".SS " + roff("meshgrade " + command.get_name()) + roff(command.get_description());
  for (const CLI::Option* option : command.get_options({}))
    text += manual_of_option(*option);
  if (!command.get_footer().empty())
    text += ".PP\n.nf\n" + roff(command.get_footer()) + ".fi\n";
  return text;
}

}  // namespace

std::string completions_for(const std::string& shell, const CLI::App& app) {
  if (shell == "zsh") return zsh_completions(app);
  return shell == "fish" ? fish_completions(app) : bash_completions(app);
}

std::string manual_page(const CLI::App& app, const std::string& version) {
  std::string text = ".TH MESHGRADE 1 \"\" \"" + roff("Meshgrade " + version);
  text.pop_back();
  text += "\"\n.SH NAME\n" + roff("meshgrade - " + app.get_description()) +
          ".SH SYNOPSIS\n.B meshgrade\n.I command\n.RI [ options ]\n.SH COMMANDS\n";
  for (const CLI::App* command : commands_of(app))
    text += manual_of_command(*command);
  return text + ".SH FILES\n.TP\n.I ~/.cache/meshgrade\n" +
         roff(
             "The shared headers, compiled once for the compiler that is used. May be "
             "removed.");
}

}  // namespace meshgrade

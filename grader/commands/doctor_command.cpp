#include "grader/commands/doctor_command.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "grader/base/errors.h"
#include "grader/base/process.h"
#include "grader/base/text.h"
#include "grader/commands/context.h"
#include "grader/commands/kept_work.h"

namespace meshgrade {
namespace {

/// The first line of what a program says about its version, or that it cannot be started.
std::string version_of(const std::string& program) {
  Command command;
  command.arguments = {program, "--version"};
  try {
    const std::vector<std::string> lines = split_lines(printable(run_process(command).output));
    return lines.empty() ? "found" : lines[0];
  } catch (const GraderError&) {
    return {};
  }
}

void print(const std::string& name, bool works, const std::string& detail) {
  std::cout << "  " << (works ? "ok       " : "missing  ") << name;
  if (!detail.empty()) std::cout << ": " << detail;
  std::cout << "\n";
}

void print_tools(const Home& home) {
  struct Tool {
    std::string program;
    std::string use;
  };
  const Tool tools[] = {{home.compiler, "compiles submissions"},
                        {"objcopy", "keeps a submission from replacing library functions"},
                        {"addr2line", "finds the line of a crash"},
                        {"gdb", "for replay --debug"},
                        {"bwrap", "for layer 1 (package bubblewrap)"}};
  std::cout << "Programs\n";
  for (const Tool& tool : tools) {
    const std::string version = version_of(tool.program);
    print(tool.program + ", " + tool.use, !version.empty(), version);
  }
}

/// What the chosen sandbox asks of this kernel, without the layers that were tried.
void print_probes(const Sandbox& sandbox) {
  std::cout << "\nWhat this machine offers\n";
  for (const Probe& probe : sandbox.probes) {
    if (probe.name.rfind("layer ", 0) != 0) print(probe.name, probe.works, probe.detail);
  }
}

/// Why this layer does not work; empty if it does.
std::string reason_against(const Sandbox& tried, Layer layer) {
  for (const Probe& probe : tried.probes) {
    if (probe.name == "layer " + layer_name(layer)) return probe.detail;
  }
  return {};
}

void print_layers(const Home& home) {
  std::cout << "\nWays to keep student code away from everything else, the strongest first\n";
  for (const Layer layer : {Layer::kNamespaces, Layer::kOtherUser, Layer::kSameUser}) {
    const Sandbox tried = find_sandbox(home.kit, home.compiler, layer);
    const bool works = tried.layer == layer;
    print("layer " + layer_name(layer), works, works ? "" : reason_against(tried, layer));
    std::cout << "           " << layer_promise(layer) << "\n";
  }
}

void print_cache(const Home& home) {
  std::cout << "\nWhat is kept of earlier checks\n";
  print("cache", home.kept != nullptr, kept_work_text(home));
}

void doctor() {
  const Home home = find_home({true});
  print_tools(home);
  print_probes(home.sandbox);
  print_layers(home);
  print_cache(home);
  const Layer layer = home.sandbox.layer;
  std::cout << "\nSubmissions are graded in layer " << layer_name(layer) << ".\n";
  const bool strong = layer == Layer::kNamespaces || layer == Layer::kOtherUser;
  std::cout << (strong
                    ? "--require-sandbox is satisfied: code of strangers can be graded here.\n"
                    : "--require-sandbox refuses: grade only your own code here.\n");
}

}  // namespace

void add_doctor_command(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "doctor", "Tell what this machine offers, and what that protects against");
  command->footer(
      "Examples:\n"
      "  meshgrade doctor\n"
      "  meshgrade check homework --require-sandbox   refuses where doctor says so\n"
      "Exit code: 0.");
  command->callback([&exit_code] {
    doctor();
    exit_code = 0;
  });
}

}  // namespace meshgrade

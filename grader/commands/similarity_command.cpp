#include "grader/commands/similarity_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/base/csv.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/commands/class_source.h"
#include "grader/commands/context.h"
#include "grader/commands/output_check.h"
#include "grader/similarity/similarity.h"
#include "grader/similarity/similarity_page.h"

namespace meshgrade {
namespace {

struct SimilarityCommandOptions {
  std::string submissions;
  std::string assignment;
  std::string skeleton;
  std::string output;
  std::string page;
  RosterOptions roster;
  SimilarityOptions how;
  int least_percent = 1;
  std::size_t top = 20;
};

std::string to_csv(const std::vector<SimilarPair>& pairs) {
  std::string text = csv_line({"first", "second", "percent_of_first", "percent_of_second"});
  for (const SimilarPair& pair : pairs) {
    text += csv_line({csv_text(pair.first), csv_text(pair.second),
                      std::to_string(pair.of_first), std::to_string(pair.of_second)});
  }
  return text;
}

/// Whatever lies among the submissions may be somebody's work.
void check_similarity_files(const SimilarityCommandOptions& options) {
  std::vector<Output> outputs;
  std::vector<std::filesystem::path> inputs{options.submissions,
                                            or_standard_assignment(options.assignment)};
  for (const Output& output : {Output{"-o", options.output}, Output{"--html", options.page}}) {
    if (output.file.empty()) continue;
    outputs.push_back(output);
    if (lies_within(output.file, options.submissions)) inputs.push_back(output.file);
  }
  check_outputs(outputs, inputs);
}

void print_groups(const std::vector<SimilarPair>& pairs) {
  for (const std::vector<std::string>& group : groups_of(pairs, kGroupPercent))
    std::cout << "group of " << group.size() << ": " << printable(join(group, ", ")) << "\n";
}

void print_pairs(const std::vector<SimilarPair>& pairs, std::size_t top) {
  for (std::size_t i = 0; i < std::min(top, pairs.size()); ++i) {
    const SimilarPair& pair = pairs[i];
    std::cout << pair.of_first << " % of " << printable(pair.first) << " is in "
              << printable(pair.second) << ", " << pair.of_second << " % the other way round\n";
  }
  std::cout << plural(pairs.size(), "pair") << " with something in common";
  if (pairs.size() > top) std::cout << ", the first " << top << " are shown";
  std::cout << "\n";
}

void similarity(SimilarityCommandOptions& options) {
  check_similarity_files(options);
  const Assignment assignment = load_assignment(options.assignment);
  options.how.rules = assignment.submission;
  const std::filesystem::path skeleton = options.skeleton.empty()
                                             ? source_folder() / "student_skeleton"
                                             : std::filesystem::path(options.skeleton);
  const ClassSource source = open_class(options.submissions, options.roster);
  std::vector<std::string> notes;
  const SharedCode code = read_for_comparison(
      source.roster, find_submission(skeleton, assignment.submission), options.how, notes);
  const std::vector<SimilarPair> pairs = code.pairs(options.least_percent);
  for (const std::string& note : notes)
    std::cerr << "note: " << printable(note) << "\n";
  print_groups(pairs);
  print_pairs(pairs, options.top);
  if (!options.output.empty()) write_file_safely(options.output, to_csv(pairs));
  if (!options.page.empty())
    write_file_safely(options.page, similarity_page(code, pairs, options.top));
}

}  // namespace

void add_similarity_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SimilarityCommandOptions>();
  CLI::App* command =
      app.add_subcommand("similarity", "Rank pairs of submissions by what they share");
  command
      ->add_option("submissions", options->submissions,
                   "The folder or archive with what was handed in")
      ->required();
  add_roster_options(*command, options->roster);
  command->add_option("--assignment", options->assignment,
                      "Which files count (TOML); the standard one if not given");
  command->add_option("--skeleton", options->skeleton,
                      "What was handed out, and does not count; the students' skeleton if not "
                      "given");
  command->add_option("--top", options->top, "The most pairs to show");
  command->add_option("--least", options->least_percent, "Only from this percentage on")
      ->check(CLI::Range(1, 100));
  add_output_option(*command, "-o,--output", options->output,
                    "Write all pairs to this file (CSV)");
  add_output_option(*command, "--html", options->page,
                    "Write a page with the groups, all pairs, and for those shown both sources "
                    "side by side");
  command->footer(
      "Compares runs of tokens: other names, comments, layout, and another order of functions\n"
      "or files make no difference. What the skeleton has does not count, and what many have\n"
      "counts less. Short exercises have few good solutions: look at the pairs that stand "
      "out,\n"
      "and at their code, before you say anything.\n"
      "Examples:\n"
      "  meshgrade similarity submissions\n"
      "  meshgrade similarity submissions.zip --top 50 -o pairs.csv --html pairs.html\n"
      "Exit code: 0, or 2 for bad usage.");
  command->callback([options, &exit_code] {
    similarity(*options);
    exit_code = 0;
  });
}

}  // namespace meshgrade

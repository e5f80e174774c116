#include "grader/app/similarity_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/app/class_source.h"
#include "grader/app/context.h"
#include "grader/app/output_check.h"
#include "grader/base/csv.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/batch/similarity.h"

namespace meshgrade {
namespace {

struct SimilarityCommandOptions {
  std::string submissions;
  std::string assignment;
  std::string skeleton;
  std::string output;
  RosterOptions roster;
  SimilarityOptions how;
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
void check_files(const SimilarityCommandOptions& options) {
  if (options.output.empty()) return;
  std::vector<std::filesystem::path> inputs{options.submissions,
                                            or_standard_assignment(options.assignment)};
  if (lies_within(options.output, options.submissions)) inputs.emplace_back(options.output);
  check_outputs({{"-o", options.output}}, inputs);
}

void similarity(SimilarityCommandOptions& options) {
  check_files(options);
  const Assignment assignment = load_assignment(options.assignment);
  options.how.rules = assignment.submission;
  const std::filesystem::path skeleton = options.skeleton.empty()
                                             ? source_folder() / "student_skeleton"
                                             : std::filesystem::path(options.skeleton);
  const ClassSource source = open_class(options.submissions, options.roster);
  std::vector<std::string> notes;
  const std::vector<SimilarPair> pairs = find_similar(
      source.roster, find_submission(skeleton, assignment.submission), options.how, notes);
  for (const std::string& note : notes)
    std::cerr << "note: " << printable(note) << "\n";
  for (std::size_t i = 0; i < std::min(options.top, pairs.size()); ++i) {
    const SimilarPair& pair = pairs[i];
    std::cout << pair.of_first << " % of " << pair.first << " is in " << pair.second << ", "
              << pair.of_second << " % the other way round\n";
  }
  std::cout << plural(pairs.size(), "pair") << " with something in common";
  if (pairs.size() > options.top) std::cout << ", the first " << options.top << " are shown";
  std::cout << "\n";
  if (!options.output.empty()) write_file_safely(options.output, to_csv(pairs));
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
  command->add_option("--least", options->how.least_percent, "Only from this percentage on")
      ->check(CLI::Range(1, 100));
  add_output_option(*command, "-o,--output", options->output,
                    "Write all pairs to this file (CSV)");
  command->footer(
      "Needs Debian's similarity-tester. It compares tokens: other names, layout and comments\n"
      "make no difference. Short exercises have few good solutions, so many honest pairs "
      "share\n"
      "much: look at the pairs that stand out, and at their code, before you say anything.\n"
      "Examples:\n"
      "  meshgrade similarity submissions\n"
      "  meshgrade similarity submissions.zip --top 50 -o pairs.csv\n"
      "Exit code: 0, or 2 for bad usage or when the tool is missing.");
  command->callback([options, &exit_code] {
    similarity(*options);
    exit_code = 0;
  });
}

}  // namespace meshgrade

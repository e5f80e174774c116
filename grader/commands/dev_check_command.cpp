#include "grader/commands/dev_check_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/commands/adequacy_check.h"
#include "grader/commands/context.h"
#include "grader/grade/grading.h"
#include "grader/operations/local_operation_list.h"
#include "grader/submission/skeleton_cutter.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

/// Counts what does not agree, and says it.
class Complaints {
 public:
  void add(const std::string& what) {
    std::cout << "  " << what << "\n";
    ++count_;
  }
  std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
};

const SourceFile* find_file(const Submission& submission, const std::string& name) {
  for (const SourceFile& file : submission.sources) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

void compare_skeleton(const Submission& reference, const Submission& skeleton,
                      const fs::path& folder, Complaints& complaints) {
  for (const SourceFile& file : reference.sources) {
    const SourceFile* stub = find_file(skeleton, file.name);
    if (stub == nullptr) {
      complaints.add((folder / file.name).string() + " is missing");
    } else if (stub->text != cut_solution(file.text, file.name)) {
      complaints.add((folder / file.name).string() +
                     " is not the reference without its solution; dev-check --write mends it");
    }
  }
  for (const SourceFile& file : skeleton.sources) {
    if (find_file(reference, file.name) == nullptr) {
      complaints.add((folder / file.name).string() + " has no counterpart in reference/");
    }
  }
}

void write_skeleton(const Submission& reference, const fs::path& folder) {
  for (const SourceFile& file : reference.sources) {
    write_file_safely(folder / file.name, cut_solution(file.text, file.name));
  }
  std::cout << "wrote " << plural(reference.sources.size(), "file") << " to " << folder.string()
            << "\n";
}

void require_full_points(const Report& report, Complaints& complaints) {
  for (const ExerciseReport& exercise : report.exercises) {
    if (exercise.points < exercise.max_points ||
        exercise.extra_points < exercise.max_extra_points) {
      complaints.add("the reference loses points in " + exercise.name);
    }
  }
}

void require_stubs(const Report& report, Complaints& complaints) {
  for (const ExerciseReport& exercise : report.exercises) {
    if (exercise.verdict == Verdict::kNotImplemented && exercise.points == 0.0 &&
        exercise.extra_points == 0.0) {
      continue;
    }
    complaints.add("the stub of " + exercise.name + " is \"" + verdict_name(exercise.verdict) +
                   "\" with " + number_text(exercise.points + exercise.extra_points) +
                   " points");
  }
}

/// Every exercise has its file in every room. What is about one operation is data: cases and
/// judge are made from its file in grader/operations.
void require_files(const Assignment& assignment, const fs::path& source,
                   Complaints& complaints) {
  for (const ExerciseRubric& exercise : assignment.exercises) {
    const std::string file = (fs::path(assignment.folder) / exercise.name).string();
    std::vector<std::string> files{"reference/" + file + ".cpp",
                                   "docs/exercises/" + file + ".md",
                                   "grader/worker/exercises/" + file + ".cpp"};
    if (find_local_operation(exercise.name) != nullptr) {
      files.push_back("grader/operations/" + file + ".cpp");
    } else {
      files.push_back("grader/cases/exercises/" + file + ".cpp");
      files.push_back("grader/judge/exercises/" + file + ".cpp");
    }
    for (const std::string& needed : files) {
      if (!fs::exists(source / needed)) complaints.add(needed + " is missing");
    }
  }
}

void check_assignment(const Assignment& assignment, bool write, Complaints& complaints) {
  const fs::path source = source_folder();
  const fs::path solutions = source / "reference" / assignment.folder;
  const fs::path stubs = source / "student_skeleton" / assignment.folder;
  const Submission reference = find_submission(solutions, assignment.submission);
  if (write) write_skeleton(reference, stubs);
  const Submission skeleton = find_submission(stubs, assignment.submission);
  const Progress silent = [](const std::string&) {};
  std::cout << assignment.title << "\n";
  std::cout << "every exercise has its files\n";
  require_files(assignment, source, complaints);
  std::cout << "the skeleton is the reference without its solutions\n";
  compare_skeleton(reference, skeleton, fs::path("student_skeleton") / assignment.folder,
                   complaints);
  std::cout << "the reference gets every point\n";
  require_full_points(grade(assignment, reference, find_home(), {}, silent), complaints);
  std::cout << "every stub is \"not implemented\"\n";
  require_stubs(grade(assignment, skeleton, find_home(), {}, silent), complaints);
}

int dev_check(bool write) {
  Complaints complaints;
  check_assignment(load_assignment(""), write, complaints);
  for (const std::string& name : named_assignments())
    check_assignment(load_assignment(name), write, complaints);
  std::cout << (complaints.count() == 0 ? "all is well\n"
                                        : plural(complaints.count(), "complaint") + "\n");
  return complaints.count() == 0 ? 0 : 1;
}

struct Options {
  bool write = false;
  bool mutants = false;
  bool mistakes = false;
  AdequacyOptions adequacy;
  std::string page;
};

void add_mutant_options(CLI::App* command, Options& options) {
  CLI::Option* mutants = command->add_flag(
      "--mutants", options.mutants,
      "Prove instead that the grader finds mistakes, and write docs/adequacy.md");
  command
      ->add_option("--sample", options.adequacy.mutants,
                   "Only this many mutants, drawn at random")
      ->needs(mutants);
  command
      ->add_option("--variants", options.adequacy.variants,
                   "How many right variants are drawn (240)")
      ->needs(mutants);
  command->add_option("--seed", options.adequacy.seed, "What all that is drawn depends on")
      ->needs(mutants);
  command
      ->add_option("--assignment", options.adequacy.assignment,
                   "Mutants of another assignment than the standard one")
      ->needs(mutants);
  command->add_option("--only", options.adequacy.exercise, "Only mutants of this exercise")
      ->needs(mutants);
  CLI::Option* survivors = command->add_flag(
      "--survivors", options.adequacy.survivors_only,
      "Only find out which survive, in a third of the time: of the others nothing is said");
  survivors->needs(mutants);
  command
      ->add_option("--page", options.page,
                   "Write the page to this file, however few are graded")
      ->needs(mutants)
      ->excludes(survivors);
  command->add_option("-j,--jobs", options.adequacy.jobs, "How many are graded at a time (2)")
      ->needs(mutants);
}

}  // namespace

void add_dev_check_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "dev-check", "Prove that reference, skeleton and exercises agree (for maintainers)");
  command->add_flag("--write", options->write,
                    "First write the skeleton's files anew from the reference");
  add_mutant_options(command, *options);
  command
      ->add_flag("--mistakes", options->mistakes,
                 "Only write what is said of known mistakes into docs/adequacy.md")
      ->excludes("--mutants");
  command->footer(
      "Examples:\n"
      "  meshgrade dev-check\n"
      "  meshgrade dev-check --write\n"
      "  meshgrade dev-check --mutants --sample 40 --only edge_flip\n"
      "  meshgrade dev-check --mutants --survivors --variants 0 --only edge_split\n"
      "Exit code: 0 all agree, 1 something does not, 2 or 3 an error.");
  command->callback([options, &exit_code] {
    // Single pointers are about what is said.
    if (options->adequacy.survivors_only) options->adequacy.single_pointers = false;
    exit_code = options->mutants    ? check_adequacy(options->adequacy, options->page)
                : options->mistakes ? write_known_mistakes(options->adequacy.jobs)
                                    : dev_check(options->write);
  });
}

}  // namespace meshgrade

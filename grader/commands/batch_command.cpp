#include "grader/commands/batch_command.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "grader/base/digest.h"
#include "grader/base/errors.h"
#include "grader/base/process_self.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/batch/batch.h"
#include "grader/batch/class_results.h"
#include "grader/batch/class_summary.h"
#include "grader/batch/lateness.h"
#include "grader/cluster/task_folder.h"
#include "grader/commands/batch_progress.h"
#include "grader/commands/class_pages.h"
#include "grader/commands/class_source.h"
#include "grader/commands/cluster_batch.h"
#include "grader/commands/context.h"
#include "grader/commands/exit_codes.h"
#include "grader/commands/figure_files.h"
#include "grader/commands/grader_identity.h"
#include "grader/commands/output_check.h"
#include "grader/commands/require_sandbox.h"
#include "grader/exports/exports.h"
#include "grader/grade/grading.h"
#include "grader/report/html_report.h"
#include "grader/report/terminal_report.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr int kSomeUngradable = 1;
constexpr int kInterrupted = 130;

volatile std::sig_atomic_t interrupted = 0;

struct BatchCommandOptions {
  std::string submissions;
  std::string results;
  std::string assignment;
  std::vector<std::string> exercises;
  std::vector<std::string> only;
  std::string only_file;
  ClusterOptions cluster;
  RosterOptions roster;
  unsigned jobs = 0;
  bool force = false;
  bool list = false;
  bool require_sandbox = false;
  bool html = false;
};

/// What is known of the time of a hand-in.
std::string time_text(const HandIn& hand_in, const std::optional<LateRule>& rule) {
  const Lateness lateness = lateness_of(hand_in, rule);
  std::string text = printable(hand_in.submitted_at);
  if (lateness.late) text += std::string(text.empty() ? "" : " ") + "(late)";
  if (!lateness.note.empty()) text += (text.empty() ? "" : ": ") + lateness.note;
  return text;
}

void list_roster(const Roster& roster, const std::optional<LateRule>& rule) {
  std::cout << "layout: " << roster.layout << "\n"
            << plural(roster.hand_ins.size(), "hand-in") << ":\n";
  for (const HandIn& hand_in : roster.hand_ins) {
    std::vector<std::string> people;
    for (const Person& p : hand_in.people) {
      people.push_back(p.id + (p.name.empty() ? "" : " " + p.name) +
                       (p.email.empty() ? "" : " <" + p.email + ">"));
    }
    std::vector<std::string> parts;
    for (const Part& part : hand_in.parts)
      parts.push_back(part.name);
    std::cout << "  " << hand_in.key << "\n    for   " << printable(join(people, ", "))
              << "\n    files " << printable(join(parts, ", ")) << "\n";
    const std::string time = time_text(hand_in, rule);
    if (!time.empty()) std::cout << "    at    " << time << "\n";
  }
  if (roster.left_out.empty()) return;
  std::cout << "left out:\n";
  for (const Omission& left : roster.left_out)
    std::cout << "  " << left.what << ": " << left.why << "\n";
}

/// Beside report.txt, which names the pictures by their way from there.
constexpr const char* kStudentFigures = "figures";

/// The pictures that the student may see, and with `html` the page that shows them; those of an
/// earlier grading go.
void add_student_files(Report& report, const fs::path& folder, bool html) {
  const fs::path pictures = folder / kStudentFigures;
  std::error_code ignored;
  fs::remove_all(pictures, ignored);
  fs::remove(folder / kStudentPage, ignored);
  Report seen = student_view(report);
  if (html) write_file_safely(folder / kStudentPage, to_html(seen, viewer_page()));
  const FigureFolder figures(pictures);
  write_figures(seen, pictures);
  for (std::size_t i = 0; i < report.exercises.size(); ++i) {
    for (std::size_t j = 0; j < report.exercises[i].cases.size(); ++j)
      report.exercises[i].cases[j].figure = seen.exercises[i].cases[j].figure;
  }
}

Grading grading_of(const Assignment& assignment, const BatchCommandOptions& options,
                   const Home& home) {
  Grading grading;
  grading.rules = assignment.submission;
  grading.grade = [&assignment, &options, home](const Submission& submission, unsigned) {
    return grade(assignment, submission, home, options.exercises, [](const std::string&) {});
  };
  grading.add_files = [html = options.html](Report& report, const fs::path& folder) {
    add_student_files(report, folder, html);
  };
  grading.to_text = [](const Report& report) {
    TerminalStyle style;
    style.figures = kStudentFigures;
    return to_terminal(student_view(report), style);
  };
  Digest identity;
  identity.add(grader_identity(home))
      .add(read_whole_file(or_standard_assignment(options.assignment)))
      .add(join(options.exercises, ","))
      .add(assignment.hidden ? std::to_string(assignment.hidden->seed.value_or(0)) : "");
  for (const OwnMesh& mesh : assignment.own_meshes())
    identity.add(mesh.is_there ? read_whole_file(mesh.file) : "");
  grading.identity = identity.hex();
  return grading;
}

void write_class_files(const ClassResults& results, const fs::path& folder) {
  const ClassSummary summary = summarize(results, result_store(folder));
  write_file_safely(folder / kClassFile, to_json(results));
  write_file_safely(folder / "summary.json", to_json(summary));
  write_file_safely(folder / "summary.txt", to_text(summary));
  write_file_safely(folder / "grades.csv", find_class_export("csv")->write(results, {}).text);
}

std::size_t count_status(const ClassResults& results, ResultStatus status) {
  return static_cast<std::size_t>(
      std::count_if(results.rows.begin(), results.rows.end(),
                    [&](const ClassRow& row) { return row.status == status; }));
}

/// Says what there is now, and what to do next.
int conclude(const ClassResults& results, const BatchCommandOptions& options, bool complete) {
  const std::size_t ungradable = count_status(results, ResultStatus::kUngradable);
  const std::size_t errors = count_status(results, ResultStatus::kGraderError);
  const std::size_t missing = count_status(results, ResultStatus::kMissing);
  std::cout << count_status(results, ResultStatus::kGraded) << " of "
            << plural(results.rows.size(), "hand-in") << " graded";
  if (ungradable != 0) std::cout << ", " << ungradable << " ungradable";
  if (errors != 0) std::cout << ", " << plural(errors, "grader error");
  if (missing != 0) std::cout << ", " << missing << " not graded yet";
  std::cout << "\nresults: " << options.results << "\n";
  if (!results.left_out.empty()) {
    std::cout << plural(results.left_out.size(), "thing") << " left out; --list shows why\n";
  }
  if (!complete) {
    std::cout << "stopped; the same command goes on from here\n";
    return kInterrupted;
  }
  if (errors != 0) {
    std::cout << "the same command tries again where the grader failed\n";
    return kGraderFailed;
  }
  return ungradable != 0 ? kSomeUngradable : 0;
}

void catch_interrupts() {
  struct sigaction note {};
  note.sa_handler = [](int) { interrupted = 1; };
  ::sigaction(SIGINT, &note, nullptr);
  ::sigaction(SIGTERM, &note, nullptr);
  ::sigaction(SIGHUP, &note, nullptr);
}

/// Else the results would be taken for somebody's work the next time.
void refuse_results_inside(const fs::path& submissions, const fs::path& results) {
  if (!lies_within(results, submissions)) return;
  throw UserError(results.string() + ": the results must not lie within what was handed in; " +
                  "name a folder elsewhere");
}

std::vector<std::string> chosen_names(const BatchCommandOptions& options) {
  std::vector<std::string> names = options.only;
  if (!options.only_file.empty()) {
    const std::vector<std::string> listed = read_task_list(options.only_file);
    names.insert(names.end(), listed.begin(), listed.end());
  }
  return names;
}

/// How a task of a cluster calls this program.
std::vector<std::string> task_command(const BatchCommandOptions& options) {
  const auto whole = [](const std::string& path) { return fs::absolute(path).string(); };
  std::vector<std::string> words{program_file().string(), "batch", whole(options.submissions)};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--assignment", options.assignment.empty()
                          ? ""
                          : whole(or_standard_assignment(options.assignment).string()));
  for (const std::string& exercise : options.exercises)
    add("--exercise", exercise);
  add("--layout", options.roster.layout);
  add("--part", options.roster.assignment);
  add("--jobs", std::to_string(std::max(1U, options.jobs)));
  if (options.require_sandbox) words.emplace_back("--require-sandbox");
  if (options.html) words.emplace_back("--html");
  return words;
}

int announce_jobs(const ClusterBatch& cluster) {
  const std::size_t count = write_jobs_file(cluster);
  std::cout << cluster.cluster.jobs_file << ": " << plural(count, "command")
            << ", one per line, to be run anywhere that sees the same folders.\n"
            << "When they are done, this command without --jobs-file collects the results.\n";
  return 0;
}

/// On Slurm, all but what needs no grading: that is done here, and quickly.
bool run_divided(const ClusterBatch& cluster) {
  const auto pending =
      pending_hand_ins(cluster.roster, cluster.grading, cluster.folder.store(), cluster.how);
  BatchOptions here = cluster.how;
  here.force = false;
  here.chosen.erase(std::remove_if(here.chosen.begin(), here.chosen.end(),
                                   [&](std::size_t i) {
                                     return pending.count(cluster.roster.hand_ins[i].key) != 0;
                                   }),
                    here.chosen.end());
  return run_batch(cluster.roster, cluster.grading, cluster.folder, here) &&
         run_on_slurm(cluster);
}

unsigned cores() {
  return std::max(1U, std::thread::hardware_concurrency());
}

unsigned jobs_of(const BatchCommandOptions& options) {
  return options.jobs != 0 ? options.jobs : options.cluster.slurm ? 1 : cores();
}

int grade_class(const BatchCommandOptions& options, const Assignment& assignment,
                const Roster& roster, const BatchFolder& folder) {
  Home home = find_home();
  home.cores = std::max(1U, cores() / jobs_of(options));
  if (options.require_sandbox) require_sandbox(home.sandbox);
  const Grading grading = grading_of(assignment, options, home);
  BatchOptions how;
  how.jobs = jobs_of(options);
  how.force = options.force;
  how.chosen = choose_hand_ins(roster, chosen_names(options));
  BatchProgress progress(roster, how.chosen.size(), ::isatty(STDERR_FILENO) != 0);
  how.progress = [&](const BatchStep& step) { progress.show(step); };
  how.stop = [] { return interrupted != 0; };
  catch_interrupts();
  const ClusterBatch cluster{roster, grading,         folder,
                             how,    options.cluster, task_command(options)};
  if (!options.force) collect_finished_tasks(cluster);
  if (!options.cluster.jobs_file.empty()) return announce_jobs(cluster);
  const bool complete =
      options.cluster.slurm ? run_divided(cluster) : run_batch(roster, grading, folder, how);
  progress.finish();
  if (progress.again() != 0) {
    std::cout << plural(progress.again(), "hand-in")
              << " graded once more after an error of the grader\n";
  }
  const ClassResults results =
      collect_results(roster, assignment, options.exercises, folder.store(),
                      read_late_rule(or_standard_assignment(options.assignment)));
  write_class_files(results, folder.path());
  if (options.html) {
    if (::isatty(STDERR_FILENO) != 0) std::cerr << "comparing the hand-ins with each other\n";
    write_class_pages(results, write_similar_page(roster, assignment, folder.path()),
                      folder.path());
  }
  return conclude(results, options, complete);
}

std::vector<SubmissionTaker> takers_of(const Roster& roster) {
  std::vector<SubmissionTaker> hand_ins;
  for (const HandIn& hand_in : roster.hand_ins)
    hand_ins.emplace_back([&hand_in] { return take_submission(hand_in, SubmissionRules()); });
  return hand_ins;
}

/// Says which assignment the hand-ins are about, if it is not the standard one.
std::string recognised_for(const BatchCommandOptions& options,
                           const std::vector<SubmissionTaker>& hand_ins) {
  std::string name = recognise_assignment(options.assignment, hand_ins);
  if (options.assignment.empty() && !name.empty())
    std::cout << "recognised: --assignment " << name << "\n";
  return name;
}

int batch(BatchCommandOptions options) {
  if (!options.assignment.empty()) load_assignment(options.assignment);  // before any work
  std::optional<BatchFolder> folder;
  if (!options.list) {
    if (options.results.empty()) throw UserError("name a folder for the results: -o RESULTS");
    refuse_results_inside(options.submissions, options.results);
    folder.emplace(options.results);
  }
  if (options.cluster.wanted() && !fs::is_directory(options.submissions)) {
    throw UserError(options.submissions +
                    ": for a cluster it must be a folder that all its machines see; unpack it "
                    "first");
  }
  const ClassSource source = open_class(options.submissions, options.roster);
  const std::vector<SubmissionTaker> hand_ins = takers_of(source.roster);
  options.assignment = recognised_for(options, hand_ins);
  const Assignment assignment =
      as_class_is_asked(load_assignment(options.assignment), hand_ins);
  choose_exercises(assignment, options.exercises);
  require_hidden_seed(assignment);
  if (folder) return grade_class(options, assignment, source.roster, *folder);
  list_roster(source.roster, read_late_rule(or_standard_assignment(options.assignment)));
  return 0;
}

void add_options(CLI::App& command, BatchCommandOptions& options) {
  command
      .add_option("submissions", options.submissions,
                  "The folder or archive with what was handed in")
      ->required();
  command.add_option("-o,--output", options.results,
                     "The folder for the results; nothing is written elsewhere");
  command.add_option(
      "--assignment", options.assignment,
      "What is asked and what it is worth (TOML); if not given, what the hand-ins are about");
  command.add_option("--exercise", options.exercises, "Only this exercise; may be repeated");
  add_roster_options(command, options.roster);
  command.add_flag("--list", options.list,
                   "Only show what is there, for whom, and what is left out and why");
  command.add_option("--only", options.only,
                     "Only the hand-in of this person; may be repeated");
  command.add_option("--only-file", options.only_file,
                     "The same from a file with one name per line");
  command.add_flag("--html", options.html,
                   "Also write class.html, a page for each student's report, and similar.html");
  command.add_flag("--force", options.force, "Grade again what has not changed");
  command.add_flag("--require-sandbox", options.require_sandbox, kRequireSandboxHelp);
  command.add_option("-j,--jobs", options.jobs,
                     "How many at a time; all cores if not given, one per task on a cluster");
  command.add_flag("--slurm", options.cluster.slurm,
                   "Grade by an array job of the Slurm cluster that this machine belongs to");
  command.add_option("--sbatch", options.cluster.sbatch,
                     "An option for sbatch, such as --partition=long; may be repeated");
  command
      .add_option("--per-task", options.cluster.per_task,
                  "How many hand-ins a task of a cluster grades (16)")
      ->check(CLI::Range(1, 100'000));
  command.add_option("--jobs-file", options.cluster.jobs_file,
                     "Only write the commands for another scheduler to this file");
}

}  // namespace

void add_batch_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<BatchCommandOptions>();
  CLI::App* command = app.add_subcommand("batch", "Grade a whole class");
  add_options(*command, *options);
  command->footer(
      "Examples:\n"
      "  meshgrade batch submissions --list\n"
      "  meshgrade batch submissions -o results --require-sandbox\n"
      "  meshgrade batch submissions -o results --only alice --force\n"
      "  meshgrade batch submissions -o results --slurm --sbatch=--partition=long\n"
      "  meshgrade batch submissions -o results --jobs-file jobs.txt && parallel < jobs.txt\n"
      "Each result is stored as soon as it is there. However a batch is stopped, the same\n"
      "command goes on where it was; what has not changed is not graded again.\n"
      "Exit code: 0 all are graded, whatever their points, 1 some cannot be graded, 2 bad "
      "usage\n"
      "or unreadable input, 3 an error of the grader, 130 stopped by Ctrl-C or TERM.");
  command->callback([options, &exit_code] { exit_code = batch(*options); });
}

}  // namespace meshgrade

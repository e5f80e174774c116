#include "grader/commands/export_command.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/batch/batch.h"
#include "grader/commands/export_target.h"
#include "grader/commands/output_check.h"
#include "grader/exports/exports.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

struct ExportCommandOptions {
  std::string results;
  std::string format;
  std::string output;
  std::string gradebook;
  std::optional<double> out_of;
  ExportOptions how;
  bool no_extra_credit = false;
  bool feedback = false;
};

/// What each hand-in is told in short, where the gradebook has room for it.
std::map<std::string, std::string> make_feedback(const ClassResults& results,
                                                 const std::string& folder) {
  std::map<std::string, std::string> feedback;
  const ResultStore store = result_store(folder);
  for (const ClassRow& row : results.rows) {
    Result result = store.load(row.key);
    if (result.report) result.report = student_view(std::move(*result.report));
    feedback[row.key] = feedback_html(row, results, result.report ? &*result.report : nullptr);
  }
  return feedback;
}

/// What is read: the gradebook, and the results themselves.
std::vector<fs::path> inputs_of(const ExportCommandOptions& options) {
  std::vector<fs::path> inputs{options.gradebook};
  std::error_code error;
  for (fs::directory_iterator it(options.results, error), end; !error && it != end;
       it.increment(error)) {
    inputs.push_back(it->path());
  }
  return inputs;
}

void export_class(const ClassExport& format, const ClassResults& results,
                  const ExportCommandOptions& options) {
  fs::path file = options.output;
  if (file.empty()) {
    file = fs::path(options.results) / "exports" / format.file;
    make_folder(file.parent_path());
  }
  check_outputs({{"-o", file}}, inputs_of(options));
  const Exported exported = format.write(results, options.how);
  write_file_safely(file, exported.text);
  for (const std::string& note : exported.notes)
    std::cerr << "note: " << printable(note) << "\n";
  std::cout << "wrote " << file.string() << "\n";
}

/// One file for each student, in a folder of the format.
void export_students(const StudentExport& format, const ClassResults& results,
                     const ExportCommandOptions& options) {
  const fs::path folder = options.output.empty()
                              ? fs::path(options.results) / "exports" / format.name
                              : fs::path(options.output);
  const ResultStore store = result_store(options.results);
  for (const ClassRow& row : results.rows) {
    Result result = store.load(row.key);
    if (result.report) result.report = student_view(std::move(*result.report));
    const Report* report = result.report ? &*result.report : nullptr;
    const fs::path own = folder / safe_file_name(row.key);
    make_folder(own);
    write_file_safely(
        own / format.file,
        format.write({row.key, result.status, result.reason, report}, options.how));
  }
  std::cout << "wrote " << plural(results.rows.size(), "file") << " to " << folder.string()
            << "\n";
}

/// An option that a format cannot follow would be missed only in the gradebook.
void check_options(const ExportCommandOptions& options, bool for_gradebook) {
  if (options.out_of && !(std::isfinite(*options.out_of) && *options.out_of > 0.0)) {
    throw UserError("--out-of: full points must be worth more than 0 there, and came " +
                    number_text(*options.out_of));
  }
  if (options.feedback && options.format != "moodle") {
    throw UserError(options.format + " takes no --feedback: it is for moodle");
  }
  if (!options.how.feedback_column.empty() && !options.feedback) {
    throw UserError("--feedback-column says where, but --feedback is missing");
  }
  if (for_gradebook) return;
  const std::pair<const char*, bool> given[] = {{"--gradebook", !options.gradebook.empty()},
                                                {"--column", !options.how.column.empty()},
                                                {"--out-of", options.out_of.has_value()}};
  for (const auto& [option, is_given] : given) {
    if (is_given) {
      throw UserError(options.format + " takes no " + option + ": it is for " +
                      join(gradebook_formats(), " and "));
    }
  }
}

void run_export(ExportCommandOptions& options) {
  const ClassExport* of_class = find_class_export(options.format);
  const StudentExport* of_student = find_student_export(options.format);
  if (of_class == nullptr && of_student == nullptr) {
    throw UserError("there is no format \"" + options.format + "\"; there are " +
                    join(export_names(), ", "));
  }
  check_options(options, of_class != nullptr && of_class->for_gradebook);
  const ClassResults results = load_class_results(options.results);
  options.how.out_of = options.out_of.value_or(0.0);
  options.how.extra_credit = !options.no_extra_credit;
  options.how.time = time_of_export();
  if (options.feedback) options.how.feedback = make_feedback(results, options.results);
  if (!options.gradebook.empty()) options.how.gradebook = read_whole_file(options.gradebook);
  if (of_class != nullptr) {
    export_class(*of_class, results, options);
  } else {
    export_students(*of_student, results, options);
  }
}

std::string format_list() {
  std::string text = "Formats for a class, one file:\n";
  const auto line = [](const std::string& name, const std::string& title) {
    return "  " + name + std::string(name.size() < 20 ? 20 - name.size() : 1, ' ') + title +
           "\n";
  };
  for (const ClassExport& known : class_exports())
    text += line(known.name, known.title);
  text += "Formats with a file for each student:\n";
  for (const StudentExport& known : student_exports())
    text += line(known.name, known.title);
  return text;
}

}  // namespace

void add_export_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ExportCommandOptions>();
  CLI::App* command =
      app.add_subcommand("export", "Write the results of a batch for a gradebook");
  command->add_option("results", options->results, "The folder of `meshgrade batch -o`")
      ->required();
  command->add_option("format", options->format, "One of those below")->required();
  add_output_option(*command, "-o,--output", options->output,
                    "The file, or the folder for the students' files; RESULTS/exports/... if "
                    "not given");
  command->add_option(
      "--gradebook", options->gradebook,
      "The file downloaded from the platform, to be filled in (canvas, moodle)");
  command->add_option("--column", options->how.column,
                      "The assignment's column in the gradebook (canvas, moodle)");
  command->add_option("--out-of", options->out_of,
                      "What full points are worth there: all points are scaled to it (canvas, "
                      "moodle)");
  command->add_flag("--no-extra-credit", options->no_extra_credit, "Leave out extra credit");
  command->add_flag("--feedback", options->feedback,
                    "Also write each student's report in short into the comments (moodle)");
  command->add_option("--feedback-column", options->how.feedback_column,
                      "What the column of the comments is called, if not \"Feedback "
                      "comments\" (moodle)");
  command->footer(
      format_list() +
      "Examples:\n"
      "  meshgrade export results canvas --gradebook Grades.csv --column \"Homework 2\"\n"
      "  meshgrade export results moodle --gradebook worksheet.csv --feedback -o upload.csv\n"
      "  meshgrade export results gradescope\n"
      "Exit code: 0, or 2 for bad usage or a gradebook of another form.");
  command->callback([options, &exit_code] {
    run_export(*options);
    exit_code = 0;
  });
}

}  // namespace meshgrade

#include "grader/commands/writeup_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/base/errors.h"
#include "grader/base/safe_file.h"
#include "grader/base/text.h"
#include "grader/commands/console.h"
#include "grader/commands/context.h"
#include "grader/commands/grading_options.h"
#include "grader/commands/output_check.h"
#include "grader/view/browser.h"
#include "grader/writeup/writeup.h"

namespace meshgrade {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMarkdownFile = "writeup.md";
constexpr const char* kHtmlFile = "writeup.html";

struct WriteupOptions {
  std::string submission;
  std::string folder;
  std::string rubric;
  std::string assignment;
  bool again = false;
  bool svg = false;
  bool no_cache = false;
};

/// Before any work: the student's words are not written over, nor is the homework.
void require_free(const WriteupOptions& options) {
  const fs::path folder = options.folder;
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw UserError(folder.string() + ": is no folder");
  }
  if (lies_within(folder, options.submission)) {
    throw UserError(folder.string() + ": lies in the submission; name a folder elsewhere");
  }
  if (options.again) return;
  for (const char* name : {kMarkdownFile, kHtmlFile, kWriteupPictures}) {
    if (!fs::exists(folder / name, error)) continue;
    throw UserError((folder / name).string() +
                    ": is there already. --again makes the pictures anew and leaves the texts "
                    "as they are; or name another folder");
  }
}

void say_of(const WriteupPicture& picture) {
  std::cout << picture.file << (picture.told.empty() ? "" : "  (shows what goes wrong)") << "\n"
            << std::flush;
}

/// What is not there yet is written; what the student may have written in stays.
void write_texts(const Writeup& writeup, const fs::path& folder) {
  const std::pair<const char*, std::string> texts[] = {{kMarkdownFile, to_markdown(writeup)},
                                                       {kHtmlFile, to_html(writeup)}};
  for (const auto& [name, text] : texts) {
    std::error_code error;
    const bool is_there = fs::exists(folder / name, error);
    if (!is_there) write_file_safely(folder / name, text);
    std::cout << (folder / name).string() << (is_there ? " is as it was" : "") << "\n";
  }
}

int write_up(const WriteupOptions& options) {
  require_free(options);
  const Home home = find_home({!options.no_cache});
  const Assignment assignment = load_assignment(options.assignment);
  const fs::path rubric_file = options.rubric.empty()
                                   ? source_folder() / "docs" / "writeup_rubric.toml"
                                   : fs::path(options.rubric);
  const WriteupRubric rubric = read_rubric(rubric_file, home.meshes, view_verbs(assignment));
  StudentProgram program(assignment, home, options.submission);
  const Progress progress = terminal_progress();
  progress("compiling");
  program.rebuild();
  progress("");
  for (const BuiltFile& file : program.files()) {
    if (!file.ok) std::cerr << file.name << " does not compile:\n" << file.messages << "\n";
  }
  if (!options.svg && find_browser().empty()) {
    std::cout << "There is no Chromium or Chrome: all pictures come as SVG.\n";
  }
  const WriteupSetup setup{options.folder, viewer_page(), options.svg};
  make_folder(setup.folder / kWriteupPictures);
  const Writeup writeup = make_writeup(rubric, program, setup, say_of);
  write_texts(writeup, setup.folder);
  return is_right(writeup) ? 0 : 1;
}

}  // namespace

void add_writeup_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<WriteupOptions>();
  CLI::App* command = app.add_subcommand(
      "writeup", "Make the pictures of a write-up by your functions, with room for your words");
  command
      ->add_option("submission", options->submission,
                   "The folder with the C++ files, or one file")
      ->required();
  command
      ->add_option("-o,--output", options->folder,
                   "The folder for writeup.md, writeup.html and the pictures")
      ->required();
  command->add_option("--rubric", options->rubric,
                      "What is asked for (TOML, as docs/writeup_rubric.toml, which is taken if "
                      "none is given)");
  command->add_option("--assignment", options->assignment,
                      "The assignment (TOML); the standard one if not given");
  command->add_flag("--again", options->again,
                    "Make the pictures anew; writeup.md and writeup.html stay as they are");
  command->add_flag("--svg", options->svg, "Draw SVG pictures even where there is a browser");
  add_cache_option(*command, options->no_cache);
  command->footer(
      "A step that fails is shown as it fails, with what is wrong. Nothing that is there is\n"
      "written over, unless you say --again: then the pictures are.\n"
      "Examples:\n"
      "  meshgrade writeup my_homework -o my_writeup\n"
      "  meshgrade writeup my_homework -o my_writeup --again\n"
      "  meshgrade writeup my_homework -o my_writeup --rubric our_course.toml --svg\n"
      "Exit code: 0 all is there and right, 1 all is there and some pictures show what goes\n"
      "wrong, 2 bad usage or an unreadable file, 3 an error of the grader.");
  command->callback([options, &exit_code] { exit_code = write_up(*options); });
}

}  // namespace meshgrade

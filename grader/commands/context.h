#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/build/home.h"
#include "grader/package/program_files.h"
#include "grader/submission/submission.h"

namespace meshgrade {

struct HomeOptions {
  bool keeps_work = false;  ///< for submissions that are checked again and again (kept_work.h)
  std::shared_ptr<StageTimes> times = nullptr;  ///< where to say how long what took
};

/// Where this program's own files are. The first call of an installed program makes its kit
/// ready (installed_home.h), which takes some seconds.
Home find_home(const HomeOptions& options = {});

/// The folder that holds include/, meshes/, docs/ and the others: $MESHGRADE_HOME, else that of
/// an installed program, else the one that this program was built from.
std::filesystem::path source_folder();

/// The running program, to be put into a package.
ProgramFiles program_files();

/// Whether the sources that a package could build it from are here.
bool has_sources();

/// The page of the viewer, without data.
/// @throws GraderError if it cannot be read
std::string viewer_page();

/// The assignment that is taken when none is named.
std::filesystem::path standard_assignment();

/// The file that was named, or that of an assignment of this name, or the standard assignment.
/// @throws UserError if a bare name is that of no file and no assignment
std::filesystem::path or_standard_assignment(const std::string& file);

/// The assignments that come along besides the standard one, by their names.
std::vector<std::string> named_assignments();

/// The file that was named, or the standard assignment, read. Its exercises and their options
/// exist, and its meshes suit them.
/// @throws UserError that names the file, the line and the key
Assignment load_assignment(const std::string& file);

/// Takes a submission. @throws UserError if there is nothing to grade
using SubmissionTaker = std::function<Submission()>;

/// The assignment that is named; where none is, the name of one of which these submissions
/// define functions. Empty, which is the standard one, if one of them defines a function of
/// that, or none of them any: only as many are taken as it needs to know.
std::string recognise_assignment(const std::string& named,
                                 const std::vector<SubmissionTaker>& submissions);

/// The same of one submission, loaded.
Assignment load_assignment_of(const std::string& named,
                              const std::filesystem::path& submission);

/// What of an assignment a class is asked: where all of it work on Scotty3D of Fall 2020 to
/// Spring 2022, what these years had.
Assignment as_class_is_asked(Assignment assignment,
                             const std::vector<SubmissionTaker>& submissions);

/// What counts must not be graded without the cases that it is to be graded by.
/// @throws UserError if the assignment has hidden cases whose seed or mesh is not there
void require_hidden_seed(const Assignment& assignment);

}  // namespace meshgrade

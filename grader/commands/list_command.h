#pragma once

#include <cstdint>
#include <string>

#include "grader/assignment/assignment.h"
#include "grader/commands/progress_store.h"

namespace CLI {
class App;
}

namespace meshgrade {

/// `meshgrade list [SUBMISSION]`
void add_list_command(CLI::App& app, int& exit_code);

/// The table of exercises: points and verdict of the last check, when that was, hints used.
/// `now` in seconds since 1970.
std::string progress_table(const Assignment& assignment, const SubmissionProgress& progress,
                           std::int64_t now);

}  // namespace meshgrade

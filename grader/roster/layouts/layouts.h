#pragma once

// Each layout has a file of its own beside this one; roster.cpp lists them in order.

#include "grader/roster/roster.h"

namespace meshgrade {

Layout autolab_layout();
Layout canvas_layout();
Layout github_classroom_layout();
Layout gradescope_layout();
Layout moodle_layout();
Layout nbgrader_layout();
Layout plain_layout();

/// The hand-in of this key, added for this person if it is not there yet.
HandIn& find_or_add(Roster& roster, const std::string& key, const Person& person);

/// Whether at least half of the names of a folder match, and one at least.
bool most_names_match(const std::filesystem::path& folder,
                      bool (*matches)(const std::string& name));

}  // namespace meshgrade

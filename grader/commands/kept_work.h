#pragma once

#include "grader/base/kept_files.h"
#include "grader/build/home.h"

namespace meshgrade {

/// Of the person who runs this: $XDG_CACHE_HOME/meshgrade or ~/.cache/meshgrade, for root
/// /var/cache/meshgrade, whose home is closed to the users that submissions run as. Empty if
/// there is no home folder.
std::filesystem::path cache_folder();

/// Lets a home keep what is compiled and what comes of cases, so that functions that have not
/// changed since the last check are neither compiled nor run again. Does nothing where nothing
/// can be kept, or where a submission could write to what is kept.
void keep_work(Home& home);

/// Where it is kept and how much there is, for people; or why nothing is kept.
std::string kept_work_text(const Home& home);

}  // namespace meshgrade

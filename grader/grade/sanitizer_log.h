#pragma once

#include <string>

#include "grader/build/build.h"
#include "grader/report/report.h"

namespace meshgrade {

/// Tells the sanitizers, by environment variables that the worker inherits, to stop at the
/// first mistake and to write what they say next to the worker.
void set_up_sanitizers(const Build& build);

/// What the sanitizers wrote in the last run, cleaned; empty if they found nothing.
std::string read_sanitizer_log(const Build& build);

/// A sanitizer's report without addresses, process numbers and the frames of the stack that are
/// not in the student's files.
std::string clean_sanitizer_log(const std::string& log);

/// The case with the log's first line as its one finding: the process was ended, so that what
/// else was judged is only the echo.
CaseReport with_sanitizer_finding(CaseReport judged, const std::string& log);

}  // namespace meshgrade

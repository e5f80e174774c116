#pragma once

#include <vector>

#include "grader/submission/submission.h"

namespace meshgrade {

/// The graded functions that a homework for Berkeley's skeleton defines in the course's own
/// headers, in their class or behind it, where the grader has headers of its own: a source for
/// each header that holds any, with every function on the lines where it stood. "bezierPatch.h"
/// becomes "bezierPatch.h.cpp".
/// @param own  the student's own files; what is defined there is not taken a second time
std::vector<SourceFile> sources_from_headers(const std::vector<SourceFile>& course_headers,
                                             const std::vector<SourceFile>& own);

}  // namespace meshgrade

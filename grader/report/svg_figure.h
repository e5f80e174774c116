#pragma once

#include <string>

#include "grader/report/report.h"

namespace meshgrade {

/// The finding of a case that there is a picture of; nullptr if there is none.
const Finding* pictured_finding(const CaseReport& report);

/// An SVG picture of what is wrong in a case; empty if there is nothing to draw: flips and
/// splits, and operations on polygons, show before, yours and expected, Loop subdivision the
/// mesh with its wrong vertices.
///
/// It is a whole document that can also stand inside an HTML page: no style sheet, no script, a
/// ground of its own, and only the ids `<id>-title` and `<id>-desc`. The description tells in
/// words all that is drawn.
///
/// @param id  letters, digits, "_" and "-"; no other picture of the page may have the same
std::string to_svg(const CaseReport& report, const std::string& id);

}  // namespace meshgrade

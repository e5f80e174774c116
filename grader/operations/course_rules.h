#pragma once

// What a course asks of operations. Where it has no rule, whoever refuses is right as well.

#include <string>
#include <vector>

#include "grader/operations/local_operation.h"

namespace meshgrade {

enum class CourseRules {
  kAll,           ///< ours: every element, also at a boundary
  kScotty3d2020,  ///< Scotty3D until Spring 2022: meshes without boundary, splits of triangles
};

/// The option of an exercise that names them, and its values, in the order above.
constexpr const char* kRulesOption = "rules";
std::vector<std::string> rules_choices();

/// The answer as the course asks for it: one that must be given may be refused where the course
/// has no rule, and where its words allow other results, too, any mesh will do.
/// @param answer  that of the operation, to the same question
Answer as_asked(CourseRules rules, const LocalOperation& operation, const FaceLists& before,
                const Picked& picked, Answer answer);

}  // namespace meshgrade

#pragma once

#include <nlohmann/json_fwd.hpp>

#include "grader/view/student_program.h"

namespace meshgrade {

/// The student's curve: from `points` ([[x, y], ...], 2 to 40 of them) and `t`, the `levels` of
/// de Casteljau's algorithm by the student's function, the `curve` by it at evenly spaced
/// parameters (null where it gave no point), the `exact` one, and what the judge has `told` of
/// the levels.
/// @throws UserError if there are no such points
nlohmann::ordered_json view_curve(const StudentProgram& program,
                                  const nlohmann::ordered_json& request);

/// The student's surface: from `net` (rows of [x, y, z]) and `density`, the `grid` of
/// (density + 1)^2 points by the student's evaluate, u running fastest, and what the judge has
/// `told`.
/// @throws UserError if there is no such net
nlohmann::ordered_json view_patch(const StudentProgram& program,
                                  const nlohmann::ordered_json& request);

/// Two curves on the student's surface: from `net`, `u` and `v`, `along_u` at this v and
/// `along_v` at this u, each of evenly spaced points by the student's evaluate, as many as it
/// came to.
/// @throws UserError if there is no such net or point of it
nlohmann::ordered_json view_isocurves(const StudentProgram& program,
                                      const nlohmann::ordered_json& request);

}  // namespace meshgrade

#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "grader/mesh/bezier_data.h"
#include "grader/view/student_program.h"

namespace meshgrade {

/// What the student's function makes of a curve.
struct CurveLook {
  std::vector<Point2> points;               ///< the control points
  double t = 0.5;                           ///< where the levels are
  std::vector<std::vector<Point2>> levels;  ///< of de Casteljau's algorithm, as far as it came
  std::vector<std::optional<Point2>>
      curve;                  ///< at evenly spaced parameters, where it came to one
  std::vector<Point2> exact;  ///< the same by Bernstein's polynomials
  CaseReport told;            ///< what the judge says of the levels
};

/// @throws UserError unless there are 2 to 40 finite points and 0 <= t <= 1
CurveLook look_at_curve(const StudentProgram& program, const std::vector<Point2>& points,
                        double t);

/// What the student's evaluate makes of a surface.
struct PatchLook {
  int density = 0;  ///< (density + 1)^2 points, u running fastest
  std::vector<std::vector<std::optional<Point3>>> grids;  ///< of each patch
  CaseReport told;  ///< what the judge says of the first patch that is wrong
};

/// @param density  how often a surface is sampled along each side, 1 to 64
/// @throws UserError unless each net has 2 to 40 rows and columns
PatchLook look_at_patches(const StudentProgram& program, const std::vector<ControlNet>& nets,
                          int density);

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

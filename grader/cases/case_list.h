#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/base/random.h"
#include "grader/base/wire.h"
#include "grader/cases/case.h"
#include "grader/mesh/bezier_data.h"
#include "grader/mesh/polygon_mesh.h"

namespace meshgrade {

/// What an exercise makes its cases with. Cases of groups that the assignment does not name
/// are left out.
class CaseMaker {
 public:
  CaseMaker(const Assignment& assignment, const ExerciseRubric& rubric,
            std::filesystem::path meshes)
      : assignment_(assignment), rubric_(rubric), meshes_(std::move(meshes)) {}

  /// Adds a case. `input` is packed for the worker; `calls` is that of Case.
  template <class Input>
  void add(const std::string& group, const std::string& title, std::uint64_t step_budget,
           const Input& input, std::vector<std::string> calls = {}) {
    add_packed(group, title, step_budget, to_wire(input), false, std::move(calls));
  }

  /// Adds a case that is run in a process in which nothing was called before: what a function
  /// does wrong at its second or third call is wrong there, too.
  template <class Input>
  void add_fresh(const std::string& group, const std::string& title, std::uint64_t step_budget,
                 const Input& input, std::vector<std::string> calls = {}) {
    add_packed(group, title, step_budget, to_wire(input), true, std::move(calls));
  }

  /// A mesh file of the meshes folder, its vertices in build order.
  /// @throws UserError if it cannot be read
  PolygonMesh mesh(const std::string& file) const;
  std::vector<ControlNet> patches(const std::string& file) const;
  std::vector<Point2> curve(const std::string& file) const;

  const ExerciseRubric& rubric() const { return rubric_; }

  /// Random numbers of this exercise; each purpose has a stream of its own.
  Random random(const std::string& purpose) const {
    return {assignment_.seed, rubric_.name + "/" + purpose};
  }

  std::vector<Case> take() { return std::move(cases_); }

 private:
  void add_packed(const std::string& group, const std::string& title, std::uint64_t step_budget,
                  std::string input, bool fresh, std::vector<std::string> calls);

  const Assignment& assignment_;
  const ExerciseRubric& rubric_;
  std::filesystem::path meshes_;
  mutable std::map<std::string, PolygonMesh> read_;  ///< many cases begin with the same file
  std::vector<Case> cases_;
};

/// The cases of one exercise of the assignment, in a fixed order, those that are handed out
/// before the hidden ones. Two calls give the same bytes.
/// @throws UserError if the exercise or one of its groups does not exist, or a mesh file cannot
///         be read
std::vector<Case> make_cases(const Assignment& assignment, const ExerciseRubric& rubric,
                             const std::filesystem::path& meshes);

/// Smaller questions of the same kind as a case that failed, those to prefer first; none when
/// it is small already. All have its group and number.
/// @throws UserError as make_cases does
std::vector<Case> make_smaller_cases(const Assignment& assignment, const ExerciseRubric& rubric,
                                     const std::filesystem::path& meshes, const Case& failed);

/// A case by its id, "edge_split:boundary/7".
/// @throws UserError if there is none
Case find_case(const Assignment& assignment, const std::filesystem::path& meshes,
               const std::string& id);

}  // namespace meshgrade

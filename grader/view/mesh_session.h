#pragma once

// What the viewer shows of a mesh: a list of operations, and the states that the student's
// functions made of it.
//
// Theory of operation. The worker knows no state: it gets the first mesh and all operations up
// to the one that is looked at, and runs them again. So a new program after a save shows what
// it makes of the same operations, and what a crash leaves behind in memory does not matter.

#include <optional>
#include <string>
#include <vector>

#include "grader/view/step_judge.h"
#include "grader/view/student_program.h"
#include "grader/view/view_verbs.h"

namespace meshgrade {

/// The mesh after an operation.
struct ViewState {
  MeshDump mesh;
  CaseReport told;      ///< what the judge says of the step, and what the code printed
  Deviation deviation;  ///< of a subdivision that has the right connectivity; else empty
  /// What the step began with, where that is not the state before: the same, built anew.
  std::optional<MeshDump> begun_with = std::nullopt;
};

/// A level of subdivision among the states of a session.
struct ViewLevel {
  std::string label;         ///< "level 2"
  std::size_t position = 0;  ///< of its last state
};

/// An operation that did not come to its end.
struct StoppedStep {
  ViewOperation operation;
  CaseReport told;
  std::optional<MeshDump> mesh;  ///< as it was at that moment, where that is known
};

class MeshSession {
 public:
  explicit MeshSession(StudentProgram& program);

  /// Begins anew with another mesh. `notes` is what there was to say when it was read.
  /// @throws UserError if half-edges cannot be made of it
  void open(const std::string& name, const PolygonMesh& mesh,
            std::vector<std::string> notes = {});

  /// Compiles the submission again and repeats all operations, also one that was stopped. If a
  /// file does not compile, the program before goes on, and the messages are kept.
  void rebuild();

  /// Runs an operation after the state that is looked at; what was undone is forgotten.
  /// @throws UserError if there is no such element, or no mesh to begin with
  void apply(const ViewOperation& operation);

  /// Goes to the state after so many operations.
  /// @throws UserError if there is none
  void go_to(std::size_t position);

  /// The student's normals of the live vertices of the state that is looked at, or why there
  /// are none.
  struct Normals {
    std::vector<Point3> normals;
    CaseReport told;
  };
  Normals normals() const;

  /// The same by the numbers of the vertices, not finite for those that are deleted.
  std::vector<Point3> normals_by_number(const Normals& asked) const;

  const std::string& name() const { return name_; }
  const std::vector<std::string>& notes() const { return notes_; }
  const StudentProgram& program() const { return program_; }
  const std::vector<ViewVerb>& verbs() const { return verbs_; }
  const std::vector<ViewOperation>& operations() const { return operations_; }
  /// One more than operations that came to their end: the first is the mesh as it was opened.
  const std::vector<ViewState>& states() const { return states_; }
  std::size_t position() const { return position_; }
  /// What the step to a state began with.
  /// @param position  not 0
  const MeshDump& mesh_before(std::size_t position) const;
  const std::optional<StoppedStep>& stopped() const { return stopped_; }
  /// The last state of each level, up to the state that is looked at.
  std::vector<ViewLevel> levels() const;

 private:
  Outcome run(const std::vector<ViewOperation>& operations, std::size_t first_told,
              bool with_normals) const;
  void extend(const std::vector<ViewOperation>& operations);
  void take_steps(const std::vector<ViewOperation>& operations, const Outcome& outcome);
  void take_step(const ViewOperation& operation, const Outcome& outcome,
                 const std::string& bytes);
  void stop_at(const ViewOperation& operation, const Outcome& outcome);

  StudentProgram& program_;
  std::vector<ViewVerb> verbs_;
  std::string name_;
  std::vector<std::string> notes_;
  PolygonMesh start_;
  std::vector<ViewOperation> operations_;
  std::vector<ViewState> states_;
  std::size_t position_ = 0;
  std::optional<StoppedStep> stopped_;
};

}  // namespace meshgrade

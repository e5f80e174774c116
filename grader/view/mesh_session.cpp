#include "grader/view/mesh_session.h"

#include <algorithm>
#include <limits>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/judge/library_check.h"
#include "grader/mesh/build_mesh.h"
#include "grader/mesh/dump_mesh.h"

namespace meshgrade {
namespace {

/// Far more than any good solution needs, and little enough that an endless walk is told at
/// once.
std::uint64_t step_budget(const PolygonMesh& mesh,
                          const std::vector<ViewOperation>& operations) {
  std::uint64_t faces = 100;
  for (const auto& corners : mesh.polygons)
    faces += std::max<std::size_t>(corners.size(), 3) - 2;
  std::uint64_t budget = 0;
  for (const ViewOperation& operation : operations) {
    if (subdivides(operation)) faces *= 4;
    budget += 2000 + 1000 * faces;
  }
  return budget + 1000 * faces;
}

MeshDump first_state(const PolygonMesh& polygons) {
  meshedit::HalfedgeMesh mesh;
  try {
    build_mesh(polygons, mesh);
  } catch (const meshedit::MeshError& error) {
    throw UserError(std::string("half-edges cannot be made of this mesh: ") + error.what());
  }
  return dump_mesh(mesh);
}

CaseReport tell_step(const StudentProgram& program, const ViewOperation& operation,
                     CaseJudgement judgement, const Outcome& outcome) {
  return program.tell(operation.exercise, operation_text(operation), std::move(judgement),
                      outcome);
}

/// Whether something of this kind is there.
bool is_there(const MeshDump& mesh, ElementKind kind, Ref element) {
  const auto lives = [&](const auto& records) {
    return element < records.size() && records[element].live != 0;
  };
  if (kind == ElementKind::kVertex) return lives(mesh.vertices);
  return kind == ElementKind::kEdge ? lives(mesh.edges) : lives(mesh.faces);
}

/// What an operation lacks; empty if it can be done.
std::string trouble_with(const ViewOperation& operation, const MeshDump& mesh) {
  for (const Ref element : operation.picked) {
    if (is_there(mesh, operation.picks, element)) continue;
    const std::string kind = kind_name(operation.picks);
    return "there is no " + kind + " " + element_name(operation.picks, element);
  }
  if (is_for_triangles(operation)) return {};
  return trouble_before(mesh, operation);
}

}  // namespace

MeshSession::MeshSession(StudentProgram& program)
    : program_(program), verbs_(view_verbs(program.assignment())) {}

void MeshSession::open(const std::string& name, const PolygonMesh& mesh,
                       std::vector<std::string> notes) {
  MeshDump first = first_state(mesh);
  name_ = name;
  notes_ = std::move(notes);
  start_ = mesh;
  operations_.clear();
  stopped_.reset();
  states_.clear();
  states_.push_back({std::move(first), {}, {}, std::nullopt});
  position_ = 0;
}

void MeshSession::rebuild() {
  if (!program_.rebuild()) return;
  if (states_.empty()) return;
  std::vector<ViewOperation> again = operations_;
  if (stopped_ && position_ == operations_.size()) again.push_back(stopped_->operation);
  const std::size_t looked_at = std::max<std::size_t>(position_, stopped_ ? again.size() : 0);
  states_.resize(1);
  operations_.clear();
  position_ = 0;
  extend(again);
  position_ = std::min(looked_at, operations_.size());
}

Outcome MeshSession::run(const std::vector<ViewOperation>& operations, std::size_t first_told,
                         bool with_normals) const {
  Case asked;
  asked.exercise = are_for_polygons(verbs_) ? kPolygonViewTask : kViewTask;
  asked.number = 1;
  asked.step_budget = step_budget(start_, operations);
  asked.input = to_wire(
      ViewInput{start_, operations, static_cast<std::uint32_t>(first_told), with_normals});
  return program_.run({asked}).at(0);
}

/// Runs these operations after those that are done.
void MeshSession::extend(const std::vector<ViewOperation>& operations) {
  stopped_.reset();
  if (operations.empty()) return;
  std::vector<ViewOperation> all = operations_;
  all.insert(all.end(), operations.begin(), operations.end());
  const std::size_t done_before = operations_.size();
  const Outcome outcome = run(all, done_before, false);
  try {
    take_steps(operations, outcome);
  } catch (const WireError& error) {
    position_ = operations_.size();
    const std::size_t taken = std::min(position_ - done_before, operations.size() - 1);
    StoppedStep stop{operations[taken], {}, std::nullopt};
    CaseJudgement judgement;
    judgement.verdict = Verdict::kCrashed;
    judgement.note = std::string("what it left behind cannot be read: ") + error.what() +
                     "; does the code write over memory that is not its own?";
    stop.told = tell_step(program_, stop.operation, std::move(judgement), outcome);
    stopped_ = std::move(stop);
  }
}

void MeshSession::take_steps(const std::vector<ViewOperation>& operations,
                             const Outcome& outcome) {
  if (outcome.steps.size() > operations.size()) throw WireError("too many steps");
  for (std::size_t i = 0; i < outcome.steps.size(); ++i) {
    // What was done before may not be a mesh any more since the program was changed.
    if (!trouble_with(operations[i], states_.back().mesh).empty())
      return stop_at(operations[i], outcome);
    take_step(operations[i], outcome, outcome.steps[i]);
  }
  position_ = operations_.size();
  if (outcome.steps.size() < operations.size())
    stop_at(operations[outcome.steps.size()], outcome);
}

void MeshSession::take_step(const ViewOperation& operation, const Outcome& outcome,
                            const std::string& bytes) {
  const MeshDump& before = states_.back().mesh;
  ViewState state;
  CaseJudgement judgement;
  if (are_for_polygons(verbs_)) {
    auto step = from_wire<PolygonViewStep>(bytes);
    judgement = judge_polygon_step(program_.assignment(), before, operation, step);
    if (is_built_anew(operation, before)) state.begun_with = mesh_begun_with(before, operation);
    state.mesh = std::move(step.after);
  } else {
    auto step = from_wire<ViewStep>(bytes);
    judgement = judge_view_step(program_.assignment(), before, operation, step);
    state.mesh = std::move(step.after);
  }
  state.deviation = std::move(judgement.deviation);
  state.told = tell_step(program_, operation, std::move(judgement), outcome);
  operations_.push_back(operation);
  states_.push_back(std::move(state));
}

/// Tells why an operation did not come to its end.
void MeshSession::stop_at(const ViewOperation& operation, const Outcome& outcome) {
  position_ = operations_.size();
  StoppedStep stop{operation, {}, std::nullopt};
  const std::string trouble = trouble_with(operation, states_.back().mesh);
  if (!trouble.empty() || outcome.ending == Ending::kDone) {
    CaseJudgement undone;
    undone.verdict = Verdict::kNotJudged;
    undone.note = trouble.empty() ? "the mesh is broken: it was not done" : trouble;
    stop.told = tell_step(program_, operation, std::move(undone), outcome);
    stopped_ = std::move(stop);
    return;
  }
  stop.told = tell_step(program_, operation,
                        judge_stop(program_.assignment(), start_, operation, outcome), outcome);
  if (!outcome.interrupted.empty()) {
    stop.mesh = are_for_polygons(verbs_) ? from_wire<PolygonViewStep>(outcome.interrupted).after
                                         : from_wire<ViewStep>(outcome.interrupted).after;
  }
  stopped_ = std::move(stop);
}

void MeshSession::apply(const ViewOperation& operation) {
  if (states_.empty()) throw UserError("there is no mesh yet");
  const std::string trouble = trouble_with(operation, states_[position_].mesh);
  if (!trouble.empty()) throw UserError(trouble);
  operations_.resize(position_);
  states_.resize(position_ + 1);
  extend({operation});
}

const MeshDump& MeshSession::mesh_before(std::size_t position) const {
  const std::optional<MeshDump>& anew = states_.at(position).begun_with;
  return anew ? *anew : states_.at(position - 1).mesh;
}

void MeshSession::go_to(std::size_t position) {
  if (position >= states_.size()) throw UserError("there is no such step");
  position_ = position;
  stopped_.reset();
}

std::vector<ViewLevel> MeshSession::levels() const {
  std::vector<ViewLevel> levels{{"level 0", 0}};
  for (std::size_t i = 0; i < position_; ++i) {
    if (subdivides(operations_[i])) {
      levels.push_back({"level " + std::to_string(levels.size()), i});
    }
    levels.back().position = i + 1;
  }
  return levels;
}

std::vector<Point3> MeshSession::normals_by_number(const Normals& asked) const {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<Point3> list;
  std::size_t next = 0;
  for (const VertexRecord& v : states_.at(position_).mesh.vertices) {
    const bool has_one = v.live != 0 && next < asked.normals.size();
    list.push_back(has_one ? asked.normals[next++] : Point3{kNone, kNone, kNone});
  }
  return list;
}

MeshSession::Normals MeshSession::normals() const {
  if (states_.empty()) throw UserError("there is no mesh yet");
  const std::vector<ViewOperation> done(operations_.begin(),
                                        operations_.begin() + static_cast<long>(position_));
  const Outcome outcome = run(done, done.size(), true);
  Normals result;
  const Counts counts = count(states_[position_].mesh);
  if (outcome.ending == Ending::kDone && outcome.steps.size() == counts.vertices) {
    for (const std::string& step : outcome.steps)
      result.normals.push_back(from_wire<Point3>(step));
    result.told.verdict = Verdict::kPassed;
    return result;
  }
  result.told.verdict = Verdict::kCrashed;
  result.told.note = "Vertex::normal did not come to its end for every vertex";
  if (outcome.ending == Ending::kFault) {
    const meshedit::FaultKind kind{outcome.fault_kind};
    result.told.note = outcome.subject + " " + meshedit::describe(kind);
  } else if (outcome.ending == Ending::kLibraryCheck) {
    result.told.note = "Vertex::normal was stopped: " + library_check_finding(outcome).actual;
  } else if (outcome.ending == Ending::kOutOfTime) {
    result.told.note = "Vertex::normal does not come to its end";
  }
  return result;
}

}  // namespace meshgrade

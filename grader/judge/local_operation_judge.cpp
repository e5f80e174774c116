#include "grader/judge/local_operation_judge.h"

#include <algorithm>

#include "grader/base/text.h"
#include "grader/base/wire.h"
#include "grader/cases/local_operation_input.h"
#include "grader/judge/face_match.h"
#include "grader/judge/findings.h"
#include "grader/judge/options.h"
#include "grader/judge/point_compare.h"
#include "grader/operations/course_rules.h"
#include "grader/operations/local_operation_list.h"
#include "grader/operations/picked_element.h"

namespace meshgrade {
namespace {

/// How many faces are named of those that differ.
constexpr std::size_t kMostFaces = 3;

std::string first_of(std::vector<std::string> faces) {
  const std::size_t more = faces.size() > kMostFaces ? faces.size() - kMostFaces : 0;
  faces.resize(faces.size() - more);
  if (more > 0) faces.push_back("and " + std::to_string(more) + " more");
  return faces.empty() ? "no other face" : join(faces, ", ");
}

Picked picked_by(const MeshDump& before, const LocalOperation& operation,
                 const LocalStep& step) {
  Picked picked = corners_of(before, operation.picks, step.picked);
  if (operation.picks_two)
    picked.partner = corners_of(before, operation.picks, step.partner).corners;
  return picked;
}

/// "e3", or "e3 and e7"
std::string picked_text(const LocalOperation& operation, Ref picked, Ref partner) {
  std::string text = element_name(operation.picks, picked);
  if (operation.picks_two) text += " and " + element_name(operation.picks, partner);
  return text;
}

CourseRules rules_of(const ExerciseRubric& rubric) {
  return choose_option(rubric, kRulesOption, rules_choices()) == rules_choices()[0]
             ? CourseRules::kAll
             : CourseRules::kScotty3d2020;
}

/// Judges one operation, from a mesh that keeps all rules.
class LocalStepJudge {
 public:
  LocalStepJudge(const JudgeTask& task, const LocalOperation& operation, const MeshDump& before,
                 const LocalStep& step, std::string where, CaseJudgement& judgement)
      : task_(task),
        operation_(operation),
        before_(before),
        lists_(face_lists_of(before)),
        picked_(picked_by(before, operation, step)),
        answer_(as_asked(rules_of(task.rubric), operation, lists_, picked_,
                         operation.answer(lists_, picked_))),
        step_(step),
        after_(step.after),
        where_(std::move(where)),
        judgement_(judgement),
        broken_(find_broken_rules(after_, may_be_degenerate() ? FaceShape::kDegeneratePolygons
                                                              : FaceShape::kPolygons)) {}

  void judge() {
    if (step_.refused != 0) {
      judge_refusal();
    } else if (answer_.demand == Demand::kRefuse) {
      report_not_refused();
    } else if (answer_.demand == Demand::kOpen) {
      add_broken_rules();
    } else if (is_unchanged()) {
      report("nothing-done", "what is not refused is done", name(), done_text(),
             "the mesh is the same as before, and " + returned_text() + " was returned",
             "does the function return too early? To refuse, return std::nullopt");
    } else {
      judge_result();
    }
    if (!task_.explain || judgement_.findings.empty()) return;
    keep_scene();
    const std::optional<LabelMap> known =
        broken_.empty() ? match_faces(answer_, face_lists_of(after_)) : std::nullopt;
    judgement_.findings[0].ring =
        figure_of_ring(before_, picked_, answer_, after_, known, name());
  }

 private:
  bool may_be_degenerate() const {
    return answer_.demand == Demand::kEither || answer_.demand == Demand::kOpen;
  }

  /// For a viewer.
  void keep_scene() {
    if (after_.halfedges.size() > kMostSceneHalfedges) return;
    const bool has_answer = trouble_of(answer_.after).empty();
    judgement_.scene = {operation_.verb + " " + name(),
                        operation_.picks == ElementKind::kEdge ? step_.picked : kUnsetRef,
                        before_,
                        after_,
                        has_answer ? mesh_of(answer_.after) : before_,
                        FaceShape::kPolygons};
  }

  void report(std::string rule, std::string meaning, std::string element, std::string expected,
              std::string actual, std::string look_at) {
    judgement_.findings.push_back(make_finding(std::move(rule), std::move(meaning), where_,
                                               std::move(element), std::move(expected),
                                               std::move(actual), std::move(look_at)));
  }

  std::string name() const { return picked_text(operation_, step_.picked, step_.partner); }

  std::string returned_text() const { return element_name(operation_.returns, step_.returned); }

  std::string done_text() const {
    return name() + " can be done: " + operation_.verb +
           (operation_.picks_two ? " them" : " it") + ", and return the " +
           kind_name(operation_.returns);
  }

  bool keeps_counts() const { return count(after_) == count(before_); }

  /// The same surface, with the same vertices in the same places.
  bool is_unchanged() const {
    if (!broken_.empty() || !keeps_counts() || moved_vertex() != kUnsetRef) return false;
    Answer same = refuse(lists_, "");
    return match_faces(same, face_lists_of(after_)).has_value();
  }

  /// The first old vertex that is still there and lies elsewhere; kUnsetRef if there is none.
  Ref moved_vertex() const {
    for (Ref v = 0; v < before_.vertices.size() && v < after_.vertices.size(); ++v) {
      const VertexRecord& old = before_.vertices[v];
      const VertexRecord& now = after_.vertices[v];
      if (old.live == 0 || now.live == 0 || old.position == now.position) continue;
      if (is_kept(v)) return v;
    }
    return kUnsetRef;
  }

  /// Whether a vertex has to stay what it is.
  bool is_kept(Ref v) const {
    if (step_.refused != 0 || answer_.demand == Demand::kRefuse) return true;
    return std::any_of(
        answer_.after.faces.begin(), answer_.after.faces.end(),
        [&](const Corners& corners) { return place_of(corners, v).has_value(); });
  }

  void add_broken_rules() {
    for (const RuleBreak& rule_break : broken_)
      judgement_.findings.push_back(to_finding(rule_break, where_));
  }

  void judge_refusal() {
    if (!is_unchanged()) {
      const Ref moved = moved_vertex();
      report("refused-unchanged", "an operation that refuses leaves the mesh as it was", name(),
             "the mesh is the same as before, since std::nullopt was returned",
             !keeps_counts() ? "there are " + counts_text(count(after_)) + " now, not " +
                                   counts_text(count(before_))
             : moved != kUnsetRef ? vertex_name(moved) + " has moved"
                                  : "pointers of the mesh have changed",
             "what is created or set before the last test that returns std::nullopt");
      add_broken_rules();
    } else if (answer_.demand == Demand::kMust) {
      report("refused", "only what would leave no surface is refused", name(), done_text(),
             "std::nullopt was returned",
             "which of the tests at the start says no? Nothing forbids it here");
    }
  }

  void report_not_refused() {
    const bool unchanged = is_unchanged();
    report("not-refused",
           "what would leave no surface is refused, and the mesh stays as it was", name(),
           "std::nullopt is returned: " + answer_.reason,
           unchanged ? returned_text() + " was returned, and the mesh is as it was"
                     : "the mesh was changed, and " + returned_text() + " was returned",
           unchanged ? "the return statement: only std::nullopt says that nothing was done"
                     : "a test at the start: " + answer_.reason);
    if (!unchanged) add_broken_rules();
  }

  void judge_result() {
    // An element that was not deleted breaks rules, too, and says less there.
    const bool is_counted = has_counts();
    if (!is_counted || !broken_.empty()) return add_broken_rules();
    const FaceLists actual = face_lists_of(after_);
    const std::optional<LabelMap> map = match_faces(answer_, actual);
    if (!map) return report_faces(difference(answer_, actual));
    if (!keeps_positions() || !has_new_positions(*map)) return;
    judge_returned(*map);
  }

  /// Where the answer is degenerate, only what lists of faces tell is counted.
  bool has_counts() {
    Counts want = count(after_);
    if (answer_.demand == Demand::kMust) {
      want = count(mesh_of(answer_.after));
    } else {
      want.faces = answer_.after.faces.size();
    }
    if (want == count(after_)) return true;
    report("counts", std::string(rule_meaning("counts")), "the mesh", counts_text(want),
           counts_text(count(after_)), operation_.advice);
    return false;
  }

  void report_faces(const FaceDifference& difference) {
    const char* rule = difference.turned ? "orientation" : "surface";
    report(rule,
           difference.turned ? std::string(rule_meaning(rule))
                             : "the faces are those that the operation gives",
           name(), "faces " + first_of(difference.missing),
           "faces " + first_of(difference.surplus),
           difference.turned ? "the order of next around these faces"
                             : "the .vertex and .next of the half-edges around these faces");
  }

  bool keeps_positions() {
    const Ref v = moved_vertex();
    if (v == kUnsetRef) return true;
    report("position", "no old vertex moves", vertex_name(v),
           point_text(before_.vertices[v].position), point_text(after_.vertices[v].position),
           vertex_name(v) + ".position");
    return false;
  }

  bool has_new_positions(const LabelMap& map) {
    const double allowed = allowed_error();
    for (const auto& [label, v] : map) {
      const Point3& expected = answer_.after.positions[label];
      const Point3& actual = after_.vertices[v].position;
      const double error = distance(expected, actual);
      if (error <= allowed) continue;
      report("new-position",
             "a new vertex, or one that is left of several, lies where the "
             "operation says",
             vertex_name(v), point_text(expected),
             point_text(actual) + ", off by " + number_text(error),
             vertex_name(v) + ".position");
      return false;
    }
    return true;
  }

  /// Relative to the longest distance of corners of the faces around the element.
  double allowed_error() const {
    double size = 0.0;
    for (const Corners& corners : lists_.faces) {
      const bool is_near =
          std::any_of(picked_.corners.begin(), picked_.corners.end(),
                      [&](Label label) { return place_of(corners, label).has_value(); });
      if (!is_near) continue;
      for (Label label : corners) {
        size = std::max(size, distance(lists_.positions[corners[0]], lists_.positions[label]));
      }
    }
    return task_.tolerance * size;
  }

  void judge_returned(const LabelMap& map) {
    std::vector<Corners> expected;
    for (Corners corners : answer_.returned) {
      for (Label& label : corners) {
        const auto found = map.find(label);
        if (found != map.end()) label = found->second;
      }
      expected.push_back(std::move(corners));
    }
    const bool exists = is_there(step_.returned);
    const bool is_right =
        exists && std::any_of(expected.begin(), expected.end(),
                              [&](const Corners& corners) { return is_returned(corners); });
    if (!is_right) return report_returned(expected.at(0), exists);
    judge_anchor(map);
  }

  void report_returned(const Corners& expected, bool exists) {
    const std::string what = std::string("the ") + kind_name(operation_.returns);
    std::string actual = "returned: " + returned_text();
    if (exists)
      actual +=
          ", " + corners_text(corners_of(after_, operation_.returns, step_.returned).corners);
    report("returned", "the function returns what it says", what,
           what + " " + corners_text(expected), actual,
           "the return statement of " + operation_.function);
  }

  bool is_there(Ref element) const {
    if (operation_.returns == ElementKind::kVertex)
      return element < after_.vertices.size() && after_.vertices[element].live != 0;
    if (operation_.returns == ElementKind::kEdge)
      return element < after_.edges.size() && after_.edges[element].live != 0;
    const FaceRecord* face = is_plain(element) ? find_face(after_, element) : nullptr;
    return face != nullptr && face->live != 0;
  }

  bool is_returned(const Corners& expected) const {
    Corners actual = corners_of(after_, operation_.returns, step_.returned).corners;
    if (operation_.returns != ElementKind::kEdge)
      return canonical(actual) == canonical(expected);
    return std::is_permutation(actual.begin(), actual.end(), expected.begin(), expected.end());
  }

  static std::string corners_text(const Corners& corners) {
    std::vector<std::string> names;
    for (Label corner : corners)
      names.push_back(vertex_name(corner));
    return join(names, "-");
  }

  void judge_anchor(const LabelMap& map) {
    if (answer_.anchored_to.empty()) return;
    const Ref v = map.at(answer_.returned.at(0).at(0));
    const Ref h = after_.vertices[v].halfedge;
    const Ref end = after_.halfedges[after_.halfedges[h].twin].vertex;
    if (place_of(answer_.anchored_to, end)) return;
    report("along-edge", "the half-edge of the new vertex lies along the edge that was split",
           vertex_name(v),
           vertex_name(v) + ".halfedge leads to " + vertex_name(answer_.anchored_to[0]) +
               " or " + vertex_name(answer_.anchored_to[1]),
           vertex_name(v) + ".halfedge is " + halfedge_name(h) + ", which leads to " +
               vertex_name(end),
           vertex_name(v) + ".halfedge");
  }

  const JudgeTask& task_;
  const LocalOperation& operation_;
  const MeshDump& before_;
  FaceLists lists_;
  Picked picked_;
  Answer answer_;
  const LocalStep& step_;
  const MeshDump& after_;
  std::string where_;
  CaseJudgement& judgement_;
  std::vector<RuleBreak> broken_;
};

std::string step_text(const LocalOperation& operation, std::size_t steps, std::size_t i,
                      const LocalStep& step) {
  if (steps == 1) return {};
  return "after operation " + std::to_string(i + 1) + " of " + std::to_string(steps) + ": " +
         operation.verb + " " + picked_text(operation, step.picked, step.partner);
}

void judge_local_operations(const JudgeTask& task, CaseJudgement& judgement) {
  const LocalOperation& operation = *find_local_operation(task.asked.exercise);
  const auto input = from_wire<LocalOperationInput>(task.asked.input);
  const std::size_t picks = operation.picks_two ? 2 : 1;
  const std::size_t steps = input.places.size() / picks;
  if (task.outcome.steps.size() > steps) throw WireError("too many steps");
  MeshDump before = built_mesh(input.mesh, input.anchor_turns);
  for (std::size_t i = 0; i < task.outcome.steps.size(); ++i) {
    // After a degenerate answer, lists of faces do not tell what is right.
    if (!trouble_of(face_lists_of(before)).empty()) return;
    auto step = from_wire<LocalStep>(task.outcome.steps[i]);
    for (std::size_t k = 0; k < picks; ++k) {
      const Ref element = find_element(before, operation.picks, input.places[picks * i + k]);
      if (element == kUnsetRef || (k == 0 ? step.picked : step.partner) != element)
        throw WireError("another element");
    }
    judge_local_step(task, operation, before, step, step_text(operation, steps, i, step),
                     judgement);
    if (!judgement.findings.empty()) return;
    before = std::move(step.after);
  }
  require_all_steps(task.outcome, steps);
}

}  // namespace

void judge_local_step(const JudgeTask& task, const LocalOperation& operation,
                      const MeshDump& before, const LocalStep& step, const std::string& where,
                      CaseJudgement& judgement) {
  LocalStepJudge(task, operation, before, step, where, judgement).judge();
  if (!judgement.findings.empty()) judgement.verdict = Verdict::kFailed;
}

ExerciseJudge local_operation_judge(const ExerciseRubric& rubric,
                                    const LocalOperation& operation) {
  refuse_unknown_options(rubric, {kRulesOption});
  rules_of(rubric);  // whether there are such ones
  ExerciseJudge judge;
  judge.functions = {operation.function};
  judge.judge_steps = [](const JudgeTask& task, Conventions& /*conventions*/,
                         CaseJudgement& judgement) { judge_local_operations(task, judgement); };
  return judge;
}

}  // namespace meshgrade

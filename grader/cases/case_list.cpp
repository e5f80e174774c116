#include "grader/cases/case_list.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "grader/base/errors.h"
#include "grader/cases/local_operation_cases.h"
#include "grader/cases/mesh_shapes.h"
#include "grader/cases/own_meshes.h"
#include "grader/files/bezier_file.h"
#include "grader/files/mesh_file.h"
#include "grader/operations/local_operation_list.h"

namespace meshgrade {

#define MESHGRADE_EXERCISE(name)              \
  void make_##name##_cases(CaseMaker& maker); \
  void shrink_##name##_case(CaseMaker& maker, const Case& failed);
#include "exercise_list.inc"
#undef MESHGRADE_EXERCISE

namespace {

struct Makers {
  void (*cases)(CaseMaker&);
  void (*smaller)(CaseMaker&, const Case& failed);
};

const std::map<std::string, Makers>& all_makers() {
  static const std::map<std::string, Makers> table{
#define MESHGRADE_EXERCISE(name) {#name, {make_##name##_cases, shrink_##name##_case}},
#include "exercise_list.inc"
#undef MESHGRADE_EXERCISE
  };
  return table;
}

/// @throws UserError if there is no such exercise
void make_all(const ExerciseRubric& rubric, CaseMaker& maker) {
  if (const LocalOperation* operation = find_local_operation(rubric.name))
    return make_local_operation_cases(maker, *operation);
  const auto found = all_makers().find(rubric.name);
  if (found == all_makers().end()) {
    throw UserError(rubric.place + ": there is no exercise \"" + rubric.name + "\"");
  }
  found->second.cases(maker);
}

std::vector<Case> make_with_seed(std::uint64_t seed, Assignment assignment,
                                 const ExerciseRubric& rubric,
                                 const std::filesystem::path& meshes) {
  assignment.seed = seed;
  CaseMaker cases(assignment, rubric, meshes);
  make_all(rubric, cases);
  add_own_meshes(cases, rubric, false);
  return cases.take();
}

/// What a case of an exercise calls unless it says so itself.
std::vector<std::string> main_function(const std::string& exercise) {
  static const std::map<std::string, std::string> functions{
      {"bezier_curve", "BezierCurve::evaluateStep"},
      {"vertex_normal", "Vertex::normal"},
      {"edge_flip", "HalfedgeMesh::flipEdge"},
      {"edge_split", "HalfedgeMesh::splitEdge"},
      {"loop_subdivision", "MeshResampler::upsample"}};
  const auto found = functions.find(exercise);
  if (found == functions.end()) return {};
  return {found->second};
}

/// A group that waits for a mesh which is not handed out.
bool lacks_a_mesh(const Group& group) {
  return std::any_of(group.meshes.begin(), group.meshes.end(),
                     [](const OwnMesh& mesh) { return !mesh.is_there; });
}

/// Adds what another seed draws; what it does not draw is there already. The numbers go on.
void add_hidden(std::vector<Case> drawn, std::vector<Case>& made) {
  std::set<std::pair<std::string, std::string>> known;
  std::map<std::string, int> last;
  for (const Case& c : made) {
    known.insert({c.group, c.input});
    last[c.group] = c.number;
  }
  for (Case& c : drawn) {
    if (!known.insert({c.group, c.input}).second) continue;
    c.number = ++last[c.group];
    c.hidden = true;
    made.push_back(std::move(c));
  }
}

}  // namespace

PolygonMesh CaseMaker::mesh(const std::string& file) const {
  const auto known = read_.find(file);
  if (known != read_.end()) return known->second;
  return read_[file] = in_build_order(read_mesh(meshes_ / file).mesh);
}

std::vector<ControlNet> CaseMaker::patches(const std::string& file) const {
  return read_bez(meshes_ / file);
}

std::vector<Point2> CaseMaker::curve(const std::string& file) const {
  return read_bzc(meshes_ / file);
}

void CaseMaker::add_packed(const std::string& group, const std::string& title,
                           std::uint64_t step_budget, std::string input, bool fresh,
                           std::vector<std::string> calls) {
  const auto named = [&](const Group& g) { return g.name == group; };
  if (std::none_of(rubric_.groups.begin(), rubric_.groups.end(), named)) return;
  if (calls.empty()) calls = main_function(rubric_.name);
  for (std::string& function : calls)
    function = rubric_.by_other_names(std::move(function));
  const auto number = std::count_if(cases_.begin(), cases_.end(),
                                    [&](const Case& c) { return c.group == group; });
  cases_.push_back({rubric_.name, group, static_cast<int>(number) + 1, title, std::move(input),
                    step_budget, fresh, false, std::move(calls)});
}

std::vector<Case> make_cases(const Assignment& assignment, const ExerciseRubric& rubric,
                             const std::filesystem::path& meshes) {
  std::vector<Case> made = make_with_seed(assignment.seed, assignment, rubric, meshes);
  if (assignment.hidden && assignment.hidden->seed) {
    add_hidden(make_with_seed(*assignment.hidden->seed, assignment, rubric, meshes), made);
  }
  CaseMaker hidden(assignment, rubric, meshes);
  add_own_meshes(hidden, rubric, true);
  add_hidden(hidden.take(), made);
  for (const Group& group : rubric.groups) {
    if (lacks_a_mesh(group)) continue;
    const auto in_group = [&](const Case& c) { return c.group == group.name; };
    if (std::none_of(made.begin(), made.end(), in_group)) {
      throw UserError(group.place + ": " + rubric.name + " has no cases for a group \"" +
                      group.name + "\"");
    }
  }
  return made;
}

std::vector<Case> make_smaller_cases(const Assignment& assignment, const ExerciseRubric& rubric,
                                     const std::filesystem::path& meshes, const Case& failed) {
  CaseMaker cases(assignment, rubric, meshes);
  const auto found = all_makers().find(rubric.name);
  if (found != all_makers().end()) found->second.smaller(cases, failed);
  std::vector<Case> smaller = cases.take();
  for (Case& c : smaller) {
    c.number = failed.number;
    c.hidden = failed.hidden;
    c.fresh = failed.fresh;
  }
  return smaller;
}

Case find_case(const Assignment& assignment, const std::filesystem::path& meshes,
               const std::string& id) {
  const ExerciseRubric* rubric = assignment.find(id.substr(0, id.find(':')));
  if (rubric != nullptr) {
    for (Case& c : make_cases(assignment, *rubric, meshes)) {
      if (c.id() == id) return c;
    }
  }
  throw UserError("there is no case \"" + id +
                  "\"; write it as in the report, like "
                  "edge_split:basic/3");
}

}  // namespace meshgrade

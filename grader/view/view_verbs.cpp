#include "grader/view/view_verbs.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "grader/base/errors.h"
#include "grader/base/text.h"
#include "grader/operations/local_operation_list.h"

namespace meshgrade {
namespace {

/// Letters that mean something in the viewer of polygons. An upper-case one is that with Shift.
constexpr const char* kTakenLetters = "adhintpvwyzZ";

const std::vector<ViewVerb>& triangle_verbs() {
  static const std::vector<ViewVerb> verbs{
      {"edge_flip", "flip", ElementKind::kEdge, 1, false, "f"},
      {"edge_split", "split", ElementKind::kEdge, 1, false, "s"},
      {"loop_subdivision", "subdivide", ElementKind::kEdge, 0, true, "ul"}};
  return verbs;
}

/// What is known of exercises about the whole mesh whose functions the worker can call one
/// after the other.
const std::vector<ViewVerb>& whole_mesh_verbs() {
  static const std::vector<ViewVerb> verbs{
      {"triangulation", "triangulate", ElementKind::kFace, 0, false, ""},
      {"linear_subdivision", "linear", ElementKind::kFace, 0, true, ""},
      {"catmull_clark", "catmull-clark", ElementKind::kFace, 0, true, ""},
      {"loop_refinement", "loop", ElementKind::kFace, 0, true, ""}};
  return verbs;
}

std::string first_word(const std::string& text) {
  return text.substr(0, text.find(' '));
}

/// No exercise if there is no verb for it.
ViewVerb verb_for(const std::string& exercise) {
  if (const LocalOperation* operation = find_local_operation(exercise)) {
    return {exercise,
            first_word(operation->verb),
            operation->picks,
            operation->picks_two ? 2U : 1U,
            false,
            ""};
  }
  for (const auto* verbs : {&triangle_verbs(), &whole_mesh_verbs()}) {
    const auto found = std::find_if(verbs->begin(), verbs->end(), [&](const ViewVerb& verb) {
      return verb.exercise == exercise;
    });
    if (found != verbs->end()) return *found;
  }
  return {};
}

bool is_triangle_verb(const std::string& exercise) {
  const auto& verbs = triangle_verbs();
  return std::any_of(verbs.begin(), verbs.end(),
                     [&](const ViewVerb& known) { return known.exercise == exercise; });
}

/// The first letter of a word that is free, or free with Shift; takes it. Empty if there is
/// none.
std::string take_key(const std::string& word, std::set<char>& taken) {
  for (const char letter : word) {
    if (std::isalpha(static_cast<unsigned char>(letter)) == 0) continue;
    const char shifted = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    for (const char key : {letter, shifted}) {
      if (taken.insert(key).second) return std::string(1, key);
    }
  }
  return {};
}

void give_keys(std::vector<ViewVerb>& verbs) {
  const std::string letters = kTakenLetters;
  std::set<char> taken(letters.begin(), letters.end());
  for (ViewVerb& verb : verbs) {
    const auto same = std::find_if(verbs.begin(), verbs.end(), [&](const ViewVerb& other) {
      return other.word == verb.word;
    });
    verb.keys = same->keys.empty() ? take_key(verb.word, taken) : same->keys;
  }
}

}  // namespace

std::vector<ViewVerb> view_verbs(const Assignment& assignment) {
  std::vector<ViewVerb> verbs;
  for (const ExerciseRubric& rubric : assignment.exercises) {
    ViewVerb verb = verb_for(rubric.name);
    if (!verb.exercise.empty() && !is_triangle_verb(verb.exercise))
      verbs.push_back(std::move(verb));
  }
  if (verbs.empty()) return triangle_verbs();
  give_keys(verbs);
  return verbs;
}

bool is_for_triangles(const ViewOperation& operation) {
  return is_triangle_verb(operation.exercise);
}

bool are_for_polygons(const std::vector<ViewVerb>& verbs) {
  return !verbs.empty() && !is_triangle_verb(verbs[0].exercise);
}

FaceShape faces_of(const std::vector<ViewVerb>& verbs) {
  return are_for_polygons(verbs) ? FaceShape::kDegeneratePolygons : FaceShape::kTriangles;
}

bool subdivides(const ViewOperation& operation) {
  return verb_for(operation.exercise).subdivides;
}

std::string operation_text(const ViewOperation& operation) {
  std::string text = verb_for(operation.exercise).word;
  for (const Ref element : operation.picked)
    text += " " + element_name(operation.picks, element);
  return text;
}

const ViewVerb* find_verb(const std::vector<ViewVerb>& verbs, const std::string& word,
                          ElementKind kind) {
  const auto found = std::find_if(verbs.begin(), verbs.end(), [&](const ViewVerb& verb) {
    return verb.word == word && (verb.picked == 0 || verb.picks == kind);
  });
  return found == verbs.end() ? nullptr : &*found;
}

std::string picked_by_word(const std::vector<ViewVerb>& verbs, const std::string& word) {
  std::vector<std::string> kinds;
  for (const ViewVerb& verb : verbs) {
    if (verb.word == word && verb.picked > 0) kinds.emplace_back(kind_name(verb.picks));
  }
  return join(kinds, " or ");
}

}  // namespace meshgrade

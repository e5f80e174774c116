#pragma once

// What the viewer can do with a mesh: the functions of the exercises, by a verb each.

#include <string>
#include <vector>

#include "grader/assignment/assignment.h"
#include "grader/cases/view_input.h"
#include "grader/mesh/mesh_rules.h"

namespace meshgrade {

/// A function of an exercise. Several may have one verb, each for another kind of element.
struct ViewVerb {
  std::string exercise;  ///< "edge_collapse"
  std::string word;      ///< "collapse"
  ElementKind picks = ElementKind::kEdge;
  std::size_t picked = 0;   ///< how many elements are picked; 0: it works on the whole mesh
  bool subdivides = false;  ///< what it makes is the next level
  /// How it is called in the page: "c"; an upper-case letter with Shift. Several letters: any.
  std::string keys;
};

/// The verbs of an assignment about polygons, in the order of its exercises: those that are
/// about one operation, and the known ones about the whole mesh. Of any other assignment the
/// three of meshes of triangles, whatever it gives points for.
///
/// Keys are given by the words: the first letter of the word that no verb before has and that
/// means nothing else in the viewer, or that letter with Shift.
std::vector<ViewVerb> view_verbs(const Assignment& assignment);

/// Whether an operation is one of the three on meshes of triangles.
bool is_for_triangles(const ViewOperation& operation);

/// Whether these verbs are about meshes of polygons.
bool are_for_polygons(const std::vector<ViewVerb>& verbs);

/// What faces may be in what such verbs work on.
FaceShape faces_of(const std::vector<ViewVerb>& verbs);

/// Whether an operation makes the next level of a subdivision.
bool subdivides(const ViewOperation& operation);

/// "flip e5", "weld e3 e7", "subdivide"
std::string operation_text(const ViewOperation& operation);

/// The verb with this word that picks elements of this kind; nullptr if there is none. A word
/// of the whole mesh picks none: any kind will do.
const ViewVerb* find_verb(const std::vector<ViewVerb>& verbs, const std::string& word,
                          ElementKind kind);

/// "edge", "edge or face": what verbs with this word pick; empty if there is no such word, or
/// it is about the whole mesh.
std::string picked_by_word(const std::vector<ViewVerb>& verbs, const std::string& word);

}  // namespace meshgrade

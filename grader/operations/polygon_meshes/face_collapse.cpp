#include "grader/operations/contraction.h"

namespace meshgrade {
namespace {

Answer face_collapse_answer(const FaceLists& before, const Picked& picked) {
  return contract(before, picked.corners,
                  {"it touches the boundary in more than one place",
                   "another face has two of its corners that none of its sides joins there",
                   "a corner of a triangle beside it would have one edge only"});
}

}  // namespace

LocalOperation face_collapse_operation() {
  return {"face_collapse",
          "PolyMesh::collapseFace",
          "collapse",
          ElementKind::kFace,
          ElementKind::kVertex,
          face_collapse_answer,
          "of n corners one is left, and all n sides go; with each triangle beside them one "
          "edge and one face more"};
}

}  // namespace meshgrade
